#include "uq/marginals/shapes/lognormal.hpp"

#include "core/normal.hpp"
#include "uq/marginals/shapes/normal.hpp"
#include "uq/marginals/shapes/shape_checks.hpp"

#include <cmath>
#include <limits>

namespace uq {
namespace {

Normal of_log(const Lognormal& s) { return {s.mu_log, s.sigma_log}; }

} // namespace

void check(const Lognormal& s)
{
    require_finite("lognormal: mu_log", s.mu_log);
    require_positive("lognormal: sigma_log", s.sigma_log);
}

Lognormal lognormal_from_moments(double mean, double cov)
{
    require_positive_moments("lognormal", mean, cov);
    const double variance = std::log1p(cov * cov);
    return {std::log(mean) - 0.5 * variance, std::sqrt(variance)};
}

Range support(const Lognormal&) { return {0.0, std::numeric_limits<double>::infinity()}; }
double density(const Lognormal& s, double x)
{
    if (!(x > 0.0)) return 0.0;
    return core::normal_density((std::log(x) - s.mu_log) / s.sigma_log) / (s.sigma_log * x);
}
double lower_tail(const Lognormal& s, double x)
{
    return x > 0.0 ? lower_tail(of_log(s), std::log(x)) : 0.0;
}
double upper_tail(const Lognormal& s, double x)
{
    return x > 0.0 ? upper_tail(of_log(s), std::log(x)) : 1.0;
}
double at_lower(const Lognormal& s, double p) { return std::exp(at_lower(of_log(s), p)); }
double at_upper(const Lognormal& s, double q) { return std::exp(at_upper(of_log(s), q)); }
MeanSd mean_sd(const Lognormal& s)
{
    const double variance = s.sigma_log * s.sigma_log;
    const double mean = std::exp(s.mu_log + 0.5 * variance);
    return {mean, mean * std::sqrt(std::expm1(variance))};
}

std::span<const ShapeForm<Lognormal>> forms(const Lognormal*)
{
    static constexpr ShapeForm<Lognormal> all[] = {
        {{{{"mean"}, {"cov", true}}},
         [](const double* p) { return lognormal_from_moments(p[0], p[1]); }},
        {{{{"mean"}, {"sd"}}},
         [](const double* p) { return lognormal_from_moments(p[0], p[1] / std::abs(p[0])); }},
        {{{{"median"}, {"sigma_log", true}}},
         [](const double* p) {
             return Lognormal{std::log(p[0]), p[1]};
         }},
    };
    return all;
}

} // namespace uq
