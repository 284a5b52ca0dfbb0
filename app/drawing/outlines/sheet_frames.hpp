#pragma once
/// Outlines around stones that are no stones themselves: the page, its frame, the border of a
/// wall that single lines divide into stones.

#include "app/drawing/outlines/raw_drawing.hpp"

namespace app {

/// Takes out upright rectangles that have everything else within them, and notes it: two or
/// more outlines of which some touch, or lines that end within. No stone can: stones that have
/// others within them are refused. Windows in the outline of a facade do not touch.
/// @param snap [m], by which outlines may reach beyond
void take_out_frames(RawDrawing& drawing, double snap);

/// Makes lines of each outline that has the middle of a line within it, farther than snap from
/// its sides, and notes it: the line divides it into stones.
/// @param snap [m]
void divide_outlines(RawDrawing& drawing, double snap);

} // namespace app
