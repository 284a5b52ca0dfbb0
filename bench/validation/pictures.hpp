#pragma once
/// Counterparts of the paper's figures.

#include "app/fragility/numbers/fragility_output.hpp"
#include "app/study/stored/study_walls.hpp"
#include "bench/validation/level_statistics.hpp"

#include <vector>

namespace bench {

/// Fig. 9: values of each random input over all levels, and its prescribed density.
[[nodiscard]] std::vector<app::NamedPicture> input_histograms(const app::StudyWalls& walls);

/// Fig. 10: error of the mean of each input after j walls of the first level.
[[nodiscard]] app::NamedPicture running_errors(const app::StudyWalls& walls);

/// Figures 11 and 14: all curves of each level, modes by colour, and their means.
[[nodiscard]] std::vector<app::NamedPicture> all_curves(const app::StudyWalls& walls,
                                                        const std::string& name);

/// Fig. 12: peak force over each input, all levels.
[[nodiscard]] std::vector<app::NamedPicture> peaks_over_inputs(const app::StudyWalls& walls);

/// Shares of rocking over vertical stress with 95 % intervals, the paper's and ours.
[[nodiscard]] app::NamedPicture rocking_over_stress(const std::vector<LevelStatistics>& ours);

} // namespace bench
