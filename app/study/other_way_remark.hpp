#pragma once
/// The words of outputs on a wall that is not symmetric and was pushed one way.

#include "app/study/pushed_wall.hpp"

#include <string>

namespace app {

/// "right" or "left".
[[nodiscard]] const char* way_name(int direction);

/// Whether the push goes one way and the wall is not symmetric.
[[nodiscard]] bool has_other_way(const Study& study, const dem::Layout& layout);

/// The same study, pushed as far the other way.
[[nodiscard]] Study turned_round(Study study);

/// Says what a wall carries each way, or how to find out, without a full stop. Empty where
/// there is no other way.
[[nodiscard]] std::string other_way_remark(const Study& study, const dem::Layout& layout,
                                           const PushedWall& wall);

} // namespace app
