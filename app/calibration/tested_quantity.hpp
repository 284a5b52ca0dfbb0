#pragma once
/// The numbers of a wall that tests measure.

#include "app/calibration/measured_tests.hpp"
#include "app/reading/wall_numbers.hpp"

#include <array>
#include <optional>
#include <string_view>

namespace app {

struct TestedQuantity {
    std::string_view name;    ///< of its column: "peak"
    std::string_view words;   ///< "peak force"
    const WallNumber* number; ///< a reading that does not depend on the height
    int decimals;             ///< of tables
    std::optional<double> MeasuredTest::*measured; ///< shown value
    /// The key of the model's error of it in a study; empty: there is none.
    std::string_view factor_key;
};

inline constexpr std::array kTestedQuantities = {
    TestedQuantity{"peak", "peak force", &wall_number("peak_force"), 1, &MeasuredTest::peak,
                   "fragility.model_factor_force"},
    TestedQuantity{"stiffness", "stiffness", &wall_number("secant_stiffness"), 2,
                   &MeasuredTest::stiffness, ""},
    TestedQuantity{"drop", "displacement at the drop", &wall_number("ultimate_displacement"), 1,
                   &MeasuredTest::drop, "fragility.model_factor"}};

/// Shown value; NaN: not defined on this wall.
[[nodiscard]] inline double shown(const TestedQuantity& q, const WallReading& wall)
{
    constexpr double kAnyHeight = 1.0;
    return q.number->unit.scale * q.number->reading(wall, kAnyHeight);
}

/// Whether the push ended before the wall had shown it.
[[nodiscard]] inline bool is_bound(const TestedQuantity& q, const WallReading& wall)
{
    return q.number->is_bound != nullptr && q.number->is_bound(wall);
}

} // namespace app
