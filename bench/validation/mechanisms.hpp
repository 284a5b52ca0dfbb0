#pragma once
/// Fig. 11: how a wall of each mode looks at the end of its push, under each stress.

#include "app/fragility/numbers/fragility_output.hpp"
#include "app/study/stored/study_walls.hpp"

#include <filesystem>

namespace bench {

/// The wall of each stress and mode whose peak is nearest the mean of the mode, drawn again and
/// pushed.
/// @param file of the study, with all its walls
/// @throws app::StoreError
[[nodiscard]] app::NamedPicture mechanisms(const std::filesystem::path& file,
                                           const app::StudyWalls& walls);

} // namespace bench
