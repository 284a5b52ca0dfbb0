#pragma once
/// Words and units above the numbers of a record. Internal to ground/.

#include "ground/record_text.hpp"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace ground {

/// Words of a line, without brackets, quotes, separators and the sign of a comment.
[[nodiscard]] std::vector<std::string> words_of(std::string_view line);

/// Whether a line names columns, the first of them a time.
[[nodiscard]] bool names_columns(std::string_view line);

/// The unit of acceleration that the first lines state: the last one of the names of columns,
/// or else of any line. A lone G there is a letter, of a station or a component. Empty: none.
[[nodiscard]] std::string unit_above(const RecordText& text, std::size_t lines);

/// Refuses values that would be read in g because no unit is written, and are too large for it.
/// @param line index
void check_unsaid(const RecordText& text, std::size_t line, const std::vector<double>& values);

} // namespace ground
