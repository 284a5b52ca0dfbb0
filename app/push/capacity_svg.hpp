#pragma once
/// Picture of one capacity curve.

#include "app/study/pushed_wall.hpp"

#include <string>
#include <vector>

namespace app {

/// SVG: force against displacement and drift, the peak and the limit displacement marked.
[[nodiscard]] std::string capacity_svg(const Study& study, const PushedWall& wall);

/// All stress levels in one picture.
[[nodiscard]] std::string levels_svg(const Study& study, const std::vector<PushedWall>& walls);

} // namespace app
