#pragma once
/// Where the contact points of a face are, what share of the face each one stands for, and how
/// the block's edge runs between them.

#include "dem/block/discretisation.hpp"

#include <vector>

namespace dem {

/// Points and weights on [0, 1]. Both ends are points, and the weights sum to 1.
struct FacePoints {
    std::vector<double> position;
    std::vector<double> weight;
};

/// @param n number of points, >= 2 (lobatto: 2 to 12)
/// @param zones_per_interval block zones between two points, >= 1
/// The edge of the zones is piecewise linear, and each weight is the integral of its point's
/// shape along that edge, so that a uniform stress on the points is the consistent load on the
/// block (patch test). For even points this is the trapezoid rule, whatever the number of
/// zones.
[[nodiscard]] FacePoints face_points(FaceRule rule, int n, int zones_per_interval);

/// Positions on [0, 1] of the zone corners along the edge.
[[nodiscard]] std::vector<double> edge_nodes(const FacePoints& points, int zones_per_interval);

/// Shape functions of the points at s in [0, 1]: piecewise linear for even points, Lagrange
/// polynomials for Gauss-Lobatto points.
[[nodiscard]] std::vector<double> edge_shapes(FaceRule rule, const FacePoints& points,
                                              double s);

} // namespace dem
