#pragma once
/// The error that few contact points make.

#include "dem/solver/push.hpp"

namespace app {

/// Estimated error of the horizontal force by the number of contact points, as a share of the
/// peak [-], >= 0: the larger one of that at the peak and that later, where the force had come
/// down to PushPlan::drop, or else at the farthest displacement. NaN where the push gave no
/// result.
[[nodiscard]] double points_error(const dem::PushResult& push);

} // namespace app
