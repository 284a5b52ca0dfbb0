#pragma once
/// piers.svg: the piers of a pushed wall, with what they carry.

#include "app/study/pushed/pushed_wall.hpp"
#include "dem/scene/wall.hpp"

#include <string>

namespace app {

struct LoadInput;
struct Masonry;

/// SVG: the stones, each pier with its number, forces, drift and mode. The wall has piers.
[[nodiscard]] std::string pier_picture(const Masonry& masonry, const LoadInput& load,
                                       const dem::Layout& layout, const PushedWall& wall);

} // namespace app
