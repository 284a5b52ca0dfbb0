#pragma once
/// The part of a step in which blocks move, for walls that body forces push
/// (LoadPattern::body).
///
/// Every block feels the factor f times its weight to the right. The work of these forces on a
/// motion v is f (p . v) with p = what f = 1 does to each mode, so that u = (sum of p . v) /
/// weight is their conjugate displacement. It is prescribed, and f is what that takes (the
/// multiplier of the constraint), in the metric of the fictitious masses m:
///   f += (weight du - p . v*) / (p . p / m),   v = v* + (change of f) p / m,
/// with v* the velocity under the last f. So the falling branch of a wall is followed down to f
/// = 0 and below. A constraint cannot raise the frequencies of a wall; the stable step stays.

#include "dem/solver/step/step.hpp"

namespace dem {

/// Moves all blocks of walls with small or finite displacements; the contacts come next.
template <class Real>
void move_by_body_forces(const StepTables& tables, const SolverOptions& options,
                         const StepInput<Real>& input, WallState<Real>& state);

} // namespace dem
