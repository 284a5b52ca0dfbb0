#pragma once
/// Tables and pictures of fragility curves from counts.

#include "app/fragility/numbers/damage_counts.hpp"
#include "app/fragility/numbers/fragility_output.hpp"

namespace app {

/// Each limit state fitted alone and, where there are several, all of them with one dispersion.
/// @param confidence of the intervals, in (0, 1)
[[nodiscard]] FragilityOutput damage_output(const DamageCounts& counts, double confidence);

} // namespace app
