#pragma once
/// Which walls of a study a page has room for.

#include "app/study/stored/study_walls.hpp"

#include <cstddef>
#include <vector>

namespace app {

constexpr std::size_t kMostListed = 4'000; ///< walls with a curve and a row in the page

/// Walls that the page can show where nothing else is asked for: as many as have, together, no
/// more blocks than this, and at least kFewestFilmed. 316 walls of the paper are about 3 MB,
/// and about a minute of one core to push.
constexpr std::size_t kMostFilmedBlocks = 32'000;
constexpr std::size_t kFewestFilmed = 10;

/// @param blocks of a wall, the beam too
[[nodiscard]] std::size_t walls_in_page(std::size_t blocks);

/// And fewer where the page would be larger than this [bytes].
constexpr std::size_t kMostPageBytes = 4'900'000;

/// At most `most` walls, in the order of level and sample: those of the lowest sample numbers,
/// as many of each stress. Failed walls are among them.
[[nodiscard]] WallList walls_to_list(const StudyWalls& study, std::size_t most);

/// At most `most` of the walls listed, those that gave results, in turns from each stress and
/// mode in the order of the samples, so that rare modes are among them.
[[nodiscard]] WallList walls_to_show(const WallList& listed, std::size_t most);

} // namespace app
