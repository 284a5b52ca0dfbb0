#pragma once
/// Arcs of a drawing as straight pieces.

#include "dem/scene/geometry/snapshot.hpp"

#include <vector>

namespace app {

/// Points from one end of an arc to the other, so many that no straight piece between them is
/// farther than `off` from the arc, and at most 720 for a whole circle.
/// @param sweep from the angle `begin` on, counter-clockwise [rad]
[[nodiscard]] std::vector<dem::Point> arc_points(dem::Point centre, double radius, double begin,
                                                 double sweep, double off);

/// Points between the ends of a side that is an arc, without the ends; the same from either
/// end. None of a straight side.
/// @param bulge tangent of a quarter of the angle of the arc, positive where it runs
/// counter-clockwise [-]
[[nodiscard]] std::vector<dem::Point> bulge_points(dem::Point from, dem::Point to, double bulge,
                                                   double off);

} // namespace app
