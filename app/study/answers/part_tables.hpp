#pragma once
/// Tables of the piers and spandrels of a study, over the walls of each stress.

#include "app/output/table/table.hpp"
#include "app/study/stored/study_walls.hpp"

namespace app {

/// Forces, drift and modes of each pier over the walls of a stress. No rows without piers.
[[nodiscard]] Table study_pier_table(const StudyWalls& study);

/// Forces and drift of each spandrel over the walls of a stress. No rows without spandrels.
[[nodiscard]] Table study_spandrel_table(const StudyWalls& study);

} // namespace app
