#pragma once
/// Numbers as text: independent of the locale, and never "nan" or "inf".

#include <string>

namespace app {

/// Shortest text of `value` with at most `digits` significant digits, "1e-05" style where that
/// is shorter. Empty for NaN and infinities: an empty cell of a table.
/// @param digits in [1, 17]; 17 gives back the same double when read
[[nodiscard]] std::string number(double value, int digits);

/// The nearest double with at most `digits` significant digits; a value that is not finite is
/// returned unchanged.
[[nodiscard]] double rounded(double value, int digits);

/// `value` with `decimals` places after the point, never "-0.0". Empty for NaN and infinities.
/// @param decimals in [0, 17]
[[nodiscard]] std::string fixed(double value, int decimals);

/// The same, with two digits where `decimals` would leave none of a value that is not zero:
/// "0.0042".
[[nodiscard]] std::string never_rounded_away(double value, int decimals);

/// Significant digits of a number that has gone through a change of units: 0.6 m are 600 mm,
/// not 600.0000000000001.
inline constexpr int kAfterUnits = 15;

} // namespace app
