#pragma once
/// The columns of a table of tests.

#include "app/text/csv.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace app {

/// A column that a table of tests may have.
struct TestHead {
    std::string_view name;
    std::array<std::string_view, 2> units; ///< allowed in brackets; first "-": none needed
    bool inputs_only = false; ///< only calibration.inputs learns from it, and a factor does not
};

inline constexpr TestHead kTestStress{"stress", {"MPa"}}, kTestPeak{"peak", {"kN"}},
    kTestStiffness{"stiffness", {"kN/mm"}, true}, kTestDrop{"drop", {"mm", "%"}},
    kTestCensored{"censored", {"-"}}, kTestSigma{"sigma", {"-", "%"}, true},
    kTestWall{"wall", {"-"}};

inline constexpr std::array kTestHeads{kTestStress,   kTestPeak,  kTestStiffness, kTestDrop,
                                       kTestCensored, kTestSigma, kTestWall};

/// A reading of the path of a wall that a column holds.
struct TestReading {
    std::string name;          ///< of the column: "force at 5 mm", "energy of cycle 3"
    double displacement = 0.0; ///< of the load at which the force is read [m], > 0
    int cycle = 0;             ///< whose energy is read, from 1; 0: a force is read
};

/// Where a table has a column.
struct TestColumn {
    std::size_t place = 0;
    bool second_unit = false; ///< its unit is the second of those allowed
};

/// The columns of one table.
struct TestColumns {
    std::optional<TestColumn> stress, peak, stiffness, drop, censored, sigma, wall;
    std::vector<TestReading> readings;
    std::vector<TestColumn> reading_at; ///< of each
};

/// Name of a column without its unit, in small letters: "Stress [MPa]" is "stress".
[[nodiscard]] std::string test_name(std::string_view head);

/// Columns "force at 5 mm [kN]", "force at 0.5 % [kN]" (a drift) and "energy of cycle 3 [J]" or
/// "[kJ]", in the order of the table.
/// @param height of the load [m], > 0
/// @throws ConfigError naming a column whose place cannot be read, or that stands there twice
[[nodiscard]] std::vector<TestReading> test_readings(const Csv& csv, double height);

/// @param height of the load [m], > 0
/// @throws ConfigError naming a column without its unit, in another unit or that stands there
/// twice, and where there is no stress or nothing that was measured
[[nodiscard]] TestColumns test_columns(const Csv& csv, double height);

} // namespace app
