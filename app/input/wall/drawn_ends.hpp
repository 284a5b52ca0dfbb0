#pragma once
/// Sides that a drawn wall stands on, and sides that its beam lies on.

#include <string>
#include <vector>

namespace app {

struct Study;

/// @throws BadValue if the study has a beam and no block has a level side at the top for it to
/// lie on
void require_level_top(const Study& study);

/// Notes where the beam does not lie on the whole wall, and where not all of the lowest blocks
/// stand on the floor.
[[nodiscard]] std::vector<std::string> notes_of_ends(const Study& study);

} // namespace app
