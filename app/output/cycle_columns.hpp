#pragma once
/// The numbers of a cycle of a push to and fro: one table for files and for Python.

#include "dem/solver/state/energy.hpp"
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
/// loop is read, and for what weight and vertical load give as a wall that crushes sinks below
/// its place before the push. "solver" is the damping of the solver, no property of the wall;
/// "stored" can come back in a later cycle, and is negative where it does; "closing" is the
/// part of "friction" that joints lose as they close.
/// @param cycles displacements in [m], forces in [N]
/// @param ledger of each point of the path [J]
[[nodiscard]] std::vector<CycleColumn>
cycle_columns(const std::vector<fragility::Cycle>& cycles, std::span<const dem::Energy> ledger);

} // namespace app
