#pragma once
/// Snapshot of one wall of a batch.

#include "dem/snapshot.hpp"
#include "dem/wall_state.hpp"

namespace dem {

/// @param drive displacement of the load line [m];  force: horizontal load [N]
template <class Real>
[[nodiscard]] Snapshot picture(const Model& model, const StepTables& tables,
                               const WallState<Real>& state, int lane, double drive,
                               double force);

} // namespace dem
