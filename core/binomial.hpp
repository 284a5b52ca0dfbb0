#pragma once
/// Intervals of a probability from counts.

#include "core/interval.hpp"

namespace core {

enum class BinomialInterval {
    wilson,          ///< score test inverted: near the confidence on average (Wilson 1927)
    clopper_pearson, ///< exact tails: never below the confidence (Clopper, Pearson 1934)
    jeffreys         ///< quantiles of the posterior under a Beta(1/2, 1/2) prior
};

/// Interval of the share of `count` among `n`. At 0 and n the Jeffreys interval is closed at 0
/// and 1 (Brown, Cai, DasGupta 2001, Statistical Science 16, 101-133).
/// @throws std::invalid_argument unless 0 <= count <= n, n > 0, confidence in (0, 1)
[[nodiscard]] Interval binomial_interval(BinomialInterval kind, double count, double n,
                                         double confidence = 0.95);

/// One-sided upper bound on the probability (Clopper-Pearson).
[[nodiscard]] double binomial_upper_bound(double count, double n, double confidence = 0.95);

} // namespace core
