#pragma once
/// The share of walls that have reached a limit state, estimated without assuming a law. It is
/// drawn beside fitted curves as a check.

#include "core/interval.hpp"
#include "fragility/fits/observation.hpp"

#include <span>
#include <vector>

namespace fragility {

struct KaplanMeierStep {
    double at;           ///< an observed value [x]
    double at_risk;      ///< walls that stood just before
    double failed;       ///< walls with this value
    double probability;  ///< share at or below, from here to the next step [-]
    double std_error;    ///< Greenwood [-]
    core::Interval band; ///< of ln(-ln survival), within [0, 1]
};

struct KaplanMeier {
    std::vector<KaplanMeierStep> steps; ///< ascending; before the first the share is 0
    double end = 0.0;                   ///< highest value of all: nothing is known beyond
};

/// Product-limit estimate (Kaplan and Meier 1958, J. Am. Stat. Assoc. 53, 457-481). A wall
/// stopped at the value of another was still standing then.
/// @throws std::invalid_argument for left- and interval-censored data, values that are not
/// numbers, weights that are not positive, a confidence not in (0, 1)
[[nodiscard]] KaplanMeier kaplan_meier(std::span<const Observation> data,
                                       double confidence = 0.95);

} // namespace fragility
