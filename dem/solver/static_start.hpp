#pragma once
/// The wall at rest under its vertical load, solved instead of waited for: conjugate gradients on
/// closed, sticking, uncracked contacts, without a matrix, preconditioned by the fictitious masses.
/// Contacts that the laws do not allow (tension or too much shear in a dry joint) are cut back
/// after it; the few steps to come to rest from there belong to the drive.

#include "dem/solver/wall_state.hpp"

namespace dem {

/// @param state one wall, unloaded; on success at rest under its full load, and the ledger starts
/// with the energy stored
/// @return false if the iteration did not converge: the state is then as it was
[[nodiscard]] bool solve_preload(const StepTables& tables, WallState<double>& state);

/// Copies what a static wall has into a lane: positions, contacts, energy.
template <class Real>
void copy_to_lane(const WallState<double>& wall, int lane, WallState<Real>& state);

} // namespace dem
