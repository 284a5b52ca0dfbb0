#pragma once
/// A deformable block, condensed to its contact points and written in its own modes.
///
/// The zones of a block are eliminated statically onto the contact points of its faces, which
/// leaves K u_c. Between its points the edge runs as face_rule.hpp says. The modes solve
///   K phi = lambda C phi,   phi^T C phi = 1,   phi^T K phi = lambda,
/// where C is the stiffness of the block's own contacts while their other side is held.
///
/// The fictitious masses follow from a bound. In a wall a contact feels two blocks,
///   k (u_b - u_a)^2 <= 2 k u_a^2 + 2 k u_b^2,
/// so a mode with the mass (lambda + 2)/4 or more is stable at a unit time step, whatever the
/// neighbouring blocks do. The bound is proven, and no mode is slower than it has to be.

#include "dem/block/block_spec.hpp"

#include <Eigen/Dense>

#include <vector>

namespace dem {

/// Data of a block that the solver and the pictures need. Blocks with equal specifications
/// share one element. The rows of phi are x and z of each contact point in turn, its columns
/// are the modes.
struct BlockElement {
    std::vector<Point> points; ///< contact points [m]
    Eigen::MatrixXd phi;       ///< 2 points x modes [m per sqrt(J)]
    Point pivot;               ///< rigid motions are written about it [m]
    Eigen::MatrixXd
        rigid; ///< 3 x rigid modes, the first ones: x, z [m] and rotation of the pivot,
               ///< clockwise [rad], per unit of the mode
    Eigen::VectorXd lambda;      ///< elastic stiffness of each mode, >= 0 [-]
    Eigen::VectorXd weight;      ///< modal load of a unit body force acting downwards [N/m3]
    Eigen::VectorXd sway;        ///< modal load of a unit body force acting to the right
    Eigen::VectorXd top_load;    ///< modal load of a unit pressure on the top [Pa]
    std::vector<Point> outline;  ///< boundary [m], counter-clockwise from the lower left
    Eigen::MatrixXd outline_phi; ///< 2 outline points x modes
};

[[nodiscard]] BlockElement block_element(const BlockSpec& spec);

/// Index in BlockElement::points of the contact point at a place in the block's own frame.
[[nodiscard]] int find_point(const BlockElement& element, Point at);

} // namespace dem
