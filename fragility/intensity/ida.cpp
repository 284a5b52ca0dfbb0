#include "fragility/intensity/ida.hpp"

#include "fragility/laws/standard_law.hpp"

#include <cmath>
#include <stdexcept>

namespace fragility {

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
        // H = k0 x^-k. With y = ln x: int Phi(u) k H dy, u = (y - ln median) / dispersion, is
        // [-Phi(u) H] + k0' int phi(u) ... = [-Phi(u) H + c Phi(u + k dispersion)] in closed
        // form.
        const double k = std::log(a.rate / b.rate) / std::log(b.intensity / a.intensity);
        const double at_median = a.rate * std::pow(median / a.intensity, -k);
        const double c = at_median * std::exp(0.5 * k * k * dispersion * dispersion);
        const auto primitive = [&](const HazardPoint& p) {
            const double u = std::log(p.intensity / median) / dispersion;
            return -StandardNormal::cdf(u) * p.rate +
                   c * StandardNormal::cdf(u + k * dispersion);
        };
        rate += primitive(b) - primitive(a);
    }
    return {rate, rate + hazard.back().rate};
}

} // namespace fragility
