#pragma once
/// Shares of walls: how often a mode, or a limit state, occurs.

#include "core/binomial.hpp"
#include "core/interval.hpp"

namespace fragility {

struct Share {
    double count = 0.0;  ///< walls of this mode
    double n = 0.0;      ///< walls with a result
    double failed = 0.0; ///< walls without: each could have been of any mode
    double value = 0.0;  ///< count / n; 0 if n is 0
    core::Interval
        interval{}; ///< holds the probability whatever the failed walls would have been
};

/// The interval goes from the lower end of `count` to the upper end of `count + failed` among
/// all walls, failed ones too. Without any result the share is anything: [0, 1].
/// @throws std::invalid_argument as binomial_interval, or if failed < 0
[[nodiscard]] Share share(double count, double n, double failed = 0.0,
                          core::BinomialInterval kind = core::BinomialInterval::wilson,
                          double confidence = 0.95);

} // namespace fragility
