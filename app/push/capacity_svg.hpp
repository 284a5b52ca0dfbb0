#pragma once
/// Picture of one capacity curve.

#include "app/output/picture/chart_svg.hpp"
#include "app/push/test_curve.hpp"
#include "app/study/pushed/pushed_wall.hpp"

#include <string>
#include <vector>

namespace app {

/// Force against displacement and drift, the peak and all limit displacements marked.
[[nodiscard]] Chart capacity_chart(const ReadingRules& rules, const PushedWall& wall);

/// SVG: force against displacement and drift, the peak and the limit displacement marked.
/// @param beside measured curves, drawn dashed
[[nodiscard]] std::string capacity_svg(const ReadingRules& rules, const PushedWall& wall,
                                       const std::vector<TestCurve>& beside = {});

/// All stress levels in one picture.
[[nodiscard]] std::string levels_svg(const ReadingRules& rules,
                                     const std::vector<PushedWall>& walls,
                                     const std::vector<TestCurve>& beside = {});

} // namespace app
