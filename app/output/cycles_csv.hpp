#pragma once
/// The cycles of a push to and fro as a table.

#include "dem/solver/state/energy.hpp"
#include "fragility/curve/cyclic_curve.hpp"

#include <span>
#include <string>
#include <vector>

namespace app {

/// "cycle,amplitude_mm,force_plus_kN,force_minus_kN,energy_J,damping_percent,residual_plus_mm,residual_minus_mm,
/// stiffness_kN_per_mm,stiffness_share,half_width_mm,shift_mm,displacement_plus_mm,displacement_minus_mm,closed,
/// friction_J,fracture_J,crushing_J,solver_J,stored_J", and one row for each cycle, counted
/// from 1. A cell is empty where a cycle has no such value. Residuals are the displacements at
/// which the force comes back to zero; half their distance is the half width, their mean the
/// shift of the loop. The share of the stiffness is that of the first cycle. The last columns
/// say where the energy went; their sum is that of the loop, but for what lies between the
/// points of the curve, off which the loop is read. "solver" is the damping of the solver, no
/// property of the wall; "stored" can come back in a later cycle, and is negative where it
/// does. Where joints lose energy as they close "closing_J" follows, which is a part of
/// "friction_J".
/// @param cycles displacements in [m], forces in [N]
/// @param ledger of each point of the path [J]
[[nodiscard]] std::string cycles_csv(const std::vector<fragility::Cycle>& cycles,
                                     std::span<const dem::Energy> ledger);

} // namespace app
