#pragma once
/// wall.svg: a pushed wall at its peak and at the end.

#include "app/study/pushed/pushed_wall.hpp"
#include "dem/scene/wall.hpp"

#include <string>

namespace app {

struct LoadInput;

/// @param wall with its snapshot at the peak (dem::PushPlan::snapshot_at_peak); one that came
/// down under its vertical load
/// has none
/// @throws std::invalid_argument as wall_picture
[[nodiscard]] std::string pushed_picture(const dem::Beam& beam, const LoadInput& load,
                                         const dem::Layout& layout, const PushedWall& wall);

} // namespace app
