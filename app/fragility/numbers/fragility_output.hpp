#pragma once
/// Output of the verb fragility: tables, pictures, one file with everything, and an index.

#include "app/output/table/table.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace app {

struct NamedTable {
    std::string name; ///< of its files, without ending
    Table table;
    bool answer = false; ///< what one came for: on top of the folder, and in its README.md
    std::vector<std::size_t> main{}; ///< rows that stand for a table too long for a terminal
    bool in_summary = false;         ///< the summary that the verb study prints has its numbers
};

/// The table as a terminal gets it unless it asks for all. It has no column of kDetail. A table
/// of more than this many rows is cut to its main ones, at most so many.
constexpr std::size_t kShortRows = 10;
[[nodiscard]] Table short_table(const NamedTable& named);

struct NamedPicture {
    std::string name;
    std::string title;
    std::string svg;
};

struct FragilityOutput {
    std::string source;  ///< what it was made from, with counts
    std::string remarks; ///< lines: failed and missing walls, warnings
    std::size_t told_by_study =
        0; ///< bytes at their beginning: study_remarks, which the verb study prints
    std::vector<NamedTable> tables;
    std::vector<NamedPicture> pictures;
    std::string pelicun;     ///< CSV; empty: not written
    std::string openquake{}; ///< XML; empty: not written
};

/// All tables with their captions and rows as in the CSV, cells that are empty as null; one
/// object.
[[nodiscard]] std::string fragility_json(const FragilityOutput& output);

/// Gives tables, and pictures, unique names.
void make_names_unique(FragilityOutput& output);

/// README.md, which begins with the answers; fragility.json, pelicun_fragility.csv,
/// openquake_fragility.xml; <name>.csv,
/// .md, .tex of every answer; all other tables in tables/, pictures as <name>.svg in pictures/.
/// The CSV has no caption: it is in the .md beside it.
/// @return how many files of an earlier run were removed
/// @throws as write_results
std::size_t write_output(const std::filesystem::path& folder, const FragilityOutput& output);

} // namespace app
