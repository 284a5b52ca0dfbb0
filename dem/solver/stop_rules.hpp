#pragma once
/// Rules that end a push that goes one way, for PushPlan::decided.

#include "dem/solver/state/curve_point.hpp"

#include <functional>
#include <span>

namespace dem {

using StopRule = std::function<bool(std::span<const CurvePoint>)>;

/// True once the force is below a share of the largest so far. A wall that is not symmetric may
/// begin with a force against the push.
/// @param share [-], in (0, 1)
/// @param direction of the push, 1 or -1
[[nodiscard]] StopRule stop_below(double share, int direction = 1);

/// True once a wall that has carried something carries nothing any more.
[[nodiscard]] StopRule at_zero_force(int direction = 1);

} // namespace dem
