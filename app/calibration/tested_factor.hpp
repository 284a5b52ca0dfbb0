#pragma once
/// A user's own tests against the walls of a study: a factor of the model of their own.

#include "app/calibration/measured_tests.hpp"
#include "app/fragility/numbers/tested_walls.hpp"
#include "app/output/table/table.hpp"
#include "app/study/stored/study_walls.hpp"
#include "app/text/csv.hpp"

#include <optional>
#include <string>
#include <vector>

namespace app {

/// The tests over the medians of the study's walls under the same stress. Tests without such a
/// value are left out. `predicted` is 0 where fewer than half of the walls fell.
/// @throws ConfigError at the row of a test whose stress the study does not have
[[nodiscard]] std::vector<TestedWall> tests_over_walls(const Csv& csv,
                                                       const std::vector<MeasuredTest>& tests,
                                                       const StudyWalls& walls, Answer answer);

/// One factor, or the reason why there is none.
struct TestedFactor {
    std::vector<TestedWall> walls;
    std::optional<EstimatedFactor> factor;
    std::string reason; ///< empty where there is a factor
};
/// Three measured values are needed, bounds not counted.
[[nodiscard]] TestedFactor tested_factor(std::vector<TestedWall> walls);

/// Test, prediction, ratio, and the 90 % interval of the ratio that the other tests give.
[[nodiscard]] Table factor_table(const TestedFactor& drift, const TestedFactor& force);

/// The lines to put into a study file, with what they rest on as comments.
[[nodiscard]] std::string factor_lines(const TestedFactor& drift, const TestedFactor& force,
                                       const std::string& source);

} // namespace app
