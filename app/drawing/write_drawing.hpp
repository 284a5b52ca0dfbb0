#pragma once
/// Blocks as files that read_drawing and other programs read.

#include "app/drawing/outlines/drawing.hpp"

#include <span>
#include <string>

namespace app {

/// {"blocks": [{"layer": ..., "outline": [[x, z], ...]}, ...]}, one block per line. Read again,
/// the coordinates are the same to the bit in metres, and in other units to the last bit of the
/// division and the multiplication.
/// @param unit length of one unit of the file [m]
[[nodiscard]] std::string write_drawing_json(std::span<const DrawnBlock> blocks,
                                             double unit = 1.0);

/// DXF of R12: closed POLYLINEs with layers. The digits are those of write_drawing_json.
/// @param unit length of one unit of the file [m]
[[nodiscard]] std::string write_drawing_dxf(std::span<const DrawnBlock> blocks,
                                            double unit = 1.0);

} // namespace app
