#pragma once
/// piers.svg: the piers of a pushed wall, with what they carry.

#include "app/study/pushed/pushed_wall.hpp"
#include "dem/scene/wall.hpp"

#include <string>

namespace app {

struct GeometryInput;
struct LoadInput;

/// SVG: the stones, each pier with its number, forces, drift and mode. The wall has piers.
[[nodiscard]] std::string pier_picture(const dem::WallGeometry& courses,
                                       const GeometryInput& geometry, const LoadInput& load,
                                       const dem::Layout& layout, const PushedWall& wall);

} // namespace app
