#include "uq/marginals/shapes/weibull.hpp"

#include "uq/marginals/shapes/shape_checks.hpp"

#include <boost/math/special_functions/gamma.hpp>
#include <boost/math/tools/roots.hpp>

#include <cmath>
#include <cstdint>
#include <limits>

namespace uq {
namespace {

/// ln(1 + cov^2) of a Weibull of shape 1 / e.
double weibull_spread(double e)
{
    return std::log1p(boost::math::tgamma1pm1(2.0 * e)) -
           2.0 * std::log1p(boost::math::tgamma1pm1(e));
}

} // namespace

void check(const Weibull& s)
{
    require_positive("weibull: shape", s.shape);
    require_positive("weibull: scale", s.scale);
}

Weibull weibull_from_moments(double mean, double cov)
{
    require_positive_moments("weibull", mean, cov);
    constexpr double kSmallest = 1e-3, kLargest = 100.0;
    if (!(cov >= kSmallest && cov <= kLargest))
        refuse("weibull: coefficient of variation", cov, "in [0.001, 100]");
    const double target = std::log1p(cov * cov);
    std::uintmax_t steps = 200;
    const auto bracket = boost::math::tools::toms748_solve(
        [target](double e) { return weibull_spread(e) - target; }, 0.1 * kSmallest, 20.0,
        boost::math::tools::eps_tolerance<double>(52), steps);
    const double e = 0.5 * (bracket.first + bracket.second);
    return {1.0 / e, mean / (1.0 + boost::math::tgamma1pm1(e))};
}

Range support(const Weibull&) { return {0.0, std::numeric_limits<double>::infinity()}; }
double density(const Weibull& s, double x)
{
    const double t = x / s.scale;
    return s.shape / s.scale * std::pow(t, s.shape - 1.0) * std::exp(-std::pow(t, s.shape));
}
double lower_tail(const Weibull& s, double x)
{
    return x > 0.0 ? -std::expm1(-std::pow(x / s.scale, s.shape)) : 0.0;
}
double upper_tail(const Weibull& s, double x)
{
    return x > 0.0 ? std::exp(-std::pow(x / s.scale, s.shape)) : 1.0;
}
double at_lower(const Weibull& s, double p)
{
    return s.scale * std::pow(-std::log1p(-p), 1.0 / s.shape);
}
double at_upper(const Weibull& s, double q)
{
    return s.scale * std::pow(-std::log(q), 1.0 / s.shape);
}
MeanSd mean_sd(const Weibull& s)
{
    const double e = 1.0 / s.shape;
    const double g1 = boost::math::tgamma1pm1(e), g2 = boost::math::tgamma1pm1(2.0 * e);
    const double mean = s.scale * (1.0 + g1);
    return {mean, mean * std::sqrt(std::expm1(std::log1p(g2) - 2.0 * std::log1p(g1)))};
}

std::span<const ShapeForm<Weibull>> forms(const Weibull*)
{
    static constexpr ShapeForm<Weibull> all[] = {
        {{{{"mean"}, {"cov", true}}},
         [](const double* p) { return weibull_from_moments(p[0], p[1]); }},
        {{{{"mean"}, {"sd"}}},
         [](const double* p) { return weibull_from_moments(p[0], p[1] / std::abs(p[0])); }},
        {{{{"shape", true}, {"scale"}}},
         [](const double* p) {
             return Weibull{p[0], p[1]};
         }},
    };
    return all;
}

} // namespace uq
