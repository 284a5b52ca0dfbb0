#pragma once
/// Means per mode and vertical stress (the paper, Tables 6 to 8 and Fig. 15).

#include "app/fragility/fragility_output.hpp"
#include "app/fragility/study_walls.hpp"
#include "app/output/table.hpp"

#include <vector>

namespace app {

/// Means of inputs, force and displacement of the walls of each mode, with standard errors and the share
/// of the mode: Tables 6 (rocking), 7 (mixed) and 8 (both) of the paper, one below the other.
[[nodiscard]] Table mean_table(const StudyWalls& walls);

/// Mean force over drift with 16 and 84 % of the walls, per mode and stress: a table, and a chart of each
/// mode.
[[nodiscard]] Table mean_curve_table(const StudyWalls& walls);
[[nodiscard]] std::vector<NamedPicture> mean_curve_pictures(const StudyWalls& walls);

} // namespace app
