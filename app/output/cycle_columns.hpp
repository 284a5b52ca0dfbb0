#pragma once
/// The numbers of a cycle of a push to and fro: one table for files and for Python.

#include "dem/solver/state/curve_point.hpp"
#include "fragility/curve/cyclic_curve.hpp"

#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace app {

/// One number of all cycles.
struct CycleColumn {
    std::string_view name;                     ///< "energy"
    std::string_view unit;                     ///< of the file: "J"; empty: none
    double scale = 1.0;                        ///< from SI to that unit
    std::vector<std::optional<double>> values; ///< of each cycle, in SI; nothing: it has none
};

/// All numbers of the cycles. Residuals are the displacements at which the force comes back to
/// zero; half their distance is the half width, their mean the shift of the loop. The share of
/// the stiffness is that of the first cycle. The last columns say where the energy went; their
/// sum is that of the loop, but for what lies between the points of the curve, off which the
/// loop is read, and for a part of "solver", the damping of the solver: the force of a point is
/// the mean of those at top and base. That is no property of the wall. "stored" is in the wall
/// and in the height of its loads; it can come back in a later cycle, and is negative where it
/// does. "closing" is the part of "friction" that joints lose as they close.
/// @param cycles displacements in [m], forces in [N]
/// @param curve of the push, points of the path of the cycles
[[nodiscard]] std::vector<CycleColumn>
cycle_columns(const std::vector<fragility::Cycle>& cycles,
              std::span<const dem::CurvePoint> curve);

} // namespace app
