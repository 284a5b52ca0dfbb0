#pragma once
/// The numbers of a wall that tests measure.

#include "app/calibration/measured_tests.hpp"
#include "app/reading/wall_numbers.hpp"

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace app {

struct TestedQuantity {
    std::string name;         ///< of its column: "peak", "force at 5 mm"
    std::string words;        ///< "peak force"
    std::string unit;         ///< in which it is shown
    const WallNumber* number; ///< that does not depend on the height; nothing: a reading
    int decimals;             ///< of tables
    std::optional<double> MeasuredTest::*measured; ///< shown value; nothing: of the readings
    std::size_t reading = 0;                       ///< place in MeasuredTest::readings
    TestReading at{};                              ///< where it is read
    /// The key of the model's error of it in a study; empty: there is none.
    std::string_view factor_key{};
};

/// Lines "note: tests.csv:1: ..." on what a push cannot show of the tests, before it is made.
/// @param targets of the push, in order [m]
/// @throws ConfigError if it can show nothing of them
[[nodiscard]] std::string protocol_notes(const Csv& csv,
                                         const std::vector<TestReading>& readings,
                                         const std::vector<MeasuredTest>& tests,
                                         const std::vector<double>& targets);

/// Peak, stiffness and drop, then the readings of a table, in the order of its columns.
[[nodiscard]] std::vector<TestedQuantity>
tested_quantities(const std::vector<TestReading>& readings);

/// Value of a test, as it is shown.
[[nodiscard]] std::optional<double> measured(const TestedQuantity& q, const MeasuredTest& t);

/// A wall as it was read, and its curve [m] [N].
struct TestedPath {
    const WallReading& wall;
    std::span<const double> displacement, force;
};

/// Whether any test has a value of it.
[[nodiscard]] bool is_tested(const std::vector<MeasuredTest>& tests, const TestedQuantity& q);

/// Shown value; NaN: not defined on this wall.
[[nodiscard]] double shown(const TestedQuantity& q, const TestedPath& path,
                           const ReadingRules& rules);

/// Whether the push ended before the wall had shown it.
[[nodiscard]] inline bool is_bound(const TestedQuantity& q, const WallReading& wall)
{
    return q.number != nullptr && q.number->is_bound != nullptr && q.number->is_bound(wall);
}

/// Whether a push that ends before can only say that it is larger.
[[nodiscard]] inline bool ends_with_push(const TestedQuantity& q)
{
    return q.number != nullptr && q.number->ends_with_push;
}

} // namespace app
