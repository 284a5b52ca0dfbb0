#pragma once
/// What peak force and ultimate displacement depend on (the paper, Fig. 12).

#include "app/fragility/fragility_output.hpp"
#include "app/fragility/study_walls.hpp"
#include "app/output/table.hpp"

#include <vector>

namespace app {

/// Per vertical stress, response and input: correlations of values and of ranks, standardised rank
/// regression, share explained. Ultimate displacement: of the walls on which it was observed.
[[nodiscard]] Table input_table(const StudyWalls& walls);

/// Peak force over the joint friction angle, one dot per wall, one colour per mode; a chart of each level.
/// Empty without that random input.
[[nodiscard]] std::vector<NamedPicture> input_pictures(const StudyWalls& walls);

} // namespace app
