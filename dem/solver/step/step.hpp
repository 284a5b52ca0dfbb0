#pragma once
/// One explicit step of a batch of walls: contact forces move the blocks, blocks move the
/// contacts, and the contact laws give the new forces.

#include "dem/solver/state/solver_options.hpp"
#include "dem/solver/state/wall_state.hpp"

namespace dem {

/// Action of the outside on each wall during a step.
template <class Real> struct StepInput {
    Real load_factor{1.0}; ///< share of self-weight and vertical load acting [-]
    Real drive{0.0};       ///< prescribed displacement in this step [m]
    Real held{0.0};        ///< of body forces: 1 where the displacement is prescribed, else 0
};

template <class Real>
void step(const StepTables& tables, const SolverOptions& options, const StepInput<Real>& input,
          WallState<Real>& state);

/// sqrt(sum of squared modal forces / sum of squared modal loads) of one lane in the last step
/// [-].
template <class Real>
[[nodiscard]] double unbalanced_ratio(const WallState<Real>& state, int lane);

} // namespace dem
