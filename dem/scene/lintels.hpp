#pragma once
/// The lintels over the openings of a wall in courses.

#include "dem/scene/wall.hpp"

#include <vector>

namespace dem {

/// A lintel is as high as its course.
struct Lintel {
    double x0 = 0.0, x1 = 0.0; ///< [m]
};

/// Share of WallGeometry::lintel_bearing that neighbours must get of the pier between their
/// openings; where they get less, one lintel runs over both openings.
constexpr double kLeastBearing = 0.5; // a free choice

/// The lintels of a course from left to right, over the openings that end below it, whatever
/// their order. Each reaches over its openings by lintel_bearing; at the end of the wall, and
/// beside an opening that goes through this course, by as much as there is. Neighbours share
/// the pier between them at its middle. None over an opening that goes on as another one.
/// @param course from 1 at the bottom
/// @throws std::invalid_argument if a lintel has no bearing on either side of its openings, or
/// another opening cuts it
[[nodiscard]] std::vector<Lintel> lintels_of(const WallGeometry& wall, int course);

} // namespace dem
