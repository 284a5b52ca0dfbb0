#pragma once
/// Measurements as committed: a Markdown file that says where its numbers come from, each of
/// its tables as CSV next to it.

#include "app/output/table/table.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace bench {

struct Section {
    std::string name;  ///< of its CSV: OUT-name.csv; empty: OUT.csv
    std::string title; ///< heading; empty: none
    std::string text;  ///< paragraphs above the table; may be empty
    app::Table table;
};

struct Report {
    std::string title;
    std::string opening;
    std::vector<Section> sections;
};

/// Machine, caches and command under the title, then section by section.
[[nodiscard]] std::string as_markdown(const Report& report);

/// Writes `path` (.md) and the tables next to it.
/// @throws std::runtime_error naming the file that could not be written
void write_report(const std::filesystem::path& path, const Report& report);

} // namespace bench
