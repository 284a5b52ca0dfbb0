#pragma once
/// Peak, stiffness, ultimate displacement and mode of pushed walls.

#include "app/output/table/table.hpp"
#include "app/study/pushed/pushed_wall.hpp"

#include <vector>

namespace app {

/// One row for each stress; one for each direction where a wall was pushed both ways.
[[nodiscard]] Table level_table(const Study& study, const std::vector<PushedWall>& walls);

} // namespace app
