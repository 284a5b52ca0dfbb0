#pragma once
/// Peak, stiffness, ultimate displacement and mode of pushed walls.

#include "app/output/table/table.hpp"
#include "app/study/pushed/pushed_wall.hpp"

#include <vector>

namespace app {

struct FragilityInput;
struct LoadInput;

/// One row for each stress; one for each direction where a wall was pushed both ways.
[[nodiscard]] Table level_table(const LoadInput& load, const FragilityInput& fragility,
                                const std::vector<PushedWall>& walls);

} // namespace app
