#pragma once
/// Scenes drawn far outside the paper, to see what breaks.

#include "dem/block/discretisation.hpp"
#include "dem/solver/ensemble.hpp"
#include "scenes/paper_wall.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace bench {

struct StressScene {
    std::string text; ///< what was drawn, on one line
    scenes::Scene scene;
    dem::Discretisation discretisation;
    dem::SolverOptions solver;
    dem::PushPlan plan;
    std::uint64_t material_seed = 0;
    int walls = 0; ///< samples of the scene, side by side in the lanes
    double decades =
        0.0; ///< over which stiffness, friction and strength of the samples scatter
    bool by_joint = false;    ///< every joint and crack has its own values
    bool cracks = true;       ///< units can crack
    std::optional<int> spoil; ///< number of the wall that gets absurd values
};

/// Scene `number` of the campaign of this seed: the same on every machine.
[[nodiscard]] StressScene stress_scene(std::uint64_t seed, std::uint64_t number);

/// Materials of one of its walls.
[[nodiscard]] dem::WallMaterials stress_wall(const StressScene& scene, const dem::Model& model,
                                             int wall);

} // namespace bench
