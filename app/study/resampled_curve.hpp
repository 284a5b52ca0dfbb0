#pragma once
/// Stored curves at the same displacements, for means over walls.

#include "app/store/store_row.hpp"

#include <cstddef>
#include <vector>

namespace app {

/// A mean ends where fewer of its walls are still pushed [-]: those left are no fair sample, since walls
/// whose force has dropped are the first to go.
constexpr double kMeanNeedsShare = 0.9;

/// Forces at 0, step, 2 step, ..., straight between the points of the curve and from the origin to the
/// first; fewer than `points` where it ends before. Empty for a curve without points.
/// @param curve displacements never decreasing
[[nodiscard]] std::vector<double> resampled(const WallCurve& curve, double step,
                                            std::size_t points);

} // namespace app
