#pragma once
/// Wide tables in parts that a page or a terminal takes.

#include "app/output/table/table.hpp"

#include <cstddef>
#include <vector>

namespace app {

constexpr std::size_t kColumnGap = 2; ///< between two columns [characters]

/// Characters of the longest text in each column, the head too.
[[nodiscard]] std::vector<std::size_t> column_widths(const ShownTable& t);

/// Blocks of columns, each with the first `keys` columns, none wider than `most` characters
/// where its columns allow; as few as possible.
/// @param widths of the columns [characters]
/// @param most 0: no limit
[[nodiscard]] std::vector<ShownTable> parts_of(const ShownTable& t,
                                               const std::vector<std::size_t>& widths,
                                               std::size_t keys, std::size_t most);

} // namespace app
