#pragma once
/// A user's own tests against the walls of a study: a factor of the model of their own.

#include "app/fragility/tested_walls.hpp"
#include "app/output/table.hpp"
#include "app/study/study_walls.hpp"
#include "app/text/csv.hpp"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace app {

/// A row of a table of tests.
struct MeasuredTest {
    std::string name;           ///< of the wall; empty: none given
    double stress = 0.0;        ///< vertical [Pa], > 0
    std::optional<double> peak; ///< [kN], > 0
    std::optional<double>
        drop; ///< displacement at the drop to the ultimate share of the peak [mm], > 0
    bool censored = false; ///< the test ended before that
    int line = 0;          ///< of the table, for messages
};

/// Columns "stress [MPa]", and "peak [kN]", "drop [mm]" or both; "censored" and "wall" if
/// there. Rows of one stress are repeats.
/// @throws ConfigError naming row and column: no such column, another unit, no number, 0, a
/// stress without any value
[[nodiscard]] std::vector<MeasuredTest> measured_tests(const Csv& csv);

/// @param stresses of the study [Pa]
/// @throws ConfigError at the row of a test whose stress is not among them
void check_stresses(const Csv& csv, std::span<const MeasuredTest> tests,
                    std::span<const double> stresses);

/// The tests over the medians of the study's walls under the same stress. Tests without such a
/// value are left out. `predicted` is 0 where fewer than half of the walls fell.
/// @throws ConfigError at the row of a test whose stress the study does not have
[[nodiscard]] std::vector<TestedWall> tests_over_walls(const Csv& csv,
                                                       const std::vector<MeasuredTest>& tests,
                                                       const StudyWalls& walls, Answer answer);

/// One factor, or the reason why there is none.
struct Calibration {
    std::vector<TestedWall> walls;
    std::optional<EstimatedFactor> factor;
    std::string reason; ///< empty where there is a factor
};
/// Three measured values are needed, bounds not counted.
[[nodiscard]] Calibration calibrated(std::vector<TestedWall> walls);

/// Test, prediction, ratio, and the 90 % interval of the ratio that the other tests give.
[[nodiscard]] Table calibration_table(const Calibration& drift, const Calibration& force);

/// The lines to put into a study file, with what they rest on as comments.
[[nodiscard]] std::string factor_lines(const Calibration& drift, const Calibration& force,
                                       const std::string& source);

} // namespace app
