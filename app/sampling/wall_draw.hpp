#pragma once
/// The random values of one wall, and the wall that they make.

#include "app/input/study.hpp"
#include "dem/scene/layout.hpp"

#include <vector>

namespace app {

/// values[i] belong to study.random[i], in SI: one, or one per joint ID or crack ID.
struct WallDraw {
    std::vector<std::vector<double>> values;
};

/// How many values an input has in a wall.
[[nodiscard]] int values_per_wall(const RandomInput& input, Spatial spatial,
                                  const dem::Layout& layout);

/// Draws put into the study. Values not given and derived from random ones follow them, per wall or
/// per joint. Base and beam joints follow values drawn per wall, and the mean of those drawn per
/// joint.
/// @param level index in study.load.vertical_stress
[[nodiscard]] dem::WallMaterials wall_materials(const Study& study, const dem::Layout& layout,
                                                int level, const WallDraw& draw);

} // namespace app
