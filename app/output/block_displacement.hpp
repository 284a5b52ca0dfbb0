#pragma once
/// How far a block moved at a contact.

#include "dem/scene/snapshot.hpp"

namespace app {

/// Displacement of block `block` (-1, the ground: none) at the outline point nearest to `at`
/// [m].
[[nodiscard]] dem::Point displacement_at(const dem::Snapshot& wall, int block, dem::Point at);

} // namespace app
