#pragma once
/// Where a block is, without its deformation: a point of it, its pivot, and its rotation. The
/// elastic modes live in the frame that turns with the block.

#include "dem/kinematics/rotation.hpp"

namespace dem {

/// Rotations are clockwise, the way a push to the right turns a wall:
///   (x, z) -> (x cos + z sin, z cos - x sin)
template <class Real> struct BlockFrame {
    Real x{0.0}, z{0.0};                ///< of the pivot [m]
    Real turn{0.0};                     ///< rotation [rad]
    HalfTurn<Real> half;                ///< of that rotation
    Real vx{0.0}, vz{0.0}, spin{0.0};   ///< motion in the last step [m], [rad]
    Real fx{0.0}, fz{0.0}, moment{0.0}; ///< by the contacts [N], [N m] about the pivot
};

/// A force that acts at a point of a block.
template <class Real> struct OuterForce {
    Real fx{0.0}, fz{0.0}; ///< [N]
    Real moment{0.0};      ///< about the pivot, clockwise [N m]
};

/// @param rx, rz from the pivot to where the force acts [m]
template <class Real>
[[nodiscard]] OuterForce<Real> force_at(Real rx, Real rz, Real fx, Real fz)
{
    return {fx, fz, rz * fx - rx * fz};
}

} // namespace dem
