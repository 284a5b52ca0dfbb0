#pragma once
/// Every wall of a study and how it is read.

#include "app/output/table/table.hpp"
#include "app/study/stored/study_walls.hpp"

namespace app {

/// One row per wall: mode, peak, ultimate displacement, every limit state, what moved, inputs.
/// Failed walls have their reason.
/// @param walls of the study, all of them or some
[[nodiscard]] Table wall_table(const StudyWalls& study, const WallList& walls);

} // namespace app
