#pragma once
/// summary.json: what one push found, with the rules and settings behind each number.

#include "app/study/pushed/pushed_wall.hpp"

#include <string>

namespace app {

struct Study;

/// Keys in a fixed order; what is not defined is null, never NaN.
[[nodiscard]] std::string summary_json(const Study& study, const dem::Layout& layout,
                                       const PushedWall& wall);

} // namespace app
