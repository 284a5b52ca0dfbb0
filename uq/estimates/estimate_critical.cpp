#include "uq/estimates/estimate_critical.hpp"

#include "uq/marginals/boost_quantiles.hpp"
#include "uq/marginals/normal_quantile.hpp"

#include <stdexcept>
#include <string>

namespace uq {

void check_confidence(double confidence)
{
    if (!(confidence > 0.0 && confidence < 1.0))
        throw std::invalid_argument("confidence is " + std::to_string(confidence) +
                                    ", must be in (0, 1)");
}

double normal_factor(double confidence)
{
    check_confidence(confidence);
    return upper_normal_quantile(0.5 * (1.0 - confidence));
}

double student_factor(double confidence, double freedom)
{
    check_confidence(confidence);
    if (!(freedom > 0.0)) throw std::invalid_argument("degrees of freedom must be > 0");
    return upper_student_quantile(freedom, 0.5 * (1.0 - confidence));
}

} // namespace uq
