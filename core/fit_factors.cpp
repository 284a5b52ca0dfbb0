#include "core/fit_factors.hpp"

#include "core/critical.hpp"

#include <boost/math/distributions/students_t.hpp>
#include <boost/math/special_functions/erf.hpp>

#include <numbers>

namespace core {
namespace {

using Plain = boost::math::policies::policy<boost::math::policies::promote_double<false>>;

} // namespace

double normal_quantile_by_erf(double p)
{
    constexpr double kRoot2 = std::numbers::sqrt2;
    return p < 0.5 ? -kRoot2 * boost::math::erfc_inv(2.0 * p, Plain())
                   : kRoot2 * boost::math::erf_inv(2.0 * p - 1.0, Plain());
}

double fit_normal_factor(double confidence)
{
    check_confidence(confidence);
    return normal_quantile_by_erf(0.5 + 0.5 * confidence);
}

double fit_student_factor(double confidence, double freedom)
{
    check_confidence(confidence);
    return boost::math::quantile(boost::math::students_t(freedom), 0.5 + 0.5 * confidence);
}

} // namespace core
