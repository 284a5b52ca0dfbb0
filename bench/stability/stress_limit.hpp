#pragma once
/// How near a wall whose joints close comes to the limit of its step while it is pushed.

#include "bench/stability/stress_scene.hpp"

namespace bench {

/// Largest step over the measured limit (dem/solver/step/stability_limit) at times on the way
/// there and back at full speed, with joints that turn where closing loses energy [-]; 0:
/// nothing was measured.
[[nodiscard]] double over_limit_on_the_way(const StressScene& scene, const dem::Model& model,
                                           int wall);

} // namespace bench
