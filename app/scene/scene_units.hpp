#pragma once
/// The units of a wall as polygons, whole even where a potential crack parts them.

#include "app/drawing/drawing.hpp"
#include "app/input/study.hpp"
#include "dem/scene/layout.hpp"

#include <vector>

namespace app {

/// Unit k of the layout is in place k - 1; a beam is no unit. Layers are those of wall.layer_stones, "wall" for
/// the wall's own stone.
[[nodiscard]] std::vector<DrawnBlock> scene_units(const Study& study,
                                                  const dem::Layout& layout);

} // namespace app
