#pragma once
/// Log-likelihood of censored data under y = location + dispersion z.

#include "fragility/fits/censored_sample.hpp"
#include "fragility/laws/standard_law.hpp"

#include <cmath>

namespace fragility {

/// Sums over a sample in delta = location / dispersion and gamma = 1 / dispersion, z = gamma y
/// - delta: there the log-likelihood of a log-concave law is concave whatever the censoring
/// (Burridge 1981, J. R. Statist. Soc. B 43, 41-45), so that Newton's method cannot go astray.
struct ScaledSum {
    double value = 0.0, d = 0.0, g = 0.0, dd = 0.0, dg = 0.0, gg = 0.0;

    void add(const LogTerm& t, double y, double w)
    {
        value += w * t.value;
        d -= w * t.d1;
        g += w * t.d1 * y;
        dd += w * t.d2;
        dg -= w * t.d2 * y;
        gg += w * t.d2 * y * y;
    }
    void add(const LogBetween& t, double middle, double width, double w)
    {
        value += w * t.value;
        d -= w * t.m;
        g += w * (t.m * middle + t.h * width);
        dd += w * t.mm;
        dg -= w * (t.mm * middle + t.mh * width);
        gg += w * (t.mm * middle * middle + 2.0 * t.mh * middle * width + t.hh * width * width);
    }
    void add_log_gamma(double gamma, double w)
    {
        value += w * std::log(gamma);
        g += w / gamma;
        gg -= w / (gamma * gamma);
    }
};

/// On the standardised axis of the sample.
template <class Standard>
[[nodiscard]] ScaledSum scaled_sum(const CensoredSample& s, double delta, double gamma)
{
    ScaledSum sum;
    double observed = 0.0;
    std::size_t i = 0;
    for (; i < s.observed; ++i) {
        if (s.weight[i] == 0.0) continue;
        observed += s.weight[i];
        sum.add(Standard::log_density(gamma * s.lower[i] - delta), s.lower[i], s.weight[i]);
    }
    for (; i < s.observed + s.right; ++i)
        if (s.weight[i] > 0.0)
            sum.add(Standard::log_survival(gamma * s.lower[i] - delta), s.lower[i],
                    s.weight[i]);
    for (; i < s.observed + s.right + s.left; ++i)
        if (s.weight[i] > 0.0)
            sum.add(Standard::log_cdf(gamma * s.lower[i] - delta), s.lower[i], s.weight[i]);
    for (; i < s.lower.size(); ++i) {
        if (s.weight[i] == 0.0) continue;
        const double middle = 0.5 * (s.lower[i] + s.upper[i]);
        const double width = s.upper[i] - s.lower[i];
        sum.add(Standard::log_between(gamma * middle - delta, gamma * width), middle, width,
                s.weight[i]);
    }
    sum.add_log_gamma(gamma, observed);
    return sum;
}

} // namespace fragility
