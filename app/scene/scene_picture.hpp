#pragma once
/// Picture of a wall before anything is computed: what the program understood.

#include "app/drawing/outlines/drawing.hpp"
#include "dem/scene/layout.hpp"

#include <span>
#include <string>

namespace app {

/// SVG: units with their numbers, joints coloured by kind, supports hatched, sizes, a legend.
/// @param units as scene_units() makes them, at least one
/// @param title above the picture
/// @param below a sentence below the title
[[nodiscard]] std::string scene_picture(const dem::Layout& layout,
                                        std::span<const DrawnBlock> units,
                                        const std::string& title, const std::string& below);

} // namespace app
