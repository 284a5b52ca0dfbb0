#pragma once
/// Six-node triangle in plane stress: strains vary linearly, so that bending needs few of them.
/// Zienkiewicz, Taylor (2000), The Finite Element Method, vol. 1, section 8.8. With straight
/// sides three points integrate its stiffness exactly.

#include "dem/scene/geometry/snapshot.hpp"
#include "dem/scene/wall.hpp"

#include <Eigen/Dense>

#include <array>

namespace dem {

/// [m2], positive where the corners run counter-clockwise.
[[nodiscard]] double triangle_area(const std::array<Point, 3>& corners);

/// [N/m]; nodes: corners, then the middles of sides 01, 12, 20.
[[nodiscard]] Eigen::Matrix<double, 12, 12>
triangle_stiffness(const std::array<Point, 3>& corners, double thickness,
                   const Elastic& material);

} // namespace dem
