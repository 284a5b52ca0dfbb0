#pragma once
/// Results of `fragility/` as cells of tables and as words.

#include "app/output/cells.hpp"
#include "fragility/interval.hpp"
#include "fragility/median_bound.hpp"

#include <span>
#include <string>
#include <string_view>

namespace app {

/// Largest drift at which any of these walls reached the limit state or still stood [unit of the
/// data]: no wall was tested beyond it. 0 without walls.
[[nodiscard]] double known_to(std::span<const fragility::Observation> limits);

/// What the dagger of a cell means, for captions: "†: extrapolated, ...".
[[nodiscard]] std::string extrapolated_text(const std::string& whose);

/// known_to, or where runs ended together there, the first of their ends: beyond it the few that went
/// on would stand for all [unit of the data].
[[nodiscard]] double common_end(std::span<const fragility::Observation> limits);

/// "1.58 [1.40, 1.80]"
[[nodiscard]] Number with_interval(double value, const fragility::Interval& interval,
                                   int decimals, double known_to = kNoEnd);

/// "> 2.72" or ">= 4.00", as the lower bound of a value that is not known; nothing without a bound.
[[nodiscard]] Number median_bound(const fragility::MedianBound& bound, int decimals);

/// "95 %"
[[nodiscard]] std::string percent_text(double share);

/// Letters, digits and "-._" of a name of a file; every other character becomes "_". At most 60
/// characters. Two names can become one: see UniqueNames.
[[nodiscard]] std::string file_name(std::string_view text);

} // namespace app
