#pragma once
/// Drifts read from a table that a user brings.

#include "app/fragility/numbers/fragility_data.hpp"
#include "app/text/csv.hpp"

#include <string>
#include <vector>

namespace app {

/// Reads a table of values with commas, semicolons or tabs between them.
/// @throws ConfigError for a file that is not there, larger than 256 MiB or no text in UTF-8,
/// and as parse_csv
[[nodiscard]] Csv read_csv_file(const std::string& path);

/// 1, yes, y, true, censored: the value is a bound; 0, no, n, false, observed: it is not.
/// @throws ConfigError naming row and column
[[nodiscard]] bool read_censored(const Csv& csv, const CsvRow& row, std::size_t column);

/// Whether a cell says that its value is not known: empty, NA, N/A or -.
[[nodiscard]] bool is_missing(std::string_view text);

/// Values that no test of a wall has, in any of its units, lie outside of these: they would end
/// in numbers that are not finite.
inline constexpr double kLeastValue = 1e-9, kMostValue = 1e9;

/// Columns of a table, by name: "drift" or, with its unit, "drift [%]".
struct DriftColumns {
    std::vector<std::string> drift; ///< one or more limit states
    std::vector<std::string>
        censored;      ///< none: all values are observed; one for all, or one for each drift
    std::string group; ///< empty: one group
};

/// The drifts of each limit state, all > 0. The column of censoring says 1, yes, y, true or
/// censored where the wall had not reached the limit state at this drift, and 0, no, n, false
/// or observed where it had; a cell "> 2.27" says the same by itself. Empty cells and NA are
/// left out and counted. With semicolons or tabs 1,5 is read as 1.5. The head gives the unit in
/// brackets: [%], (%), [-], [rad], [permille], [mm], ...
/// @throws ConfigError with all mistakes of the table, by row and column: a column that is not
/// there, a cell that is no number, a value that is negative, zero or infinite
[[nodiscard]] DriftData drift_data(const Csv& csv, const DriftColumns& columns);

} // namespace app
