#pragma once
/// Stones that an SVG drawing has twice, once filled and once as a line: drawing programs
/// export fill and stroke as two paths.

#include "app/drawing/outlines/raw_drawing.hpp"

#include <vector>

namespace app {

/// How an outline is painted.
struct SvgPaint {
    bool filled = true, stroked = false;
};

/// Makes one outline of each two that coincide within snap, if one of them has only a fill and
/// the other only a stroke. It keeps the corners, layer and line of the filled one.
/// @param paints of the outlines of the drawing, in order
/// @param snap [m]
void join_paints(RawDrawing& drawing, const std::vector<SvgPaint>& paints, double snap);

} // namespace app
