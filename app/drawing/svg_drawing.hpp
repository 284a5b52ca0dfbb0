#pragma once
/// SVG: path of straight pieces, polygon, polyline, rect and line, in groups with transforms.

#include "app/drawing/raw_drawing.hpp"

#include <string_view>

namespace app {

/// @param frame file and unit, with z downwards
/// @param snap up to which the ends of an outline coincide [m]
/// @throws ConfigError
[[nodiscard]] RawDrawing read_svg(const DrawingFrame& frame, std::string_view bytes,
                                  double snap);

} // namespace app
