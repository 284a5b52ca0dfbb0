#pragma once
/// Bounds from walls that never reached the limit state, where no law can be fitted. The bounds
/// come from exact binomial tails; no law is assumed.

#include "fragility/fits/observation.hpp"

#include <span>

namespace fragility {

/// A wall is informative at x if it is known either to have failed by x or to have survived x;
/// a wall whose run stopped before x is not. (A wall that failed early counts even where its
/// run would have been stopped before x; this makes the bound too high rather than too low.)
struct ReachedBound {
    double walls = 0.0;   ///< informative walls
    double failed = 0.0;  ///< informative walls that have failed
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
    bool strictly = false;     ///< the median is above it: enough walls survived this value
};

/// The highest value that bounds the median from below. Five walls that stood bound it at 95 %:
/// 0.5^5 = 0.031.
/// @throws std::invalid_argument for data that are not a number or a confidence not in (0, 1)
[[nodiscard]] MedianBound median_bound(std::span<const Observation> data,
                                       double confidence = 0.95);

} // namespace fragility
