#pragma once
/// A deformable block, condensed to its contact points and written in its own modes.
///
/// The zones of a block are eliminated statically onto the contact points of its faces (its
/// edge runs between them as face_rule.hpp says), which leaves K u_c. The modes solve K phi =
/// lambda C phi, C being the stiffness of the block's own contacts with their other side held:
/// phi^T C phi = 1, phi^T K phi = lambda. In a wall a contact feels two blocks, k (u_b - u_a)^2
/// <= 2 k u_a^2 + 2 k u_b^2, so a mode of fictitious mass (lambda + 2)/4 or more is stable at a
/// unit time step whatever its neighbours do: no mode is slower than it has to be, and the
/// bound is a proof.

#include "dem/face_rule.hpp"
#include "dem/snapshot.hpp"
#include "dem/wall.hpp"

#include <Eigen/Dense>

#include <vector>

namespace dem {

/// A contact face on a block's boundary, in the block's own frame (origin at its lower left
/// corner).
struct BlockEdge {
    Point from, to; ///< [m]
    FacePoints points;
    double kn = 0.0; ///< reference stiffness of the contacts [Pa/m], > 0
    double ks = 0.0; ///< [Pa/m], > 0
};

enum class Motion {
    free,
    clamped_bottom,            ///< bottom face fixed
    clamped_bottom_held_right, ///< and no horizontal displacement of the right side
    held_right_corner,         ///< no horizontal displacement of the lower right corner
    driven ///< the beam: horizontal displacement of its load line is prescribed
};

struct BlockSpec {
    double width = 0.0, height = 0.0, thickness = 0.0; ///< [m]
    Elastic material;
    std::vector<BlockEdge> edges;
    Motion motion = Motion::free;
    double load_height = 0.0;    ///< driven: of the load line above the block's bottom [m]
    bool rotation_fixed = false; ///< driven
    FaceRule face_rule = FaceRule::even;
    int zones_per_interval = 1;
    double zone_size = 0.0; ///< along sides without contacts [m]
    int modes = 0;          ///< kept; 0: all
};

/// What the solver and the pictures need of a block; shared by all blocks of the same spec.
/// Rows of phi: x and z of each contact point in turn; columns: modes.
struct BlockElement {
    std::vector<Point> points;   ///< contact points [m]
    Eigen::MatrixXd phi;         ///< 2 points x modes [m per sqrt(J)]
    Eigen::VectorXd lambda;      ///< elastic stiffness of each mode, >= 0 [-]
    Eigen::VectorXd weight;      ///< modal load of a unit body force acting downwards [N/m3]
    Eigen::VectorXd sway;        ///< modal load of a unit body force acting to the right
    Eigen::VectorXd top_load;    ///< modal load of a unit pressure on the top [Pa]
    std::vector<Point> outline;  ///< boundary [m], counter-clockwise from the lower left
    Eigen::MatrixXd outline_phi; ///< 2 outline points x modes
};

[[nodiscard]] BlockElement block_element(const BlockSpec& spec);

/// Edge points of the block in the order of BlockElement::points, for finding a contact's
/// point.
[[nodiscard]] int find_point(const BlockElement& element, Point at);

} // namespace dem
