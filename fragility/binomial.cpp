#include "fragility/binomial.hpp"

#include "fragility/standard_law.hpp"

#include <boost/math/special_functions/beta.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace fragility {
namespace {

void check(double count, double n, double confidence)
{
    if (!(n > 0.0 && std::isfinite(n) && count >= 0.0 && count <= n))
        throw std::invalid_argument("binomial interval: needs 0 <= count <= n and n > 0, has " +
                                    std::to_string(count) + " of " + std::to_string(n));
    if (!(confidence > 0.0 && confidence < 1.0))
        throw std::invalid_argument("binomial interval: confidence must be in (0, 1), is " +
                                    std::to_string(confidence));
}

Interval wilson(double count, double n, double confidence)
{
    const double z = StandardNormal::quantile(0.5 + 0.5 * confidence);
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
    return {
        count == 0.0 ? 0.0 : boost::math::ibeta_inv(count + lower_a, n - count + lower_b, tail),
        count == n ? 1.0 : boost::math::ibetac_inv(count + upper_a, n - count + upper_b, tail),
        confidence};
}

} // namespace

Interval binomial_interval(BinomialInterval kind, double count, double n, double confidence)
{
    check(count, n, confidence);
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
    check(count, n, confidence);
    return count == n ? 1.0 : boost::math::ibeta_inv(count + 1.0, n - count, confidence);
}

Share share(double count, double n, double failed, BinomialInterval kind, double confidence)
{
    if (!(failed >= 0.0 && std::isfinite(failed)))
        throw std::invalid_argument("share: failed walls must be >= 0, are " +
                                    std::to_string(failed));
    Share s{count, n, failed, 0.0, {0.0, 1.0, confidence}};
    if (n == 0.0 && count == 0.0) return s;
    check(count, n, confidence);
    s.value = count / n;
    const double all = n + failed;
    s.interval.lower = binomial_interval(kind, count, all, confidence).lower;
    s.interval.upper = binomial_interval(kind, count + failed, all, confidence).upper;
    return s;
}

} // namespace fragility
