#pragma once
/// capacity.csv of one wall.

#include "app/study/pushed/pushed_wall.hpp"

#include <string>

namespace app {

/// capacity.csv of a wall. Behind displacement, drift and force come base shear, unbalance and
/// the energies of each point, and before them load factor and corner of a wall that body
/// forces pushed.
[[nodiscard]] std::string capacity_text(const PushedWall& wall);

} // namespace app
