#pragma once
/// The files of a table: .csv for programs, .md and .tex for people.

#include "app/output/result_folder.hpp"
#include "app/output/table/table.hpp"

#include <array>

namespace app {

inline constexpr std::array kTableEndings = {".csv", ".md", ".tex"};

/// @param stem path without ending
[[nodiscard]] std::array<OutputFile, 3> table_files(const std::string& stem,
                                                    const Table& table);

/// Puts them behind `files`.
void add_table(std::vector<OutputFile>& files, const std::string& stem, const Table& table);

} // namespace app
