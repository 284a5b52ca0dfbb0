#pragma once
/// A user's own tests, as a table.

#include "app/calibration/test_columns.hpp"

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
    std::optional<double> drop; ///< displacement at the drop to the ultimate share of the peak
                                ///< [mm], > 0
    bool censored = false;      ///< the test ended before that
    int line = 0;               ///< of the table, for messages
    std::optional<double> stiffness = {}; ///< secant [kN/mm], > 0
    double error = 0.0; ///< known error of the measurement, relative [-], in [0, 1]
    std::vector<std::optional<double>> readings = {}; ///< [kN] [J], > 0, one for each column
};

/// The rows of a table that has a stress and one or more values that were measured. A drop in %
/// is a drift; sigma is the error of the measurement.
/// "> 22.7" under drop: the test ended before. Rows of one stress are repeats.
/// @param height of the load [m], > 0, under which a drift becomes a displacement
/// @throws ConfigError as test_columns, and naming row and column: no number, 0, a stress
/// without any value
[[nodiscard]] std::vector<MeasuredTest> measured_tests(const Csv& csv, double height);

/// @param stresses of the study [Pa]
/// @throws ConfigError at the row of a test whose stress is not among them
void check_stresses(const Csv& csv, std::span<const MeasuredTest> tests,
                    std::span<const double> stresses);

/// Whether a test and a level of a study have the same vertical stress [Pa].
[[nodiscard]] bool same_stress(double a, double b);

} // namespace app
