#pragma once
/// Which blocks a wall has, where they touch, and the IDs of its joints and cracks.

#include "dem/scene/snapshot.hpp"
#include "dem/scene/wall.hpp"

#include <vector>

namespace dem {

constexpr int kGround = -1; ///< block index of the ground in Face

/// A rectangular block. Whole units are two blocks with a potential crack between them.
struct Block {
    double x0 = 0.0, x1 = 0.0; ///< [m]
    double z0 = 0.0, z1 = 0.0; ///< [m]
    int course = 0;            ///< 1 = bottom; 0 = loading beam
    int unit = 0;              ///< from 1; 0 = loading beam
};

/// A straight piece of joint between block a (below, or left) and block b (above, or right).
struct Face {
    FaceKind kind = FaceKind::bed_joint;
    int id = 0; ///< joint ID from 1, crack ID from 1; 0: base or beam
    int a = kGround;
    int b = 0;
    Point from, to; ///< end points [m], left to right or bottom to top
};

/// Joint IDs run course by course from the bottom: the head joints of a course from left to
/// right, then the bed-joint pieces above it from left to right. Crack IDs likewise. Base and
/// beam faces have no ID.
struct Layout {
    std::vector<Block>
        blocks; ///< course by course from the bottom, left to right; the beam last
    std::vector<Face> faces;
    int n_joints = 0;
    int n_cracks = 0;
    int beam = 0; ///< index of the loading beam
};

/// @param beam_height [m], > 0
[[nodiscard]] Layout lay_out(const WallGeometry& wall, double beam_height);

} // namespace dem
