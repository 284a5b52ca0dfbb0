#pragma once
/// Where a wall stands before the ground moves.

#include "dem/shaking/shake.hpp"
#include "dem/solver/state/wall_state.hpp"

#include <vector>

namespace dem {

struct ShakingStart {
    WallState<double> wall; ///< its work is the energy stored; nothing moves
    double unbalance = 0.0; ///< [-]
    double raised = 0.0; ///< energy of blocks that are let go, above their undeformed place [J]
    bool at_rest = true;
};

/// The wall at rest under its loads, by the static solution and a few damped steps with
/// fictitious masses.
[[nodiscard]] ShakingStart wall_at_rest(const Model& model, const StepTables& tables,
                                        const WallMaterials& materials,
                                        const SolverOptions& options);

/// The unloaded wall with blocks where they are let go.
[[nodiscard]] ShakingStart released_wall(const Model& model, const StepTables& tables,
                                         const WallMaterials& materials,
                                         const SolverOptions& options,
                                         const std::vector<Displaced>& released);

} // namespace dem
