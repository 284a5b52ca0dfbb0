#pragma once
/// Rectangles that drawing programs lay around a drawing: the page, its background, its frame.

#include "app/drawing/outlines/raw_drawing.hpp"

namespace app {

/// Takes out upright rectangles that have all other outlines, two or more of which some touch,
/// and all lines within them, and notes it. No stone can: stones that have others within them
/// are refused. Windows in the outline of a facade do not touch.
/// @param snap [m], by which the others may reach beyond
void take_out_frames(RawDrawing& drawing, double snap);

} // namespace app
