#pragma once
/// The error by the speed of the solver beside the error of sampling.

#include "app/output/table/table.hpp"
#include "app/study/stored/study_walls.hpp"

namespace app {

/// One row per stress: errors that the pushes estimate, what they and the number of walls leave
/// open of the mean peak force, and the differences of the audit.
[[nodiscard]] Table solver_error_table(const StudyWalls& walls);

} // namespace app
