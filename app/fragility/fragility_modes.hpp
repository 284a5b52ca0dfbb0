#pragma once
/// Failure modes of a study: how likely, what decides, what the thresholds of the rule change.

#include "app/output/table/table.hpp"
#include "app/study/stored/study_walls.hpp"

namespace app {

/// Share of each mode under each stress: Wilson, Clopper-Pearson and Jeffreys intervals, and
/// bounds that count failed walls, and those whose mode may still change.
[[nodiscard]] Table mode_table(const StudyWalls& walls);

/// Logistic regression of the mode on the joint friction angle: at which angle both modes are
/// equally likely, per stress. A sentence where the study has no such random input or the mode
/// does not depend on it.
[[nodiscard]] Table equal_modes_table(const StudyWalls& walls);

/// Share of mixed mode for other thresholds of dem/scene/mechanism/mechanism.hpp.
[[nodiscard]] Table threshold_table(const StudyWalls& walls);

} // namespace app
