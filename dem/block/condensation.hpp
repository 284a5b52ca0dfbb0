#pragma once
/// Static condensation of a block's zones onto the contact points of its faces.

#include "dem/block/block_spec.hpp"
#include "dem/block/zones.hpp"

#include <Eigen/Dense>
#include <Eigen/Sparse>

#include <vector>

namespace dem {

/// u = edge u_c on edge nodes, 0 on clamped ones, and in equilibrium elsewhere.
struct Condensed {
    ZoneGrid grid;
    std::vector<Point> points; ///< contact points [m]
    Eigen::MatrixXd stiffness; ///< 2 points x 2 points [N/m]
    std::vector<bool> held;    ///< of each row: displacement prescribed as zero
    Eigen::MatrixXd
        nodes_from_points; ///< 2 nodes x 2 points: displacement of all nodes from that of the points
    std::vector<Point>
        outline; ///< corners and contact points, counter-clockwise from the lower left [m]
    Eigen::MatrixXd outline_from_points; ///< 2 outline points x 2 points
};

[[nodiscard]] Condensed condense(const BlockSpec& spec);

/// Loads on the contact points that do the same work as loads on all nodes.
[[nodiscard]] Eigen::VectorXd condense_load(const Condensed& c, const Eigen::VectorXd& nodal);

/// Points closer than rounding of coordinates in metres.
[[nodiscard]] bool same_place(Point a, Point b);

} // namespace dem
