#pragma once
/// Walls that are not symmetric carry less when they are pushed the other way, or more. What outputs say of it stands here.

#include "app/study/pushed_wall.hpp"
#include "app/study/study_walls.hpp"
#include "dem/scene/layout.hpp"

#include <string>

namespace app {

/// Whether the push goes one way and the wall is not symmetric.
[[nodiscard]] bool has_other_way(const Study& study, const dem::Layout& layout);

/// Whether `push` pushes such a wall the other way as well: the cost is that of one wall more, and is small.
[[nodiscard]] bool other_way_is_cheap(const Study& study, const dem::Layout& layout);

/// The same study, pushed as far the other way.
[[nodiscard]] Study turned_round(Study study);

/// What a wall carries each way, or how to find out; without a full stop. Empty where there is no other way.
[[nodiscard]] std::string other_way_remark(const Study& study, const dem::Layout& layout,
                                           const PushedWall& wall);

/// Of a study, whose walls are pushed one way: a sentence, or nothing.
[[nodiscard]] std::string other_way_remark(const StudyWalls& walls);

} // namespace app
