#pragma once
/// The numbers of a wall that tests measure.

#include "app/calibration/measured_tests.hpp"
#include "app/reading/wall_response.hpp"

#include <array>
#include <limits>
#include <optional>
#include <string_view>

namespace app {

struct TestedQuantity {
    std::string_view name;                   ///< of its column: "peak"
    std::string_view words;                  ///< "peak force"
    std::string_view unit;                   ///< "kN"
    double scale;                            ///< shown value / value in SI
    int decimals;                            ///< of tables
    double (*read)(const WallReading& wall); ///< [SI]; NaN: not defined on this wall
    bool (*is_bound)(const WallReading& wall);
    std::optional<double> MeasuredTest::*measured; ///< shown value
    bool ends_with_test; ///< a test that ended before can only say that it is larger
    /// The key of the model's error of it in a study; empty: there is none.
    std::string_view factor_key;
};

[[nodiscard]] inline double secant_stiffness(const WallReading& w)
{
    return w.stiffness.value_or(std::numeric_limits<double>::quiet_NaN());
}

inline constexpr std::array kTestedQuantities = {
    TestedQuantity{"peak", "peak force", "kN", 1e-3, 1, peak_force, still_rising,
                   &MeasuredTest::peak, false, "fragility.model_factor_force"},
    TestedQuantity{"stiffness", "stiffness", "kN/mm", 1e-6, 2, secant_stiffness,
                   [](const WallReading&) { return false; }, &MeasuredTest::stiffness, false,
                   ""},
    TestedQuantity{"drop", "displacement at the drop", "mm", 1e3, 1, known_ultimate, never_fell,
                   &MeasuredTest::drop, true, "fragility.model_factor"}};

} // namespace app
