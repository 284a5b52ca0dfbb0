#pragma once
/// Sides that a drawn wall stands on, and sides that its beam lies on.

#include "dem/scene/wall.hpp"

#include <string>
#include <vector>

namespace app {

struct Masonry;

/// @throws BadValue if the study has a beam and no block has a level side at the top for it to
/// lie on
void require_level_top(const Masonry& masonry);

/// Notes where the beam does not lie on the whole wall, and where not all of the lowest blocks
/// stand on the floor.
[[nodiscard]] std::vector<std::string> notes_of_ends(const Masonry& masonry);

} // namespace app
