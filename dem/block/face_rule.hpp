#pragma once
/// Where the contact points of a face sit, what share of it each stands for, and how the
/// block's edge runs between.

#include "dem/block/discretisation.hpp"

#include <vector>

namespace dem {

/// Points and weights on [0, 1]; both ends are points, weights sum to 1.
struct FacePoints {
    std::vector<double> position;
    std::vector<double> weight;
};

/// @param n number of points, >= 2 (lobatto: 2 to 12)
/// @param zones_per_interval block zones between two points, >= 1
/// The edge of the zones is piecewise linear, and each weight is the integral of its point's
/// shape along that edge: a uniform stress on the points is then the consistent load of the
/// block (patch test). Even points: the trapezoid rule for any number of zones.
[[nodiscard]] FacePoints face_points(FaceRule rule, int n, int zones_per_interval);

/// Positions on [0, 1] of the zone corners along the edge.
[[nodiscard]] std::vector<double> edge_nodes(const FacePoints& points, int zones_per_interval);

/// Shape functions of the points at s in [0, 1]: piecewise linear (even), Lagrange polynomials
/// (lobatto).
[[nodiscard]] std::vector<double> edge_shapes(FaceRule rule, const FacePoints& points,
                                              double s);

} // namespace dem
