#pragma once
/// Two sides of blocks that face each other.

namespace dem {

/// A side of a block in the frame of the block, from its pivot, along the tangent and the
/// normal of the undeformed face [m].
struct Side {
    double from = 0.0, to = 0.0; ///< ends along the tangent
    double normal = 0.0;         ///< along the normal
};

struct FacePair {
    int a = 0, b = 0;          ///< frames of the two blocks
    double nx = 0.0, nz = 0.0; ///< undeformed unit normal from a to b; the tangent is (nz, -nx)
    Side side_a, side_b;
    double length = 0.0; ///< of the undeformed overlap [m]
    double deepest =
        0.0; ///< closure beyond which blocks that press on each other have passed through [m]
    double shallow =
        0.0; ///< the same for sides that come to overlap from beside [m], at most deepest
};

constexpr double kRoundedCorner = 2e-3; // [face lengths] of a block onto which another slides

} // namespace dem
