#pragma once
/// The table of a measurement, as laboratories keep it: lines about the test before the head,
/// units in the head or in the line below it.

#include "app/text/csv.hpp"

#include <array>
#include <string>
#include <string_view>

namespace app {

/// A unit as unit_of() gives it.
struct MeasuredUnit {
    std::string_view name;
    double si; ///< its value in SI units
};
inline constexpr std::array kMeasuredLengths = {
    MeasuredUnit{"mm", 1e-3}, MeasuredUnit{"cm", 1e-2}, MeasuredUnit{"m", 1.0}};
inline constexpr std::array kMeasuredForces = {MeasuredUnit{"kn", 1e3}, MeasuredUnit{"n", 1.0},
                                               MeasuredUnit{"mn", 1e6}};

struct MeasuredTable {
    Csv csv;      ///< units stand behind the names of its head
    int line = 1; ///< of the head
};

/// The head is the last line before the first one of numbers; a line of units may stand between
/// both. Lines before the head are passed over.
/// @throws ConfigError where there is no head, or the file is no table (csv.hpp)
[[nodiscard]] MeasuredTable measured_table(const std::string& path, std::string text);

/// The last word of a head in small letters: "kn" of "force_kN" and of "Kraft [kN]"; a letter
/// alone is no unit.
[[nodiscard]] std::string unit_of(std::string_view head);

/// The words before the unit, in small letters: "force" of "Force [kN]".
[[nodiscard]] std::string quantity_of(std::string_view head);

} // namespace app
