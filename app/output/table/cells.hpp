#pragma once
/// Numbers as cells of a table.

#include "app/output/table/table.hpp"

#include <cmath>
#include <string>

namespace app {

/// A count, without decimals.
[[nodiscard]] Number count(auto n) { return {.value = static_cast<double>(n), .decimals = 0}; }

/// A number as the user gave it: 0.4, where a change of units left 0.39999999999999997.
[[nodiscard]] Number given(double x);

[[nodiscard]] inline Number plain_number(double value, int decimals)
{
    return {.value = value, .decimals = decimals};
}

/// "16.2 +- 0.3"
[[nodiscard]] inline Number with_error(double value, double std_error, int decimals)
{
    return {.value = value, .error = std_error, .decimals = decimals};
}

/// "1.58 [1.40, 1.80]"; what lies beyond `known_to` is marked. Bounds of a value that is not
/// known are dropped with it.
[[nodiscard]] inline Number with_interval(double value, double lower, double upper,
                                          int decimals, double known_to = kNoEnd)
{
    if (!std::isfinite(value)) return {};
    return {.value = value,
            .lower = lower,
            .upper = upper,
            .decimals = decimals,
            .known_to = known_to};
}

/// @param interval has `lower` and `upper`
template <class Interval>
[[nodiscard]] Number with_interval(double value, const Interval& interval, int decimals,
                                   double known_to = kNoEnd)
{
    return with_interval(value, interval.lower, interval.upper, decimals, known_to);
}

/// A share and its interval in percent.
template <class Interval>
[[nodiscard]] Number percent(double share, const Interval& interval, int decimals)
{
    return with_interval(100.0 * share, 100.0 * interval.lower, 100.0 * interval.upper,
                         decimals);
}

/// "0.0 to 45.9"
[[nodiscard]] inline Number range(double lower, double upper, int decimals)
{
    return {.lower = lower, .upper = upper, .decimals = decimals};
}

/// Decimals that show three digits of a value of this size, in 0 .. 6.
[[nodiscard]] int decimals_for(double size);

/// A vertical stress [Pa] as a cell in MPa.
[[nodiscard]] inline Number stress_cell(double stress) { return given(stress / 1e6); }

/// The cells of `start`, followed by those of `more`.
[[nodiscard]] Row joined(Row start, Row more);

/// Adds a row to a table whose last column is a note: cells that are missing before it are
/// empty.
void add_row(Table& table, Row cells, std::string note = {});

} // namespace app
