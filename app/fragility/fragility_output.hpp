#pragma once
/// What the verb fragility writes: tables, pictures, one file with everything, and an index.

#include "app/output/table.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace app {

struct NamedTable {
    std::string name; ///< of its files, without ending
    Table table;
};

struct NamedPicture {
    std::string name;
    std::string title;
    std::string svg;
};

struct FragilityOutput {
    std::string source;  ///< what it was made from, with counts
    std::string remarks; ///< lines: failed and missing walls, warnings
    std::vector<NamedTable> tables;
    std::vector<NamedPicture> pictures;
    std::string pelicun; ///< CSV
};

/// All tables with their captions and rows as in the CSV, cells that are empty as null; one object.
[[nodiscard]] std::string fragility_json(const FragilityOutput& output);

/// README.md, fragility.json, pelicun_fragility.csv; <name>.csv, .md, .tex of every table; <name>.svg of
/// every picture. The CSV has no caption: it is in the .md beside it.
/// @throws std::runtime_error as write_file
void write_output(const std::filesystem::path& folder, const FragilityOutput& output);

} // namespace app
