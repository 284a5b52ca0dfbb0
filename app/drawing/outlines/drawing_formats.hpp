#pragma once
/// The formats of drawings, and what makes blocks that fit together of them. Each throws
/// ConfigError.

#include "app/drawing/outlines/drawing.hpp"
#include "app/drawing/outlines/raw_drawing.hpp"

#include <string_view>

namespace app {

/// ASCII DXF of R12 and later: LWPOLYLINE, POLYLINE and LINE of the model space.
/// @param frame file and unit, as for each of the following
/// @param snap up to which the ends of an outline coincide [m], as for each of the following
[[nodiscard]] RawDrawing read_dxf(const DrawingFrame& frame, std::string_view bytes,
                                  double snap);

/// JSON: plain polygons, and what COMPAS writes (meshes, polygons, and whatever holds them).
[[nodiscard]] RawDrawing read_json_drawing(const DrawingFrame& frame, std::string_view bytes,
                                           double snap);

/// SVG: path of straight pieces, polygon, polyline, rect and line, in groups with transforms.
/// @param frame with z downwards
[[nodiscard]] RawDrawing read_svg(const DrawingFrame& frame, std::string_view bytes,
                                  double snap);

/// A picture of stones becomes blocks that fill its rectangle.
[[nodiscard]] Drawing read_picture(const DrawingFrame& frame, std::string_view bytes,
                                   const DrawingOptions& options);

/// Outlines of a drawing, each drawn for itself, become blocks that fit together.
/// @param snap [m]
[[nodiscard]] Drawing fit_drawing(RawDrawing raw, double snap);

} // namespace app
