#pragma once
/// How much of the scatter of drops is numerical: the same walls under several discretisations.

#include "app/output/table/table.hpp"
#include "app/study/stored/study_walls.hpp"

#include <span>
#include <string>

namespace bench {

/// Components of the variance of ln displacement of the walls that fell under all
/// discretisations (analysis of variance with walls as groups).
struct ScatterParts {
    std::size_t walls = 0;
    double within = 0.0;  ///< standard deviation of one wall over the discretisations [-]
    double between = 0.0; ///< of the walls, without that [-]
    /// Walls that fell under some but not all, and that changed their mode.
    std::size_t fell_in_some = 0, changed_mode = 0;
};

/// @param studies  of the same walls, two or more
/// @throws std::invalid_argument where they are not the same walls
[[nodiscard]] ScatterParts scatter_parts(std::span<const app::StudyWalls> studies,
                                         std::size_t level);

/// A row for each stress.
/// @param names of the discretisations, for the caption
[[nodiscard]] app::Table numerical_scatter(std::span<const app::StudyWalls> studies,
                                           const std::string& names);

} // namespace bench
