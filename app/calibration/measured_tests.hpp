#pragma once
/// A user's own tests, as a table.

#include "app/text/csv.hpp"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace app {

/// A reading of the path of a wall that a column holds.
struct TestReading {
    std::string name;          ///< of the column: "force at 5 mm", "energy of cycle 3"
    double displacement = 0.0; ///< of the load at which the force is read [m], > 0
    int cycle = 0;             ///< whose energy is read, from 1; 0: a force is read
};

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

/// Columns "stress [MPa]", and one or more of "peak [kN]", "stiffness [kN/mm]", "drop [mm]" or
/// "drop [%]", a drift, and those of test_readings(); "censored", "sigma" (error of the
/// measurement) and "wall" if there.
/// "> 22.7" under drop: the test ended before. Rows of one stress are repeats.
/// @param height of the load [m], > 0, under which a drift becomes a displacement
/// @throws ConfigError naming row and column: no such column, another unit, no number, 0, a
/// stress without any value
[[nodiscard]] std::vector<MeasuredTest> measured_tests(const Csv& csv, double height);

/// Columns "force at 5 mm [kN]", "force at 0.5 % [kN]" (a drift) and "energy of cycle 3 [J]" or
/// "[kJ]", in the order of the table.
/// @throws ConfigError naming a column whose place cannot be read, or that stands there twice
[[nodiscard]] std::vector<TestReading> test_readings(const Csv& csv, double height);

/// @param stresses of the study [Pa]
/// @throws ConfigError at the row of a test whose stress is not among them
void check_stresses(const Csv& csv, std::span<const MeasuredTest> tests,
                    std::span<const double> stresses);

/// Whether a test and a level of a study have the same vertical stress [Pa].
[[nodiscard]] bool same_stress(double a, double b);

} // namespace app
