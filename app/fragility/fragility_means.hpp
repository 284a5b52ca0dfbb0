#pragma once
/// Means per mode and vertical stress (the paper, Tables 6 to 8 and Fig. 15).

#include "app/fragility/fragility_output.hpp"
#include "app/fragility/study_walls.hpp"
#include "app/output/table.hpp"

#include <vector>

namespace app {

/// Table 6 (rocking) or 7 (mixed) of the paper: means of inputs, force and displacement, with standard
/// errors and the share of the mode.
[[nodiscard]] Table mean_table(const StudyWalls& walls, int mode);

/// Table 8: both modes side by side.
[[nodiscard]] Table both_modes_table(const StudyWalls& walls);

/// Mean force over drift with 16 and 84 % of the walls, per mode and stress: a table, and a chart of each
/// mode.
[[nodiscard]] Table mean_curve_table(const StudyWalls& walls);
[[nodiscard]] std::vector<NamedPicture> mean_curve_pictures(const StudyWalls& walls);

} // namespace app
