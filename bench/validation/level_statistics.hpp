#pragma once
/// Statistics that the paper's tables show of one stress level, from our walls.

#include "app/study/stored/study_walls.hpp"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <vector>

namespace bench {

struct Sample {
    std::size_t n = 0;
    double mean = 0.0, sd = 0.0;       ///< sd 0 for fewer than two
    std::optional<double> hypercube{}; ///< standard error of the mean of walls of a hypercube
    [[nodiscard]] double std_error() const; ///< that, or as of independent walls
    [[nodiscard]] double cov() const { return mean != 0.0 ? sd / mean : 0.0; }
};
[[nodiscard]] Sample sample(const std::vector<double>& values);

struct ModeStatistics {
    Sample friction_deg, strength_MPa, peak_kN;
    Sample
        displacement_mm; ///< drop to 80 %; of a wall without, the end of its run, as the paper has it
    Sample dropped_mm; ///< of the walls that dropped alone
    Sample plateau_kN; ///< of the equal-energy bilinear up to displacement_mm
};

struct LevelStatistics {
    double stress_MPa = 0.0;
    std::size_t walls = 0, rocking_walls = 0, dropped_walls = 0, slid_walls = 0, failed = 0;
    Sample rocking_percent; ///< share of rocking walls
    Sample peak_kN;         ///< all walls
    Sample unslid_kN;       ///< without those that slid whole
    Sample plateau_kN;      ///< as of the modes, all walls
    ModeStatistics rocking, mixed;
};

/// @param mode thresholds of the rule that names modes
[[nodiscard]] LevelStatistics level_statistics(const app::StudyWalls& walls, std::size_t level,
                                               const dem::ModeThresholds& mode);

/// Last fall to 80 % of the peak, for good, of the walls of mixed mode; else the end of their
/// run.
/// @param walls read with fragility.crossing = last and fragility.limit_states = paper
[[nodiscard]] Sample last_falls_mm(const app::StudyWalls& walls, std::size_t level);

/// All levels, with the study's own thresholds.
[[nodiscard]] std::vector<LevelStatistics> level_statistics(const app::StudyWalls& walls);

/// The same of the study in a file.
/// @throws app::StoreError as read_study_walls
[[nodiscard]] std::vector<LevelStatistics> read_levels(const std::filesystem::path& file);

} // namespace bench
