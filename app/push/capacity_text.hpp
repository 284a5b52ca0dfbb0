#pragma once
/// capacity.csv of one wall.

#include "app/study/pushed_wall.hpp"

#include <string>

namespace app {

/// With load factor and corner of a wall that body forces pushed, base shear, unbalance and the energies of each point.
[[nodiscard]] std::string capacity_text(const PushedWall& wall);

} // namespace app
