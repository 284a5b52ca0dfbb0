#pragma once
/// Closed forms that an engineer checks a push by: what a wall weighs, and when it turns or
/// slides as a rigid body.

#include "dem/scene/layout.hpp"

namespace dem {

struct Weights {
    double area = 0.0;    ///< of the masonry in the elevation [m2]
    double masonry = 0.0; ///< [N]
    double free = 0.0;    ///< of the part of the masonry that no support holds [N]
    double beam = 0.0;    ///< [N]
};
/// @param stone of the wall, of which blocks are that have none of their own
/// @param gravity [m/s2]
[[nodiscard]] Weights weights_of(const Layout& layout, const Elastic& stone,
                                 const Elastic& beam, double gravity);

/// Height of the centre of gravity of all blocks, with the beam, above the floor [m]; 0 where
/// nothing has weight.
[[nodiscard]] double gravity_height(const Layout& layout, const Elastic& stone,
                                    const Elastic& beam);

/// Limits of small displacements; units that crack, cohesion and the flexibility of the wall
/// lower them.
struct RigidWall {
    double vertical_load = 0.0; ///< N: on the top, with the weight of the beam [N]
    double weight = 0.0;        ///< W: of the courses that can turn [N]
    int turning = 0; ///< courses that can turn; none of a single course on a fixed base
    /// (N + W) L / (2 h): turning about the toe of the lowest joint that can open, h from there
    /// to the load line [N]. Body forces: f times the weight of all blocks, with f = (N + W) L
    /// / 2 over the moment of the weight above that joint turned sideways.
    double rocking_limit = 0.0;
    /// The least of tan(phi) (N + weight of the top course) of the bed joints, tan(phi_base) (N
    /// + W) of a base joint whose toe is free, and tan(phi_beam) N under a beam on a joint [N].
    /// Body forces: f times the weight of all blocks, with f = tan(phi) (N + W) over the weight
    /// above the lowest joint.
    double sliding_limit = 0.0;
};

/// Friction coefficients of the joints, all >= 0 [-]. Those of base and beam count where the
/// wall has such a joint.
struct WallFriction {
    double joints = 0.0, base = 0.0, beam = 0.0;
};

/// @param wall in courses; without openings, and without mortar in its joints
/// @param weight of all blocks, as PushResult::weight has it [N]; only with body forces
[[nodiscard]] RigidWall rigid_wall(const WallGeometry& wall, const Beam& beam,
                                   const Elastic& stone, const Loads& loads,
                                   const WallFriction& friction, double weight = 0.0);

} // namespace dem
