#pragma once
/// The wall as it is built, small: stones, lintels, ground, length and height.

#include "app/drawing/outlines/drawing.hpp"

#include <span>
#include <string>

namespace app {

/// SVG of a width and a height; the wall is as large as fits.
/// @param units as scene_units() makes them, at least one
/// @param width, height [px], at least 100
[[nodiscard]] std::string wall_drawing(std::span<const DrawnBlock> units, double width,
                                       double height);

} // namespace app
