#pragma once
/// JSON: plain polygons, and what COMPAS writes (meshes, polygons, and whatever holds them).

#include "app/drawing/raw_drawing.hpp"

#include <string_view>

namespace app {

/// @param frame file and unit
/// @param snap up to which the ends of an outline coincide [m]
/// @throws ConfigError
[[nodiscard]] RawDrawing read_json_drawing(const DrawingFrame& frame, std::string_view bytes,
                                           double snap);

} // namespace app
