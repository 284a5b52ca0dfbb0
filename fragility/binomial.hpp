#pragma once
/// Shares of walls: how often a mode, or a limit state, occurs.

#include "fragility/interval.hpp"

namespace fragility {

enum class BinomialInterval {
    wilson,          ///< score test inverted: near the confidence on average
    clopper_pearson, ///< exact tails: never below the confidence, wide
    jeffreys         ///< quantiles of the posterior under a Beta(1/2, 1/2) prior
};

/// Interval of the share of `count` among `n`. At 0 and n the Jeffreys interval is closed at 0
/// and 1 (Brown, Cai, DasGupta 2001, Statistical Science 16, 101-133).
/// @throws std::invalid_argument unless 0 <= count <= n, n > 0, confidence in (0, 1)
[[nodiscard]] Interval binomial_interval(BinomialInterval kind, double count, double n,
                                         double confidence = 0.95);

/// One-sided upper bound on the probability (Clopper-Pearson).
[[nodiscard]] double binomial_upper_bound(double count, double n, double confidence = 0.95);

struct Share {
    double count = 0.0;  ///< walls of this mode
    double n = 0.0;      ///< walls with a result
    double failed = 0.0; ///< walls without: each could have been of any mode
    double value = 0.0;  ///< count / n; 0 if n is 0
    Interval interval{}; ///< holds the probability whatever the failed walls would have been
};

/// The interval goes from the lower end of `count` to the upper end of `count + failed` among
/// all walls, failed ones too. Without any result the share is anything: [0, 1].
/// @throws std::invalid_argument as binomial_interval, or if failed < 0
[[nodiscard]] Share share(double count, double n, double failed = 0.0,
                          BinomialInterval kind = BinomialInterval::wilson,
                          double confidence = 0.95);

} // namespace fragility
