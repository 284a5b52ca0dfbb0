#pragma once
/// The zones of a block: four-node rectangles on a grid, or six-node triangles where the
/// outline is not a rectangle.

#include "dem/block/zones.hpp"
#include "dem/scene/geometry/snapshot.hpp"

#include <Eigen/Dense>
#include <Eigen/Sparse>

#include <array>
#include <span>
#include <vector>

namespace dem {

/// The degrees of freedom of node n are 2n (x) and 2n + 1 (z).
struct Mesh {
    std::vector<Point> nodes;                   ///< [m]
    std::vector<std::array<int, 4>> rectangles; ///< counter-clockwise from the lower left
    std::vector<std::array<int, 6>>
        triangles;         ///< corners counter-clockwise, middles of 01, 12, 20
    std::vector<int> ring; ///< nodes on the outline, counter-clockwise from its first corner
};

[[nodiscard]] Mesh grid_mesh(const ZoneGrid& grid);

/// Triangles inside an outline, whose sides have nodes at the given places and in the middle
/// between them.
/// @param ring corners and further points of a simple outline, counter-clockwise [m], at least
/// three
/// @param size of the triangles inside [m], > 0
/// @throws std::invalid_argument if the outline crosses itself
[[nodiscard]] Mesh triangle_mesh(std::span<const Point> ring, double size);

/// 2 nodes x 2 nodes [N/m].
[[nodiscard]] Eigen::SparseMatrix<double> mesh_stiffness(const Mesh& mesh, double thickness,
                                                         const Elastic& material);

/// The share of each node in a uniform force on the area [m2].
[[nodiscard]] Eigen::VectorXd nodal_areas(const Mesh& mesh);

} // namespace dem
