#include "uq/marginals/shapes/normal.hpp"

#include "core/normal.hpp"
#include "uq/marginals/shapes/shape_checks.hpp"

#include <gsl/gsl_cdf.h>

#include <cmath>
#include <limits>

namespace uq {

void check(const Normal& s)
{
    require_finite("normal: mean", s.mean);
    require_positive("normal: sd", s.sd);
}

Normal normal_from_moments(double mean, double cov)
{
    require_moments("normal", mean, cov);
    return {mean, cov * std::abs(mean)};
}

Range support(const Normal&)
{
    return {-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
}
double density(const Normal& s, double x)
{
    return core::normal_density((x - s.mean) / s.sd) / s.sd;
}
// Tails by GSL: Cody 1969.
double lower_tail(const Normal& s, double x)
{
    return gsl_cdf_ugaussian_P((x - s.mean) / s.sd);
}
double upper_tail(const Normal& s, double x)
{
    return gsl_cdf_ugaussian_Q((x - s.mean) / s.sd);
}
double at_lower(const Normal& s, double p) { return s.mean + s.sd * core::normal_quantile(p); }
double at_upper(const Normal& s, double q)
{
    return s.mean + s.sd * core::upper_normal_quantile(q);
}
MeanSd mean_sd(const Normal& s) { return {s.mean, s.sd}; }

std::span<const ShapeForm<Normal>> forms(const Normal*)
{
    static constexpr ShapeForm<Normal> all[] = {
        {{{{"mean"}, {"cov", true}}},
         [](const double* p) { return normal_from_moments(p[0], p[1]); }},
        {{{{"mean"}, {"sd"}}},
         [](const double* p) {
             return Normal{p[0], p[1]};
         }},
    };
    return all;
}

} // namespace uq
