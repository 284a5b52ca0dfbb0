#pragma once
/// How far a block moved at a contact.

#include "dem/scene/geometry/snapshot.hpp"

namespace dem {

/// Displacement of block `block` (-1, the ground: none) at the outline point nearest to `at`
/// [m].
/// @throws std::out_of_range if there is no such block
[[nodiscard]] Point displacement_at(const Snapshot& wall, int block, Point at);

} // namespace dem
