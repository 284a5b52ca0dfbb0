#pragma once
/// One explicit step of a batch of walls with finite displacements.
///
/// Each block has a frame that turns with it by its true rotation; its elastic modes are small
/// in that frame and are the ones of the step with small displacements, with the same contact
/// operators less their rigid columns. The rigid motion of the blocks meets in the pairs of
/// faces (kinematics/face_pair.hpp): one overlap, one gap that varies linearly along it, one
/// slip, and one resultant for all contacts of a pair. So a step costs hardly more than with
/// small displacements.

#include "dem/solver/step/step.hpp"

namespace dem {

template <class Real>
void finite_step(const StepTables& tables, const SolverOptions& options,
                 const StepInput<Real>& input, WallState<Real>& state);

/// Contacts follow the frames and the elastic modes of this step: new gaps, slips, stresses,
/// and the forces on all frames.
template <class Real>
void advance_contacts(const StepTables& tables, const SolverOptions& options,
                      WallState<Real>& state);

/// Takes a wall that small displacements have brought to rest (or one without loads) over into
/// its frames.
void take_up_frames(const StepTables& tables, const SolverOptions& options,
                    WallState<double>& wall);

} // namespace dem
