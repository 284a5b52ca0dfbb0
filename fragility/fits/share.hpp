#pragma once
/// Shares of walls: how often a mode, or a limit state, occurs.

#include "core/binomial.hpp"
#include "core/interval.hpp"

namespace fragility {

struct Share {
    double count = 0.0;        ///< walls of this mode
    double n = 0.0;            ///< walls with a result
    double failed = 0.0;       ///< walls without: each could have been of any mode
    double value = 0.0;        ///< count / n; 0 if n is 0
    core::Interval interval{}; ///< holds the probability whatever the undecided walls would be
};

/// Walls whose mode is not decided, beside those that failed: so far they are of this mode, or
/// of another.
struct Undecided {
    double of_this = 0.0;  ///< in [0, count]
    double of_other = 0.0; ///< in [0, n - count]
};

/// The interval goes from the lower end of `count - of_this` to the upper end of
/// `count + of_other + failed` among all walls, failed ones too. Without any result the share
/// is anything: [0, 1].
/// @throws std::invalid_argument as binomial_interval, or if failed < 0, or an undecided wall
/// is none of those counted
[[nodiscard]] Share share(double count, double n, double failed = 0.0,
                          core::BinomialInterval kind = core::BinomialInterval::wilson,
                          double confidence = 0.95, const Undecided& undecided = {});

} // namespace fragility
