#pragma once
/// Numbers with their doubt as cells of tables, and such cells taken apart again.

#include "app/table.hpp"
#include "fragility/interval.hpp"

#include <string>

namespace app {

/// "1.58 [1.40, 1.80]"; a bound that the data do not give is "no limit". Empty for a value that is
/// not finite.
[[nodiscard]] std::string with_interval(double value, double lower, double upper, int decimals);
[[nodiscard]] std::string with_interval(double value, const fragility::Interval& interval,
                                        int decimals);

/// "16.2 +- 0.3"
[[nodiscard]] std::string with_error(double value, double std_error, int decimals);

/// Decimals that show three digits of a value of this size, in 0 .. 6.
[[nodiscard]] int decimals_for(double size);

/// "95 %"
[[nodiscard]] std::string percent_text(double share);

/// For programs: columns of which any cell is "value [lower, upper]" or "value +- error" become
/// columns of their own, "<head> lower", "<head> upper", "<head> std error"; other cells stay in
/// the first.
[[nodiscard]] Table plain_numbers(const Table& table);

/// Letters, digits and "-._" of a name of a file; others become "_".
[[nodiscard]] std::string file_name(const std::string& text);

} // namespace app
