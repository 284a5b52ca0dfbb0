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

/// Laws of the contacts that are drawn.
enum class DrawnLaws {
    linear, ///< joints of constant stiffness, cracks as in the paper
    all     ///< joints that close or are bonded and cracks of mixed modes besides, drawn last
};

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
    DrawnLaws laws = DrawnLaws::linear;
    bool mixed_mode = false; ///< cracks follow the law of mixed modes
    bool mortar = false;     ///< joints between units have a bond
};

/// Scene `number` of the campaign of this seed: the same on every machine.
[[nodiscard]] StressScene stress_scene(std::uint64_t seed, std::uint64_t number,
                                       DrawnLaws laws = DrawnLaws::linear);

[[nodiscard]] dem::Model model_of(const StressScene& scene);

/// Materials of one of its walls.
[[nodiscard]] dem::WallMaterials stress_wall(const StressScene& scene, const dem::Model& model,
                                             int wall);

} // namespace bench
