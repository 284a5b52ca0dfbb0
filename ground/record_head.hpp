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

/// Whether a line names columns, the first of them a time: by its first word, or in any
/// language by a unit of time in its first brackets.
[[nodiscard]] bool names_columns(std::string_view line);

/// The unit that the lines above the numbers state.
struct HeadUnit {
    std::string unit;     ///< of acceleration, as written; empty: none
    bool alone = false;   ///< in brackets of its own above the columns
    std::size_t line = 0; ///< index of the line that says so
    std::string doubt;    ///< why it cannot be told and what to write; empty: it can
};

/// The unit of acceleration in the first lines. Lines that name columns, then the one next to
/// the numbers, count before comments. A unit behind a number is one of a value (PGA = 0.3 g),
/// and a lone G beside another unit is a station or component. Two units, parts of units
/// (% g) and units of other quantities leave a doubt.
[[nodiscard]] HeadUnit unit_above(const RecordText& text, std::size_t lines);

/// Refuses values that are too large for g, where g is not written in brackets above them.
/// @param line index of the line to name if no unit is written
void check_large(const RecordText& text, std::size_t line, const HeadUnit& head,
                 const std::vector<double>& values);

} // namespace ground
