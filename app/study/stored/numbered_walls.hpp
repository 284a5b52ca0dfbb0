#pragma once
/// Walls whose values a study file says, without a design.

#include "app/input/prepared_study.hpp"
#include "app/sampling/wall_draw.hpp"

#include <optional>
#include <string>
#include <vector>

namespace app {

struct LoadInput;

/// The wall that a user names.
struct WallChoice {
    std::optional<int> sample; ///< one wall of a study, >= 0
    bool mean = false;         ///< the wall in which each random value is its mean
    std::string level;         ///< the vertical stress as written; empty: all, or the only one
};

/// Index of the level given as text, such as "0.75 MPa"; the only one if the text is empty.
/// @throws ConfigError about --level
[[nodiscard]] int level_of(const LoadInput& load, const std::string& text);

/// With uq.drawn, the wall that it names. Otherwise the wall of the study's numbers under all
/// its levels or that of the choice; with `mean`, each distribution stands for its mean.
/// @throws ConfigError
[[nodiscard]] std::vector<WantedWall> numbered_walls(const PreparedStudy& ready,
                                                     const WallChoice& choice);

} // namespace app
