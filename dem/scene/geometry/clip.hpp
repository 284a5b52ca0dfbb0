#pragma once
/// The part of an outline on one side of a line.

#include "dem/scene/geometry/snapshot.hpp"

#include <vector>

namespace dem {

using Outline = std::vector<Point>;

/// A line through `at`; what lies against its normal is kept.
struct HalfPlane {
    Point at, normal; ///< unit vector
};

/// Several outlines where the line cuts an outline that is not convex into more than two parts.
/// @param outline simple, counter-clockwise; so are the results. Parts below 1e-10 m2 are left
/// out
[[nodiscard]] std::vector<Outline> clip(const Outline& outline, const HalfPlane& kept);
[[nodiscard]] std::vector<Outline> clip(const std::vector<Outline>& outlines,
                                        const HalfPlane& kept);

} // namespace dem
