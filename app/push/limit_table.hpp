#pragma once
/// The limit states of pushed walls, one row each.

#include "app/output/table/table.hpp"
#include "app/study/pushed/pushed_wall.hpp"

#include <vector>

namespace app {

[[nodiscard]] Table limit_table(ReadingRules rules, const std::vector<PushedWall>& walls);

} // namespace app
