#pragma once
/// What walls that stood can still say: a limit displacement that was not reached is a lower
/// bound, and no fit. Exact binomial tails, no law supposed.

#include "fragility/observation.hpp"

#include <span>

namespace fragility {

/// At a value x a wall tells if it is known to have failed by x, or to have stood at x; walls
/// stopped before say nothing there. (Walls that failed before they could have been stopped are
/// counted all the same: the bound then is too high rather than too low.)
struct ReachedBound {
    double walls = 0.0;   ///< that tell
    double failed = 0.0;  ///< of these
    double at_most = 1.0; ///< P(limit state reached at x) is at most this [-]; 1: nothing known
};

/// The bound never falls with x, so that no value beyond x gives a better one at x.
/// @param confidence one-sided, in (0, 1)
/// @throws std::invalid_argument for data that are not a number or a confidence not in (0, 1)
[[nodiscard]] ReachedBound reached_at_most(std::span<const Observation> data, double x,
                                           double confidence = 0.95);

struct MedianBound {
    double confidence = 0.0; ///< one-sided [-]
    bool median_bounded = false;
    double median_above = 0.0; ///< the median is at or above this value [x]
    bool strictly = false;     ///< above: walls stood there, they did not just reach it
};

/// The highest value that bounds the median from below. Five walls that stood bound it at 95 %:
/// 0.5^5 = 0.031.
/// @throws std::invalid_argument for data that are not a number or a confidence not in (0, 1)
[[nodiscard]] MedianBound median_bound(std::span<const Observation> data,
                                       double confidence = 0.95);

} // namespace fragility
