#pragma once
/// Titles and captions of the tables, from app/fragility/numbers/table_texts.txt.

#include "app/fragility/numbers/fragility_data.hpp"
#include "app/output/table/table.hpp"
#include "app/study/stored/study_walls.hpp"

#include <map>
#include <string>
#include <string_view>

namespace app {

/// The file as it is built into the program.
[[nodiscard]] std::string_view table_texts();

using Words = std::map<std::string, std::string, std::less<>>; ///< what stands for {word}

/// A table without rows: title and caption of `name`, filled in.
/// @throws std::logic_error for a name or a {word} that is not there
[[nodiscard]] Table titled_table(std::string_view name, const Words& words);

/// {counts}, {drift}, {law}, {confidence}, {states}, {bootstrap} of any data.
[[nodiscard]] Words words_of(const DriftData& data);

/// Also {rule} of the modes, {fall} (share of the peak) and {ultimate} of the ultimate
/// displacement, {height}, {spatial}.
[[nodiscard]] Words words_of(const StudyWalls& walls);

} // namespace app
