#pragma once
/// A table that reads well in a terminal and pastes into a paper.

#include <string>
#include <vector>

namespace app {

struct Table {
    std::string caption;
    std::vector<std::string> head; ///< with units: "peak [kN]"
    std::vector<std::vector<std::string>>
        rows; ///< as many cells as the head; empty: not defined
};

[[nodiscard]] std::string as_text(const Table& table);     ///< aligned columns
[[nodiscard]] std::string as_csv(const Table& table);      ///< RFC 4180
[[nodiscard]] std::string as_markdown(const Table& table); ///< caption above
[[nodiscard]] std::string
as_latex(const Table& table); ///< a table environment with booktabs rules

} // namespace app
