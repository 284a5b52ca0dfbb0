#pragma once
/// Anyone's table: RFC 4180, separated by commas, semicolons or tabs.

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace app {

struct CsvRow {
    std::vector<std::string> cells; ///< as many as the head
    int line = 0;                   ///< where it starts, from 1
};

struct Csv {
    std::string path;              ///< names it in messages
    std::vector<std::string> head; ///< without blanks at both ends
    std::vector<CsvRow> rows;
    char separator = ',';
};

/// The text without a byte order mark; lines that end in CR alone, as those of old
/// spreadsheets, end in LF.
[[nodiscard]] std::string plain_text(std::string text);

/// Cells may be in double quotes, with "" for a quote and line breaks inside. Lines end in LF,
/// CRLF or CR; rows of empty cells, a last column of empty cells and a byte order mark are
/// passed over. The separator is the one that a first line "sep=;" names, or the most frequent
/// of comma, semicolon and tab in the head.
/// @throws ConfigError naming the line: no head, columns without or with equal names, too few
/// or too many cells, a quote that is not closed, or text behind it
[[nodiscard]] Csv parse_csv(const std::string& path, std::string_view text);

/// The column of this name: "drift", or with its unit "drift [%]".
/// @throws ConfigError if there is none, or several of it
[[nodiscard]] std::size_t find_column(const Csv& csv, std::string_view name);

/// The number in a cell, of either sign and finite; blanks around it are passed over. With
/// semicolons or tabs as separators 1,5 is read as 1.5.
/// @throws ConfigError naming row and column
[[nodiscard]] double signed_number_at(const Csv& csv, const CsvRow& row, std::size_t column);
/// Likewise, >= 0.
[[nodiscard]] double number_at(const Csv& csv, const CsvRow& row, std::size_t column);

/// The name of a column without its unit in brackets, [%] or (%).
[[nodiscard]] std::string_view bare_name(std::string_view head);

/// @throws ConfigError without a row below the head
void check_rows(const Csv& csv);

/// @throws ConfigError naming row and column
[[noreturn]] void refuse_cell(const Csv& csv, const CsvRow& row, std::size_t column,
                              const std::string& why);

} // namespace app
