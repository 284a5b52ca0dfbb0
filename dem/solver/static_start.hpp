#pragma once
/// Solves for the wall at rest under its vertical load, instead of stepping until it is at
/// rest: conjugate gradients on closed, sticking, uncracked contacts, without a matrix,
/// preconditioned by the fictitious masses. Inadmissible contact stresses (tension or too much
/// shear in a dry joint) are then clipped to the friction law, and a few dynamic steps restore
/// equilibrium (see Drive). Where joints close under pressure, Newton's method does so again
/// and again with their tangents.

#include "dem/solver/state/wall_state.hpp"

#include <vector>

namespace dem {

/// @param state one unloaded wall. On success it is at rest under its full load, and its energy
/// balance
/// starts with the energy stored.
/// @return false if the iteration did not converge; the state is then unchanged
[[nodiscard]] bool solve_preload(const StepTables& tables, WallState<double>& state);

/// A wall that is pushed while nothing opens, slips or cracks, per displacement of the drive.
struct ElasticPush {
    std::vector<double> rate; ///< of the modes [sqrt(J)/m]; empty: not known
    double stiffness = 0.0;   ///< force of the drive [N/m]
    double mass = 0.0;        ///< 2 kinetic energy / speed^2 [N step2/m]
};

/// By conjugate gradients, as above. All zero and empty if the iteration did not converge.
/// @param state one wall, whose joints are as stiff as it has closed them; it is left without
/// stresses
[[nodiscard]] ElasticPush elastic_push(const StepTables& tables, WallState<double>& state);

/// Copies positions, contacts and energy of a wall at rest into a lane.
template <class Real>
void copy_to_lane(const WallState<double>& wall, int lane, WallState<Real>& state);

} // namespace dem
