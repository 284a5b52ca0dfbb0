#include "fragility/laws/standard_law.hpp"

#include "core/fit_factors.hpp"
#include "core/normal.hpp"

#include <cmath>
#include <numbers>

namespace fragility {
namespace {

constexpr double kRoot2 = std::numbers::sqrt2;
constexpr double kLogRoot2Pi = 0.91893853320467274178;
/// Narrower than this, a difference of two tails has lost too many digits.
constexpr double kNarrow = 1e-3;
/// Further out, erfc comes near its underflow.
constexpr double kFar = 25.0;

double log_upper_tail(double z)
{
    if (z < kFar) return std::log(0.5 * std::erfc(z / kRoot2));
    const double r = 1.0 / (z * z); // Abramowitz and Stegun 26.2.12
    const double series =
        r * (-1.0 + r * (3.0 + r * (-15.0 + r * (105.0 + r * (-945.0 + r * 10395.0)))));
    return -0.5 * z * z - kLogRoot2Pi - std::log(z) + std::log1p(series);
}

/// d2 of ln S is -hazard (hazard - z); far out the bracket is 1/z.
double hazard_excess(double z, double hazard)
{
    if (z < kFar) return hazard - z;
    const double r = 1.0 / (z * z);
    return (1.0 + r * (-2.0 + r * (10.0 + r * -74.0))) / z;
}

/// ln h + ln f(m) + ln of 1 + h^2/24 f''/f: what is left out is of the order h^4.
/// @param f ln f at the middle; @param q f''/f there with its derivatives
LogBetween narrow(const LogTerm& f, const LogTerm& q, double h)
{
    const double k = h * h / 24.0;
    return {std::log(h) + f.value + k * q.value,
            f.d1 + k * q.d1,
            1.0 / h + h / 12.0 * q.value,
            f.d2 + k * q.d2,
            h / 12.0 * q.d1,
            -1.0 / (h * h) + q.value / 12.0};
}

/// @param a, b  ln f at the lower and upper end; @param value ln of the probability between
LogBetween wide(const LogTerm& a, const LogTerm& b, double value)
{
    const double fa = std::exp(a.value - value);
    const double fb = std::exp(b.value - value);
    const double ga = fa * a.d1; // f' / P
    const double gb = fb * b.d1;
    const double m = fb - fa;
    const double h = 0.5 * (fb + fa);
    return {value, m, h, gb - ga - m * m, 0.5 * (gb + ga) - m * h, 0.25 * (gb - ga) - h * h};
}

double log_between_normal(double lo, double hi)
{
    if (hi < 0.0) return log_between_normal(-hi, -lo);
    if (lo > 0.0) {
        const double tail = log_upper_tail(lo);
        return tail + std::log(-std::expm1(log_upper_tail(hi) - tail));
    }
    return std::log(0.5 * (std::erf(hi / kRoot2) - std::erf(lo / kRoot2)));
}

} // namespace

LogTerm StandardNormal::log_density(double z) { return {-0.5 * z * z - kLogRoot2Pi, -z, -1.0}; }

LogTerm StandardNormal::log_survival(double z)
{
    const double value = log_upper_tail(z);
    const double hazard =
        z < kFar ? std::exp(-0.5 * z * z - kLogRoot2Pi - value) : z + hazard_excess(z, 0.0);
    return {value, -hazard, -hazard * hazard_excess(z, hazard)};
}

LogTerm StandardNormal::log_cdf(double z)
{
    const LogTerm t = log_survival(-z);
    return {t.value, -t.d1, t.d2};
}

LogBetween StandardNormal::log_between(double m, double h)
{
    if (h < kNarrow) return narrow(log_density(m), {m * m - 1.0, 2.0 * m, 2.0}, h);
    const double lo = m - 0.5 * h;
    const double hi = m + 0.5 * h;
    return wide(log_density(lo), log_density(hi), log_between_normal(lo, hi));
}

double StandardNormal::cdf(double z) { return core::normal_cdf(z); }
double StandardNormal::survival(double z) { return core::normal_survival(z); }
double StandardNormal::quantile(double p) { return core::normal_quantile_by_erf(p); }

LogTerm SmallestExtreme::log_density(double z)
{
    const double e = std::exp(z);
    return {z - e, 1.0 - e, -e};
}

LogTerm SmallestExtreme::log_survival(double z)
{
    const double e = std::exp(z);
    return {-e, -e, -e};
}

LogTerm SmallestExtreme::log_cdf(double z)
{
    const double e = std::exp(z);
    const double p = -std::expm1(-e);
    const double r = e < 1e-300 ? 1.0 : e * std::exp(-e) / p; // f / F
    return {e < 1e-300 ? z : std::log(p), r, r * (1.0 - e - r)};
}

LogBetween SmallestExtreme::log_between(double m, double h)
{
    if (h < kNarrow) {
        const double e = std::exp(m);
        return narrow(log_density(m),
                      {1.0 + e * (e - 3.0), e * (2.0 * e - 3.0), e * (4.0 * e - 3.0)}, h);
    }
    const double lo = m - 0.5 * h;
    const double hi = m + 0.5 * h;
    const double e = std::exp(lo);
    return wide(log_density(lo), log_density(hi),
                -e + std::log(-std::expm1(-e * std::expm1(h))));
}

double SmallestExtreme::cdf(double z) { return -std::expm1(-std::exp(z)); }
double SmallestExtreme::survival(double z) { return std::exp(-std::exp(z)); }
double SmallestExtreme::quantile(double p) { return std::log(-std::log1p(-p)); }

LogTerm StandardLogistic::log_survival(double z)
{
    const double p = cdf(z);
    const double value = z > 0.0 ? -z - std::log1p(std::exp(-z)) : -std::log1p(std::exp(z));
    return {value, -p, -p * cdf(-z)};
}

LogTerm StandardLogistic::log_cdf(double z)
{
    const LogTerm t = log_survival(-z);
    return {t.value, -t.d1, t.d2};
}

double StandardLogistic::cdf(double z)
{
    const double e = std::exp(-std::abs(z));
    return z > 0.0 ? 1.0 / (1.0 + e) : e / (1.0 + e);
}

} // namespace fragility
