#pragma once
/// ASCII DXF of R12 and later: LWPOLYLINE, POLYLINE and LINE of the model space.

#include "app/drawing/raw_drawing.hpp"

#include <string_view>

namespace app {

/// @param frame file and unit
/// @param snap up to which the ends of a polyline coincide [m]
/// @throws ConfigError
[[nodiscard]] RawDrawing read_dxf(const DrawingFrame& frame, std::string_view bytes,
                                  double snap);

} // namespace app
