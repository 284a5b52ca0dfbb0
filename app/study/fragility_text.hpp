#pragma once
/// Numbers with their doubt as cells of tables, and such cells taken apart again.

#include "app/output/table.hpp"
#include "fragility/interval.hpp"
#include "fragility/median_bound.hpp"

#include <limits>
#include <span>
#include <string>
#include <string_view>

namespace app {

/// Beside a drift beyond the one up to which walls were seen: the law alone says it.
constexpr std::string_view kExtrapolated = "\u2020"; // dagger

/// Largest drift at which any of these walls reached the limit state or still stood [unit of the
/// data]: beyond it nothing was seen. 0 without walls.
[[nodiscard]] double known_to(std::span<const fragility::Observation> limits);

/// What the mark of extrapolation means, for captions.
[[nodiscard]] std::string extrapolated_text(const std::string& whose);

/// Runs of one push end up to an interval of their curve apart [-]: as good as together.
constexpr double kEndsTogether = 2e-3;

/// known_to, or where runs ended together there, the first of their ends: beyond it the few that went
/// on would stand for all [unit of the data].
[[nodiscard]] double common_end(std::span<const fragility::Observation> limits);

constexpr double kNoEnd = std::numeric_limits<double>::infinity();

/// "1.58", "3.03†": beyond `known_to` by more than 0.2 %
[[nodiscard]] std::string with_mark(double value, int decimals, double known_to);

/// "1.58 [1.40, 1.80]", "2.11 [1.67, 2.87†]"; a bound that the data do not give is "no limit". Empty
/// for a value that is not finite.
[[nodiscard]] std::string with_interval(double value, double lower, double upper, int decimals,
                                        double known_to = kNoEnd);
[[nodiscard]] std::string with_interval(double value, const fragility::Interval& interval,
                                        int decimals, double known_to = kNoEnd);

/// Of a lower bound: rounded down, so that it stays one.
[[nodiscard]] std::string rounded_down(double value, int decimals);

/// "> 2.72" or ">= 4.00" from a bound of the median; empty without one.
[[nodiscard]] std::string median_bound(const fragility::MedianBound& bound, int decimals);

/// "16.2 +- 0.3"
[[nodiscard]] std::string with_error(double value, double std_error, int decimals);

/// Decimals that show three digits of a value of this size, in 0 .. 6.
[[nodiscard]] int decimals_for(double size);

/// "95 %"
[[nodiscard]] std::string percent_text(double share);

/// For programs: columns of which any cell is "value [lower, upper]" or "value +- error" become
/// columns of their own, "<head> lower", "<head> upper", "<head> std error"; other cells stay in
/// the first. Marks of extrapolation are taken off; where a value of a column had one, a column
/// "<head> extrapolated" says 1 or 0 for each number (bounds: compare them with "known to").
[[nodiscard]] Table plain_numbers(const Table& table);

/// Letters, digits and "-._" of a name of a file; others become "_".
[[nodiscard]] std::string file_name(const std::string& text);

} // namespace app
