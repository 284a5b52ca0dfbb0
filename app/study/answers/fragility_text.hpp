#pragma once
/// Results of `fragility/` as cells of tables and as words.

#include "app/output/table/cells.hpp"
#include "fragility/curve/curve_reading.hpp"
#include "fragility/fits/median_bound.hpp"

#include <string>
#include <string_view>

namespace app {

/// "> 2.72" or ">= 4.00", as the lower bound of a value that is not known; nothing without a
/// bound.
[[nodiscard]] Number median_bound(const fragility::MedianBound& bound, int decimals);

/// A displacement [m] times `scale`; ">" where the wall had not reached it when its push ended;
/// nothing where it is not defined.
[[nodiscard]] Number limit_cell(const fragility::LimitDisplacement& limit, double scale,
                                int decimals);

/// "95 %"
[[nodiscard]] std::string percent_text(double share);

/// Letters, digits and "-._" of a name of a file; every other character becomes "_". At most 60
/// characters. Two names can become one: see UniqueNames.
[[nodiscard]] std::string file_name(std::string_view text);

} // namespace app
