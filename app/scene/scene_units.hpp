#pragma once
/// The units of a wall, whole even where potential cracks part them.

#include "app/drawing/outlines/drawing.hpp"
#include "dem/scene/layout.hpp"

#include <vector>

namespace app {

struct GeometryInput;

/// Unit k of the layout is in place k - 1; a beam is no unit. Layers are those of the drawing,
/// "lintel" for lintels, and "wall" for units without one (nothing where wall.layer_stones
/// gives "wall" another stone).
/// @param whole as whole_units() makes it
[[nodiscard]] std::vector<DrawnBlock> scene_units(const GeometryInput& geometry,
                                                  const dem::Layout& whole);

} // namespace app
