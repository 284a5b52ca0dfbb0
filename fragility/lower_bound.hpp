#pragma once
/// What walls that stood can still say: a limit displacement that was not reached is a lower
/// bound, and no fit.

#include "fragility/observation.hpp"

#include <span>

namespace fragility {

/// Without assuming any law. Values of 0 and shares of 1 mean "nothing can be said".
struct LowerBound {
    double confidence = 0.0; ///< one-sided [-]
    bool median_bounded = false;
    double median_above = 0.0;      ///< the median is above this value [x]
    double at = 0.0;                ///< highest value that any wall is known to have stood [x]
    double walls_at = 0.0;          ///< walls that tell at that value whether they stood
    double failed_at = 0.0;         ///< of these, walls below it
    double probability_below = 1.0; ///< at most this share of walls fails below `at` [-]
};

/// Exact binomial tails. At a value t a wall tells if it is observed or left-censored at or
/// below t, or known to stand at t; walls stopped below t say nothing there. Five walls that
/// stood bound a median at 95 %: 0.5^5 = 0.031.
/// @throws std::invalid_argument for data that are not a number or a confidence not in (0, 1)
[[nodiscard]] LowerBound lower_bound(std::span<const Observation> data,
                                     double confidence = 0.95);

} // namespace fragility
