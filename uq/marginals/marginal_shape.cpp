#include "uq/marginals/marginal_shape.hpp"

#include "uq/marginals/normal_quantile.hpp"

#include <gsl/gsl_cdf.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace uq::shape {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

double normal_density(double z)
{
    return std::exp(-0.5 * z * z) * (0.5 * std::numbers::inv_sqrtpi * std::numbers::sqrt2);
}

/// P(X <= mode)
double rising_share(const Triangular& s) { return (s.mode - s.lower) / (s.upper - s.lower); }

double rising(const Triangular& s, double p)
{
    return s.lower + std::sqrt(p * (s.upper - s.lower)) * std::sqrt(s.mode - s.lower);
}

double falling(const Triangular& s, double q)
{
    return s.upper - std::sqrt(q * (s.upper - s.lower)) * std::sqrt(s.upper - s.mode);
}

} // namespace

// Normal. GSL for the tails: Cody 1969.

Range support(const Normal&) { return {-kInfinity, kInfinity}; }
double density(const Normal& s, double x) { return normal_density((x - s.mean) / s.sd) / s.sd; }
double lower_tail(const Normal& s, double x)
{
    return gsl_cdf_ugaussian_P((x - s.mean) / s.sd);
}
double upper_tail(const Normal& s, double x)
{
    return gsl_cdf_ugaussian_Q((x - s.mean) / s.sd);
}
double at_lower(const Normal& s, double p) { return s.mean + s.sd * normal_quantile(p); }
double at_upper(const Normal& s, double q) { return s.mean + s.sd * upper_normal_quantile(q); }

// Lognormal: the normal of ln x.

Range support(const Lognormal&) { return {0.0, kInfinity}; }
double density(const Lognormal& s, double x)
{
    if (!(x > 0.0)) return 0.0;
    return normal_density((std::log(x) - s.mu_log) / s.sigma_log) / (s.sigma_log * x);
}
double lower_tail(const Lognormal& s, double x)
{
    return x > 0.0 ? lower_tail(Normal{s.mu_log, s.sigma_log}, std::log(x)) : 0.0;
}
double upper_tail(const Lognormal& s, double x)
{
    return x > 0.0 ? upper_tail(Normal{s.mu_log, s.sigma_log}, std::log(x)) : 1.0;
}
double at_lower(const Lognormal& s, double p)
{
    return std::exp(at_lower(Normal{s.mu_log, s.sigma_log}, p));
}
double at_upper(const Lognormal& s, double q)
{
    return std::exp(at_upper(Normal{s.mu_log, s.sigma_log}, q));
}

// Uniform.

Range support(const Uniform& s) { return {s.lower, s.upper}; }
double density(const Uniform& s, double) { return 1.0 / (s.upper - s.lower); }
double lower_tail(const Uniform& s, double x)
{
    if (x <= s.lower) return 0.0;
    return x >= s.upper ? 1.0 : (x - s.lower) / (s.upper - s.lower);
}
double upper_tail(const Uniform& s, double x)
{
    if (x <= s.lower) return 1.0;
    return x >= s.upper ? 0.0 : (s.upper - x) / (s.upper - s.lower);
}
double at_lower(const Uniform& s, double p) { return s.lower + p * (s.upper - s.lower); }
double at_upper(const Uniform& s, double q) { return s.upper - q * (s.upper - s.lower); }

// Triangular: squares of the distance to the ends, on either side of the mode.

Range support(const Triangular& s) { return {s.lower, s.upper}; }
double density(const Triangular& s, double x)
{
    const double height = 2.0 / (s.upper - s.lower);
    if (x == s.mode) return height;
    return x < s.mode ? height * ((x - s.lower) / (s.mode - s.lower))
                      : height * ((s.upper - x) / (s.upper - s.mode));
}
double lower_tail(const Triangular& s, double x)
{
    if (x <= s.lower) return 0.0;
    if (x > s.mode) return 1.0 - upper_tail(s, x);
    return (x - s.lower) / (s.upper - s.lower) * ((x - s.lower) / (s.mode - s.lower));
}
double upper_tail(const Triangular& s, double x)
{
    if (x >= s.upper) return 0.0;
    if (x <= s.mode) return 1.0 - lower_tail(s, x);
    return (s.upper - x) / (s.upper - s.lower) * ((s.upper - x) / (s.upper - s.mode));
}
double at_lower(const Triangular& s, double p)
{
    return p <= rising_share(s) ? rising(s, p) : falling(s, 1.0 - p);
}
double at_upper(const Triangular& s, double q)
{
    return q < 1.0 - rising_share(s) ? falling(s, q) : rising(s, 1.0 - q);
}

// Weibull of minima: S = exp(-(x / scale)^shape).

Range support(const Weibull&) { return {0.0, kInfinity}; }
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

// Gumbel of maxima: F = exp(-exp(-(x - location) / scale)).

Range support(const Gumbel&) { return {-kInfinity, kInfinity}; }
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

} // namespace uq::shape
