#pragma once
/// Laws that the walls of a study do not tell apart.

#include "fragility/limits/fragility_curve.hpp"

#include <span>
#include <vector>

namespace fragility {

/// Laws of positive values (lognormal, Weibull, gamma) other than that of the walls, which may
/// be theirs: their likelihood is at least 3/4 of the largest one, that of their own law
/// included. Modes that are not described by their law, or whose law cannot be fitted, do not
/// count. The 3/4 are a free choice: with 0.55 some intervals of
/// docs/bench/fragility/limit_coverage.md are more than 1.3 times as wide as those of the true
/// model.
/// @param modes all with one law
[[nodiscard]] std::vector<Law> other_possible_laws(std::span<const ModeGroup> modes);

} // namespace fragility
