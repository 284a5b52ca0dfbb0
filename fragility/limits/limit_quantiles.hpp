#pragma once
/// The drifts at which 5 to 95 % of the walls have reached a limit state: from a law, from the
/// mixture of modes or from the shares observed, and never beyond the drift to which walls were
/// tested.

#include "core/interval.hpp"
#include "fragility/fits/observation.hpp"
#include "fragility/limits/fragility_curve.hpp"
#include "fragility/limits/performance_limits.hpp"

#include <optional>
#include <span>
#include <vector>

namespace fragility {

enum class QuantileSource {
    none,    ///< no wall, or none that reached the limit state
    law,     ///< one law of all walls
    mixture, ///< the laws of the modes, weighted by their shares
    heaps,   ///< the same of two heaps, told by the drifts themselves
    observed ///< Kaplan and Meier's shares, no law
};

[[nodiscard]] constexpr bool is_mixture(QuantileSource s)
{
    return s == QuantileSource::mixture || s == QuantileSource::heaps;
}

struct LimitQuantile {
    double share; ///< of walls that have reached the limit state [-]
    std::optional<double>
        value;               ///< [unit of the data]; nothing: only `interval.lower` is known
    core::Interval interval; ///< 0 below and infinity above where the walls give no bound
    bool observed = false;   ///< of the shares, though `source` is a law
};

struct LimitQuantiles {
    QuantileSource source = QuantileSource::none;
    double tested_to = 0.0; ///< see tested_to [unit of the data]
    std::vector<LimitQuantile> at;
    std::vector<ModeGroup> heaps; ///< of QuantileSource::heaps: the lower one, the upper one
};

/// The drift up to which enough walls were tested: at least one was pushed there for every five
/// whose pushes ended before while they stood. Infinite where all walls reached the limit
/// state; 0 without walls.
[[nodiscard]] double tested_to(std::span<const Observation> walls);

/// Walls whose limit drifts are asked for.
struct QuantileData {
    std::vector<ModeGroup>
        modes;             ///< one where modes are not known; `described`: by its own law
    bool described = true; ///< by one law of all walls
};

/// Chooses and reads. Walls that all fell, in two heaps that lie apart, are the mixture of
/// these heaps where no modes are known, or one of them has no law that describes it. Of two
/// modes or more, the mixture is used where one of them has a law that describes it. Of one,
/// and where the modes do no more than part walls that stood from those that fell, the law is
/// used where it describes the walls. Where some of these walls stood when their push ended,
/// shares above half of those reached are read from the shares observed: a second heap of walls
/// beyond the end, which no test sees, bends the law there. All else is read from the shares
/// observed.
///
/// Intervals by a law hold those of the other laws that the walls do not tell apart from it
/// (possible_laws.hpp). Where walls that all fell may be in two heaps, but not for sure, the
/// intervals of the law hold those of the heaps. A quantile beyond tested_to is a lower bound:
/// the smaller of the lower end of its interval and tested_to. Where the band of a mixture
/// breaks (a mode of one or two walls has no band), an end of the interval that it does not
/// give is that of the ranks of all walls, which need no law. A bound from below holds for all
/// larger shares, and one from above for all smaller ones.
/// @param law one law of all walls, from performance_limits of the same walls
/// @throws std::invalid_argument for a confidence not in (0, 1), and for values that are not
/// numbers
[[nodiscard]] LimitQuantiles limit_quantiles(const QuantileData& data,
                                             const PerformanceLimits& law,
                                             double confidence = 0.95);

} // namespace fragility
