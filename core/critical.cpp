#include "core/critical.hpp"

#include "core/boost_quantiles.hpp"
#include "core/normal.hpp"

#include <stdexcept>
#include <string>

namespace core {

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

} // namespace core
