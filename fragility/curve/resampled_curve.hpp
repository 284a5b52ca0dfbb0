#pragma once
/// Curves at the same displacements, for means over walls.

#include "fragility/curve/curve_reading.hpp"

#include <cstddef>
#include <vector>

namespace fragility {

/// Forces at 0, step, 2 step, ..., straight between the points of the curve and from the origin
/// to the first; fewer than `points` where the curve ends before. Empty for a curve without
/// points.
/// @param curve as Curve, which is not checked here  @param step [length], > 0
[[nodiscard]] std::vector<double> resampled(const Curve& curve, double step,
                                            std::size_t points);

} // namespace fragility
