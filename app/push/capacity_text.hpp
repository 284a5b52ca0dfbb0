#pragma once
/// capacity.csv of one wall.

#include "app/study/pushed_wall.hpp"

#include <string>

namespace app {

/// With the columns of body forces where the wall was pushed by them.
[[nodiscard]] std::string capacity_text(const PushedWall& wall);

} // namespace app
