#include "core/binomial.hpp"

#include "core/boost_quantiles.hpp"
#include "core/critical.hpp"
#include "core/fit_factors.hpp"

#include <cmath>
#include <stdexcept>
#include <string>

namespace core {
namespace {

void check_counts(double count, double n, double confidence)
{
    if (!(n > 0.0 && std::isfinite(n) && count >= 0.0 && count <= n))
        throw std::invalid_argument("binomial interval: needs 0 <= count <= n and n > 0, has " +
                                    std::to_string(count) + " of " + std::to_string(n));
    check_confidence(confidence);
}

Interval wilson(double count, double n, double confidence)
{
    const double z = fit_normal_factor(confidence);
    const double middle = count + 0.5 * z * z;
    const double half = z * std::sqrt(count * (n - count) / n + 0.25 * z * z);
    const double size = n + z * z;
    return {count == 0.0 ? 0.0 : (middle - half) / size,
            count == n ? 1.0 : (middle + half) / size, confidence};
}

/// Quantiles of Beta(count + a, n - count + b); a degenerate one is an end of [0, 1].
Interval beta_interval(double count, double n, double confidence, double lower_a,
                       double lower_b, double upper_a, double upper_b)
{
    const double tail = 0.5 - 0.5 * confidence;
    return {count == 0.0 ? 0.0 : beta_quantile(count + lower_a, n - count + lower_b, tail),
            count == n ? 1.0 : upper_beta_quantile(count + upper_a, n - count + upper_b, tail),
            confidence};
}

} // namespace

Interval binomial_interval(BinomialInterval kind, double count, double n, double confidence)
{
    check_counts(count, n, confidence);
    switch (kind) {
    case BinomialInterval::clopper_pearson:
        return beta_interval(count, n, confidence, 0.0, 1.0, 1.0, 0.0);
    case BinomialInterval::jeffreys:
        return beta_interval(count, n, confidence, 0.5, 0.5, 0.5, 0.5);
    case BinomialInterval::wilson:
        break;
    }
    return wilson(count, n, confidence);
}

double binomial_upper_bound(double count, double n, double confidence)
{
    check_counts(count, n, confidence);
    return count == n ? 1.0 : beta_quantile(count + 1.0, n - count, confidence);
}

} // namespace core
