#include "fragility/intensity/ida.hpp"

#include "core/normal.hpp"

#include <cmath>
#include <stdexcept>

namespace fragility {
namespace {

/// (1 - Phi(z)) / phi(z) within 1e-10, relative, for z >= 0: Mills' ratio.
double tail_ratio(double z)
{
    constexpr double kFar = 25.0; // further out, erfc comes near its underflow
    if (z < kFar) return core::normal_survival(z) / core::normal_density(z);
    const double r = 1.0 / (z * z); // Abramowitz and Stegun 26.2.12
    return (1.0 - r * (1.0 - r * (3.0 - r * (15.0 - r * 105.0)))) / z;
}

/// int Phi(u) dH over one segment, H = k0 x^-k and u = ln(x / median) / dispersion. By parts it
/// is Phi(u) H at the lower end less that at the upper, and int phi(u) H du, which is
/// c (Phi(u + k dispersion) at the upper end less that at the lower) with
/// c phi(u + k dispersion) = H phi(u) at any point.
double rate_between(const HazardPoint& a, const HazardPoint& b, double median,
                    double dispersion)
{
    const double k = std::log(a.rate / b.rate) / std::log(b.intensity / a.intensity);
    const double ua = std::log(a.intensity / median) / dispersion;
    const double ub = std::log(b.intensity / median) / dispersion;
    const double za = ua + k * dispersion, zb = ub + k * dispersion;
    // Steep hazard makes c huge: with both ends in one tail, c is written by H phi(u) there.
    double between = 0.0;
    if (za >= 0.0)
        between = a.rate * core::normal_density(ua) * tail_ratio(za) -
                  b.rate * core::normal_density(ub) * tail_ratio(zb);
    else if (zb <= 0.0)
        between = b.rate * core::normal_density(ub) * tail_ratio(-zb) -
                  a.rate * core::normal_density(ua) * tail_ratio(-za);
    else // z = 0 lies between, and the factor of a.rate is at most 1
        between = a.rate * std::exp(0.5 * (za * za - ua * ua)) *
                  (core::normal_cdf(zb) - core::normal_cdf(za));
    return core::normal_cdf(ua) * a.rate - core::normal_cdf(ub) * b.rate + between;
}

} // namespace

Observation ida_capacity(std::span<const IdaStep> steps, double threshold)
{
    if (steps.empty() || !(threshold > 0.0))
        throw std::invalid_argument("no steps, or no threshold above 0");
    double x = 0.0, d = 0.0; // at rest without shaking
    for (const IdaStep& s : steps) {
        if (!(s.intensity > x)) throw std::invalid_argument("intensities must ascend");
        if (!s.collapsed && !(s.response >= 0.0))
            throw std::invalid_argument("a response must be 0 or more");
        if (s.collapsed)
            return x > 0.0 ? Observation{x, s.intensity} : left_censored(s.intensity);
        if (s.response > threshold)
            return observed(x + (s.intensity - x) * (threshold - d) / (s.response - d));
        x = s.intensity;
        d = s.response;
    }
    return right_censored(x);
}

AnnualRate annual_rate(std::span<const HazardPoint> hazard, double median, double dispersion)
{
    if (hazard.size() < 2 || !(median > 0.0) || !(dispersion > 0.0))
        throw std::invalid_argument(
            "a rate needs two points of hazard, a median and a dispersion above 0");
    double rate = 0.0;
    for (std::size_t i = 1; i < hazard.size(); ++i) {
        const HazardPoint &a = hazard[i - 1], &b = hazard[i];
        if (!(a.intensity > 0.0 && b.intensity > a.intensity && b.rate > 0.0 &&
              b.rate < a.rate))
            throw std::invalid_argument("hazard must fall while the intensity ascends");
        rate += rate_between(a, b, median, dispersion);
    }
    return {rate, rate + hazard.back().rate};
}

} // namespace fragility
