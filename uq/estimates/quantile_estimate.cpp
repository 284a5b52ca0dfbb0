#include "uq/estimates/quantile_estimate.hpp"

#include "core/boost_quantiles.hpp"
#include "core/critical.hpp"
#include "core/interval.hpp"
#include "core/sample_quantile.hpp"

#include <gsl/gsl_cdf.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace uq {

namespace {

void check_probability(double p)
{
    if (!(p > 0.0 && p < 1.0))
        throw std::invalid_argument("probability of a quantile is " + std::to_string(p) +
                                    ", must be in (0, 1)");
}

/// Smallest k in 0 .. n with P(Binomial(n, p) <= k) >= level.
std::size_t binomial_quantile(double level, std::size_t n, double p)
{
    std::size_t low = 0, high = n;
    while (low < high) {
        const std::size_t k = (low + high) / 2;
        if (gsl_cdf_binomial_P(static_cast<unsigned>(k), p, static_cast<unsigned>(n)) >= level)
            high = k;
        else
            low = k + 1;
    }
    return low;
}

/// With all = sound + failed values and B of them below the quantile, x_(l) is above it if
/// B <= l - 1 and x_(u) below it if B >= u.
core::Interval between_values(const std::vector<double>& sorted, std::size_t failed, double p,
                              double confidence)
{
    constexpr double infinite = std::numeric_limits<double>::infinity();
    const std::size_t all = sorted.size() + failed;
    const double tail = 0.5 * (1.0 - confidence);
    std::size_t l = binomial_quantile(tail, all, p);                 // P(B <= l - 1) < tail
    const std::size_t u = binomial_quantile(1.0 - tail, all, p) + 1; // P(B >= u) <= tail
    l = l > failed ? l - failed : 0; // the failed ones are the lowest
    return {l >= 1 ? sorted[l - 1] : -infinite, u <= sorted.size() ? sorted[u - 1] : infinite,
            confidence};
}

/// Weights of n sorted values: increments of the beta distribution with (n + 1) p and (n + 1)
/// (1 - p), the law of the probability below the order statistic at the quantile.
std::vector<double> beta_weights(std::size_t n, double p)
{
    const auto real = static_cast<double>(n);
    std::vector<double> w(n);
    double before = 0.0;
    for (std::size_t i = 0; i < n; ++i) {
        const double upto = core::beta_probability((real + 1.0) * p, (real + 1.0) * (1.0 - p),
                                                   static_cast<double>(i + 1) / real);
        w[i] = upto - before;
        before = upto;
    }
    return w;
}

/// Standard deviation under the weights (differences from a value lose no digits).
double standard_error(const std::vector<double>& sorted, const std::vector<double>& w,
                      double centre)
{
    double first = 0.0, second = 0.0;
    for (std::size_t i = 0; i < sorted.size(); ++i) {
        const double d = sorted[i] - centre;
        first += w[i] * d;
        second += w[i] * d * d;
    }
    return std::sqrt(std::max(0.0, second - first * first));
}

} // namespace

Estimate estimate_quantile(std::span<const double> y, double p, double confidence)
{
    check_probability(p);
    core::check_confidence(confidence);
    SoundValues sound = sound_values(y);
    std::vector<double>& sorted = sound.values;
    if (sorted.size() < 2)
        throw std::invalid_argument("at least 2 sound samples are needed, got " +
                                    std::to_string(sorted.size()));
    std::sort(sorted.begin(), sorted.end());
    const double between = core::unbiased_quantile(sorted, p);
    return {between, standard_error(sorted, beta_weights(sorted.size(), p), between),
            sorted.size(), sound.failed, between_values(sorted, sound.failed, p, confidence)};
}

} // namespace uq
