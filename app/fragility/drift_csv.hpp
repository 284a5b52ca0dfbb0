#pragma once
/// Drifts from anyone's table.

#include "app/fragility/fragility_data.hpp"
#include "app/text/csv.hpp"

#include <string>
#include <vector>

namespace app {

/// Columns of a table, by name: "drift" or, with its unit, "drift [%]".
struct DriftColumns {
    std::vector<std::string> drift; ///< one or more limit states
    std::vector<std::string>
        censored;      ///< none: all values are observed; one for all, or one for each drift
    std::string group; ///< empty: one group
};

/// Drifts > 0; in the column of censoring 1, yes, y, true, censored: the wall had not reached the limit state
/// at this drift; 0, no, n, false, observed: it did. "> 2.27" says so in the cell itself. Empty cells and NA:
/// not known, left out and counted. With semicolons or tabs 1,5 is read as 1.5.
/// Units: those in brackets in the head, [%], (%), [-], [rad], [permille], [mm], ...
/// @throws ConfigError with all mistakes of the table, by row and column: no such column; a zero, infinite
/// or negative value, no number
[[nodiscard]] DriftData drift_data(const Csv& csv, const DriftColumns& columns);

} // namespace app
