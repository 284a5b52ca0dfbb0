#pragma once
/// Whether all of a wall is connected to the floor.

#include "dem/scene/layout.hpp"

#include <vector>

namespace dem {

/// Blocks of the wall that no chain of faces connects to the floor at z = 0, in the order of
/// the layout.
[[nodiscard]] std::vector<int> hanging_blocks(const Layout& layout);

/// @throws std::invalid_argument if there are any
void check_standing(const Layout& layout);

} // namespace dem
