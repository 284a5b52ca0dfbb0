#pragma once
/// Takes a snapshot of one wall of a batch.

#include "dem/scene/geometry/snapshot.hpp"
#include "dem/solver/state/wall_state.hpp"

namespace dem {

/// @param drive displacement of the load line [m];  force: horizontal load [N]
template <class Real>
[[nodiscard]] Snapshot take_snapshot(const Model& model, const StepTables& tables,
                                     const WallState<Real>& state, int lane, double drive,
                                     double force);

/// The same without its blocks, which takes less time.
template <class Real>
[[nodiscard]] Snapshot take_faces(const Model& model, const StepTables& tables,
                                  const WallState<Real>& state, int lane, double drive,
                                  double force);

/// Horizontal displacement of the upper right corner of the last block [m].
template <class Real>
[[nodiscard]] double corner_displacement(const Model& model, const StepTables& tables,
                                         const WallState<Real>& state, int lane, double drive);

} // namespace dem
