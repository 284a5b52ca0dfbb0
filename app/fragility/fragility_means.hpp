#pragma once
/// Means per mode and vertical stress (the paper, Tables 6 to 8 and Fig. 15).

#include "app/fragility/fragility_output.hpp"
#include "app/output/table.hpp"
#include "app/study/study_walls.hpp"
#include "fragility/interval.hpp"

#include <cstddef>
#include <vector>

namespace app {

/// Means of inputs, force and displacement of the walls of each mode, with standard errors and the share
/// of the mode: Tables 6 (rocking), 7 (mixed) and 8 (both) of the paper, one below the other.
[[nodiscard]] Table mean_table(const StudyWalls& walls);

constexpr int kAllModes = 3; ///< after the modes

/// Of the lines of a stress in pictures of several.
/// @param level index in StudyWalls::levels
[[nodiscard]] const char* stress_colour(std::size_t level);

/// Forces of the walls of a group at one step [kN].
struct MeanPoint {
    double drift;           ///< [%]
    double mean, low, high; ///< low, high: 16 and 84 % of the walls lie below
    std::size_t walls;
    fragility::Interval interval; ///< of the mean; no bounds for one wall
};

/// At 0, 1, ... kCurveSteps steps, as far as kMeanNeedsShare of the curves of the group go: the rest are no
/// fair sample.
[[nodiscard]] std::vector<MeanPoint> mean_points(const StudyWalls& walls,
                                                 const StudyLevel& level, int mode);

/// Mean force over drift with 16 and 84 % of the walls, per mode and stress: a table, and a chart of each
/// mode.
[[nodiscard]] Table mean_curve_table(const StudyWalls& walls);
[[nodiscard]] std::vector<NamedPicture> mean_curve_pictures(const StudyWalls& walls);

} // namespace app
