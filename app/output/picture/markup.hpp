#pragma once
/// Any text as a part of CSV, Markdown, LaTeX or a terminal, where it reads as it was given and
/// obeys nothing.

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace app {

/// A text to be found and the text that is written for it.
struct Replacement {
    std::string_view found, written;
};

/// The text with each place replaced by the first entry of the table that matches there.
[[nodiscard]] std::string replaced(std::string_view text, std::span<const Replacement> table);

/// RFC 4180: in double quotes where a separator, a quote or a line break would cut it. Names
/// come from drawings and tables of others: a spreadsheet runs what begins with = + - @ as a
/// formula, so such a text gets an apostrophe, which spreadsheets take for "text follows".
[[nodiscard]] std::string csv_cell(const std::string& text);

/// Bars, tags, links and backslashes read as they are; line breaks become blanks.
[[nodiscard]] std::string markdown_text(std::string_view text);

/// Signs that LaTeX obeys are escaped, also "[" and "*" at the start, which would follow a
/// "\\".
[[nodiscard]] std::string latex_text(std::string_view text);

/// Lines of at most `width` characters, broken at blanks; a longer word stands alone. 0: one
/// line.
[[nodiscard]] std::string wrapped(const std::string& text, std::size_t width);

/// The text with lines of at most `width` columns. A line that is longer is broken at blanks
/// and goes on below its last column, or indented by two.
[[nodiscard]] std::string hung(const std::string& text, std::size_t width);

/// Characters of UTF-8, of one column each.
[[nodiscard]] std::size_t shown_width(std::string_view text);

/// Columns of the terminal that stdout writes to; 100 where stdout is not a terminal.
[[nodiscard]] std::size_t terminal_width();

} // namespace app
