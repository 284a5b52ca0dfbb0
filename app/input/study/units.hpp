#pragma once
/// Numbers of a study file with their units, to and from SI. Independent of the locale.

#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace app {

/// Why a text is not the value asked for, and what to write instead; who reads it adds the
/// place.
struct BadValue : std::invalid_argument {
    using std::invalid_argument::invalid_argument;
};

/// One number with its unit, such as "0.20 m".
/// @param unit one of the units that may follow, "" if the quantity has none
/// @return in SI, finite
/// @throws BadValue
[[nodiscard]] double parse_quantity(std::string_view text, std::string_view unit);

/// One or more: "0.15, 0.50 MPa", with the unit once at the end or on each of them.
[[nodiscard]] std::vector<double> parse_quantities(std::string_view text,
                                                   std::string_view unit);

/// A whole number, exact in a double: "10", "2e5".
[[nodiscard]] double parse_count(std::string_view text);

/// @param unit a unit of parse_quantity
[[nodiscard]] double to_si(double value, std::string_view unit);

/// @param unit a unit of parse_quantity
[[nodiscard]] double from_si(double si, std::string_view unit);

/// The SI unit of the same quantity: "Pa" of "MPa"; empty for an empty one.
[[nodiscard]] std::string_view si_unit(std::string_view unit);

/// A value for people, with 12 digits, so that three courses of 0.4 m end at 1.2 m.
[[nodiscard]] std::string quantity_text(double si, std::string_view unit);

/// The shortest text that parse_quantities reads back to the same bits; in SI where this unit
/// has no such text.
[[nodiscard]] std::string format_quantities(std::span<const double> si, std::string_view unit);

} // namespace app
