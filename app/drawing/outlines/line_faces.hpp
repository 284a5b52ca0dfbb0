#pragma once
/// Single lines that close around blocks.

#include "app/drawing/outlines/raw_drawing.hpp"

namespace app {

/// Adds each face that the drawing's lines enclose as an outline, if it is wider than 2 snap:
/// others are gaps. Lines may be shared by two blocks, or drawn twice; they meet where they end
/// within snap of each other, or of the middle of a line, or cross far from their ends.
/// @param snap [m]
/// @throws ConfigError where a line ends at no other, lies between no two faces, or crosses
/// another
void add_line_faces(RawDrawing& drawing, double snap);

} // namespace app
