#pragma once
/// Anyone's table of drifts: RFC 4180, separated by commas, semicolons or tabs.

#include "app/fragility/fragility_data.hpp"

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace app {

struct CsvRow {
    std::vector<std::string> cells; ///< as many as the head
    int line = 0;                   ///< where it starts, from 1
};

struct Csv {
    std::vector<std::string> head; ///< without blanks at both ends
    std::vector<CsvRow> rows;
    char separator = ',';
};

/// Cells may be in double quotes, with "" for a quote and line breaks inside. Lines end in LF or
/// CRLF; rows of empty cells and a byte order mark are passed over. The separator is the one that a first
/// line "sep=;" names, or the most frequent of comma, semicolon and tab in the head.
/// @param path only names it
/// @throws ConfigError naming the line: no head, columns without or with equal names, too few or too
/// many cells, a quote that is not closed, or text behind it
[[nodiscard]] Csv parse_csv(const std::string& path, std::string_view text);

/// The column of this name: "drift", or with its unit "drift [%]".
/// @throws ConfigError if there is none, or several of it
[[nodiscard]] std::size_t find_column(const std::string& path, const Csv& csv,
                                      std::string_view name);

/// The number in a cell, >= 0. With semicolons or tabs as separators 1,5 is read as 1.5.
/// @throws ConfigError naming row and column
[[nodiscard]] double number_at(const std::string& path, const Csv& csv, const CsvRow& row,
                               std::size_t column);

/// Columns of a table, by name: "drift" or, with its unit, "drift [%]".
struct DriftColumns {
    std::vector<std::string> drift; ///< one or more limit states
    std::vector<std::string>
        censored;      ///< none: all values are observed; one for all, or one for each drift
    std::string group; ///< empty: one group
};

/// @throws ConfigError without a row below the head
void check_rows(const std::string& path, const Csv& csv);

/// Drifts > 0; in the column of censoring 1, yes, y, true, censored: the wall had not reached the limit state
/// at this drift; 0, no, n, false, observed: it did. "> 2.27" says so in the cell itself. Empty cells and NA:
/// not known, left out and counted. With semicolons or tabs 1,5 is read as 1.5.
/// Units: those in brackets in the head, [%], (%), [-], [rad], [permille], [mm], ...
/// @throws ConfigError with all mistakes of the table, by row and column: no such column; a zero, infinite
/// or negative value, no number
[[nodiscard]] DriftData drift_data(const std::string& path, const Csv& csv,
                                   const DriftColumns& columns);

} // namespace app
