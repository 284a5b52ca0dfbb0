#pragma once
/// Errors of means by the number of walls: as of independent walls, and as of the hypercube
/// that was drawn.

#include "app/output/table/table.hpp"
#include "app/study/stored/study_walls.hpp"

#include <optional>
#include <span>
#include <vector>

namespace app {

struct Sampling;

/// Whether walls come from a Latin hypercube with one value of each input per wall, none of
/// them correlated.
[[nodiscard]] bool in_hypercube(const Sampling& sampling);

/// Standard error of the mean of y over the walls of the level that are members, under a
/// hypercube (uq::latin_subset_error); nothing where the study has none, of fewer than two
/// members, or of so few walls that the additive part cannot be told (uq::latin_degree).
/// @param y, member  one for each wall of the level
[[nodiscard]] std::optional<double> hypercube_error(const StudyWalls& walls,
                                                    const StudyLevel& level,
                                                    std::span<const double> y,
                                                    const std::vector<bool>& member);

struct SamplingError {
    double error;   ///< standard error of a mean
    double freedom; ///< its degrees of freedom, > 0
};

/// Standard error of the mean of ln peak force under a hypercube [-]; nothing as above.
[[nodiscard]] std::optional<SamplingError> log_peak_error(const StudyWalls& walls,
                                                          const StudyLevel& level);

/// Mean peak force, share of each mode, and mean displacement of the walls that fell, with both
/// errors.
[[nodiscard]] Table sampling_error_table(const StudyWalls& walls);

} // namespace app
