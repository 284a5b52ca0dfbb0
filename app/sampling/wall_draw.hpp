#pragma once
/// The random values of one wall, and the wall that they make.

#include "app/input/study/parameters.hpp"
#include "app/input/study/random_input.hpp"
#include "app/input/study/uq_input.hpp"
#include "dem/scene/layout.hpp"

#include <span>
#include <vector>

namespace app {

struct Masonry;

/// values[i] belong to study.random[i], in SI: one, or one per joint ID or crack ID.
struct WallDraw {
    std::vector<std::vector<double>> values;
};

/// A wall of a study.
struct WantedWall {
    int level = 0; ///< index in study.load.vertical_stress
    WallDraw draw; ///< without values: the numbers of the study
};

/// How many values an input has in a wall.
[[nodiscard]] int values_per_wall(const RandomInput& input, Spatial spatial,
                                  const dem::Layout& layout);

/// How many values each input has in a wall, by values_per_wall.
[[nodiscard]] std::vector<int> sites_of(std::span<const RandomInput> inputs, Spatial spatial,
                                        const dem::Layout& layout);

/// The draw with these values, one after the other.
/// @param sites as sites_of
/// @param values in SI
/// @throws BadValue (app/input/study/units.hpp) if there are more or fewer
[[nodiscard]] WallDraw draw_of(std::span<const int> sites, std::span<const double> values);

/// The same draw, each of whose values must lie in the range of its key.
/// @throws BadValue (app/input/study/units.hpp) naming the key
[[nodiscard]] WallDraw checked_draw(std::span<const RandomInput> inputs,
                                    std::span<const int> sites, std::span<const double> values);

/// Builds the wall's materials from one draw. Parameters derived from random ones are
/// recomputed for every wall or joint. Base and beam joints follow values drawn per wall, and
/// the mean of values drawn per joint.
/// @param draw without values: the numbers of the study
[[nodiscard]] dem::WallMaterials wall_materials(const Masonry& masonry,
                                                std::span<const RandomInput> random,
                                                StressLevel at, const dem::Layout& layout,
                                                const WallDraw& draw);

} // namespace app
