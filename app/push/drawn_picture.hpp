#pragma once
/// Values drawn for each joint or crack, on the wall (the paper, Fig. 13b).

#include "app/sampling/wall_draw.hpp"
#include "dem/scene/layout.hpp"

#include <string>

namespace app {

struct RandomInput;

/// An SVG picture with a panel for each input that has a value per joint or per crack, which
/// is coloured from the smallest to the largest of this wall. Empty where there is none.
/// @param draw of this study and layout
[[nodiscard]] std::string drawn_picture(const std::vector<RandomInput>& random,
                                        const dem::Layout& layout, const WallDraw& draw);

} // namespace app
