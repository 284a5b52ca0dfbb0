#pragma once
/// The cycles of a push to and fro as a table.

#include "dem/solver/state/curve_point.hpp"
#include "fragility/curve/cyclic_curve.hpp"

#include <span>
#include <string>
#include <vector>

namespace app {

/// One row for each cycle, with the numbers of cycle_columns() in their units:
/// "cycle,amplitude_mm,force_plus_kN,...,solver_J,stored_J". A cell is empty where a cycle has
/// no such value. "closing_J" is there where joints lose energy as they close.
/// @param cycles displacements in [m], forces in [N]
/// @param curve of the push, points of the path of the cycles
[[nodiscard]] std::string cycles_csv(const std::vector<fragility::Cycle>& cycles,
                                     std::span<const dem::CurvePoint> curve);

} // namespace app
