#pragma once
/// Closed outlines: area, middle, extent, whether a point lies inside.

#include "dem/scene/geometry/snapshot.hpp"

#include <span>

namespace dem {

/// An upright rectangle [m].
struct Region {
    double x0 = 0.0, z0 = 0.0, x1 = 0.0, z1 = 0.0;
    friend bool operator==(const Region&, const Region&) = default;
};

/// The smallest rectangle around at least one point.
[[nodiscard]] Region extent_of(std::span<const Point> points);

/// The smallest rectangle around both.
[[nodiscard]] Region join(const Region& a, const Region& b);

/// Positive where the corners run counter-clockwise [m2].
[[nodiscard]] double polygon_area(std::span<const Point> outline);

/// Centre of the area [m]; the outline must not have area zero.
[[nodiscard]] Point polygon_centre(std::span<const Point> outline);

/// Points on the outline may count as either.
[[nodiscard]] bool is_inside(std::span<const Point> outline, Point at);

/// [m]
[[nodiscard]] double distance_to_segment(Point at, Point from, Point to);

} // namespace dem
