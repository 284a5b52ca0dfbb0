#pragma once
/// Means per mode and vertical stress (the paper, Tables 6 to 8 and Fig. 15).

#include "app/fragility/numbers/fragility_output.hpp"
#include "app/output/table/table.hpp"
#include "app/study/stored/study_walls.hpp"
#include "core/interval.hpp"

#include <cstddef>
#include <vector>

namespace app {

/// Means of inputs, force and displacement of the walls of each mode, with standard errors and
/// the share of the mode: Tables 6 (rocking), 7 (mixed) and 8 (both) of the paper, one below
/// the other.
[[nodiscard]] Table mean_table(const StudyWalls& walls);

/// Mean over walls with its interval, which has no bounds for one wall.
struct MeanOf {
    double value = kUnknown;
    core::Interval interval{kUnknown, kUnknown, 0.0};
};
/// @param values of the walls; without any the mean is not known
[[nodiscard]] MeanOf mean_of(const std::vector<double>& values, double confidence);

/// The sum of the values divided by their number.
[[nodiscard]] double plain_mean(const std::vector<double>& values);

/// A mean ends where fewer of its walls are still pushed [-]: those left are not a fair sample,
/// since walls whose force has dropped are the first to go.
constexpr double kMeanNeedsShare = 0.9;

/// Forces of the walls of a group at one step [kN].
struct MeanPoint {
    double drift;           ///< [%]
    double mean, low, high; ///< low, high: 16 and 84 % of the walls lie below
    std::size_t walls;
    core::Interval interval; ///< of the mean; no bounds for one wall
};

/// At 0, 1, ... kCurveSteps steps, as far as kMeanNeedsShare of the curves of the group go: the
/// rest are not a fair sample.
[[nodiscard]] std::vector<MeanPoint> mean_points(const StudyWalls& walls,
                                                 const StudyLevel& level, int mode);

/// Mean force over drift with 16 and 84 % of the walls, per mode and stress: a table, and a
/// chart of each mode.
[[nodiscard]] Table mean_curve_table(const StudyWalls& walls);
[[nodiscard]] std::vector<NamedPicture> mean_curve_pictures(const StudyWalls& walls);

} // namespace app
