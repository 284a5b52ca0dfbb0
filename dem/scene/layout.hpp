#pragma once
/// The blocks of a wall, the faces where they touch, and the IDs of joints and cracks.

#include "dem/scene/snapshot.hpp"
#include "dem/scene/wall.hpp"

#include <vector>

namespace dem {

constexpr int kGround = -1; ///< block index of the ground in Face

/// A rectangular block. A whole unit consists of two blocks with a potential crack between them.
struct Block {
    double x0 = 0.0, x1 = 0.0; ///< [m]
    double z0 = 0.0, z1 = 0.0; ///< [m]
    int course = 0;            ///< from 1 at the bottom; 0 is the loading beam
    int unit = 0;              ///< number of the unit from 1; 0 is the loading beam
};

/// A straight piece of joint between block a (below, or left) and block b (above, or right).
struct Face {
    FaceKind kind = FaceKind::bed_joint;
    int id = 0; ///< joint ID or crack ID, from 1; 0 for the joints at the base and at the beam
    int a = kGround; ///< index in Layout::blocks
    int b = 0;       ///< index in Layout::blocks
    Point from, to;  ///< end points [m], left to right or bottom to top
};

/// Joint IDs run course by course from the bottom: first the head joints of a course from left to
/// right, then the pieces of bed joint above it from left to right. Crack IDs run in the same order.
/// The faces at the base and at the beam have no ID.
struct Layout {
    std::vector<Block>
        blocks; ///< course by course from the bottom, each from left to right; a beam is the last
    std::vector<Face> faces;
    int n_joints = 0;
    int n_cracks = 0;
    int beam = 0; ///< index of the loading beam; without one the number of blocks
};

/// @param beam_height [m]; 0: no beam
[[nodiscard]] Layout lay_out(const WallGeometry& wall, double beam_height);

} // namespace dem
