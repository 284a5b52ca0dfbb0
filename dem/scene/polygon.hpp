#pragma once
/// Closed outlines: area, middle, whether a point lies inside.

#include "dem/scene/snapshot.hpp"

#include <span>

namespace dem {

/// Positive where the corners run counter-clockwise [m2].
[[nodiscard]] double polygon_area(std::span<const Point> outline);

/// Of the area [m]; the outline must not have area zero.
[[nodiscard]] Point polygon_centre(std::span<const Point> outline);

/// Points on the outline may count as either.
[[nodiscard]] bool is_inside(std::span<const Point> outline, Point at);

/// [m]
[[nodiscard]] double distance_to_segment(Point at, Point from, Point to);

} // namespace dem
