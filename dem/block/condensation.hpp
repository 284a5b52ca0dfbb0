#pragma once
/// Static condensation of a block's zones onto the contact points of its faces.

#include "dem/block/block_spec.hpp"
#include "dem/block/mesh.hpp"

#include <Eigen/Dense>
#include <Eigen/Sparse>

#include <vector>

namespace dem {

/// A block reduced to its contact points. Nodes on an edge follow the contact points of that
/// edge, clamped nodes do not move, and all other nodes are in equilibrium.
struct Condensed {
    Mesh mesh;
    std::vector<Point> points; ///< contact points [m]
    Eigen::MatrixXd stiffness; ///< 2 points x 2 points [N/m]
    std::vector<bool> held;    ///< by row: whether the displacement is prescribed as zero
    /// Displacement of all nodes from that of the points, 2 nodes x 2 points.
    Eigen::MatrixXd nodes_from_points;
    /// Corners and contact points, counter-clockwise from the lower left [m].
    std::vector<Point> outline;
    Eigen::MatrixXd outline_from_points; ///< 2 outline points x 2 points
};

/// @throws std::invalid_argument if the outline crosses itself, or no zone has a node at a
/// contact point
[[nodiscard]] Condensed condense(const BlockSpec& spec);

/// The same block before its inside is eliminated: unknowns are the points, then the inside
/// nodes. Nothing in it is dense, so that a loading beam of 1000 points costs no more than its
/// zones.
struct SparseBlock {
    Mesh mesh;
    std::vector<Point> points;             ///< contact points [m]
    std::vector<bool> held;                ///< by row of the points
    Eigen::SparseMatrix<double> nodes;     ///< 2 nodes x unknowns
    Eigen::SparseMatrix<double> stiffness; ///< unknowns x unknowns [N/m]
};
[[nodiscard]] SparseBlock sparse_block(const BlockSpec& spec);

/// Boundary nodes, counter-clockwise, that are corners or contact points.
[[nodiscard]] std::vector<int> outline_nodes(const BlockSpec& spec, const Mesh& mesh,
                                             const std::vector<Point>& points);

/// The loads on the contact points that do the same work as the given loads on all nodes.
[[nodiscard]] Eigen::VectorXd condense_load(const Condensed& c, const Eigen::VectorXd& nodal);

/// Whether two points are closer than kSamePlace in x and in z.
[[nodiscard]] bool same_place(Point a, Point b);

} // namespace dem
