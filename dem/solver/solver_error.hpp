#pragma once
/// The error that the speed of a push makes, as the push itself tells it.

#include "dem/solver/state/curve_point.hpp"
#include "dem/solver/state/solver_options.hpp"

#include <span>

namespace dem {

/// Estimated error of the peak force by the speed of the drive, as a share of it [-], >= 0:
/// what damping and motion took per displacement over the points before the peak (the median of
/// them, so that a crack among them does not count) and at the peak itself, and the gap of top
/// and base there. It sees forces that are too high because the drive drags or accelerates the
/// wall; it does not see a crack that broke too early.
/// @param kind of damping of the push: what local damping takes moves the force less
[[nodiscard]] double force_error(std::span<const CurvePoint> curve, Damping kind);

} // namespace dem
