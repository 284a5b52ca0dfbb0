#include "uq/marginals/shapes/gumbel.hpp"

#include "uq/marginals/shapes/shape_checks.hpp"

#include <cmath>
#include <limits>
#include <numbers>

namespace uq {

void check(const Gumbel& s)
{
    require_finite("gumbel: location", s.location);
    require_positive("gumbel: scale", s.scale);
}

Gumbel gumbel_from_moments(double mean, double cov)
{
    require_moments("gumbel", mean, cov);
    const double scale = cov * std::abs(mean) * (std::sqrt(6.0) / std::numbers::pi);
    return {mean - std::numbers::egamma * scale, scale};
}

Range support(const Gumbel&)
{
    return {-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
}
double density(const Gumbel& s, double x)
{
    const double t = (x - s.location) / s.scale;
    return std::exp(-t - std::exp(-t)) / s.scale;
}
double lower_tail(const Gumbel& s, double x)
{
    return std::exp(-std::exp(-(x - s.location) / s.scale));
}
double upper_tail(const Gumbel& s, double x)
{
    return -std::expm1(-std::exp(-(x - s.location) / s.scale));
}
double at_lower(const Gumbel& s, double p)
{
    return s.location - s.scale * std::log(-std::log(p));
}
double at_upper(const Gumbel& s, double q)
{
    return s.location - s.scale * std::log(-std::log1p(-q));
}
MeanSd mean_sd(const Gumbel& s)
{
    return {s.location + std::numbers::egamma * s.scale,
            s.scale * (std::numbers::pi / std::sqrt(6.0))};
}

std::span<const ShapeForm<Gumbel>> forms(const Gumbel*)
{
    static constexpr ShapeForm<Gumbel> all[] = {
        {{{{"mean"}, {"cov", true}}},
         [](const double* p) { return gumbel_from_moments(p[0], p[1]); }},
        {{{{"mean"}, {"sd"}}},
         [](const double* p) { return gumbel_from_moments(p[0], p[1] / std::abs(p[0])); }},
    };
    return all;
}

} // namespace uq
