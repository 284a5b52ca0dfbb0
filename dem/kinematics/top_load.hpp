#pragma once
/// How the vertical load follows the beam on which it acts (docs/theory.md has the picture).

#include "dem/kinematics/block_frame.hpp"
#include "dem/scene/wall.hpp"

#include <cmath>

namespace dem {

/// The point of the beam that carries the load, and where it was.
struct LoadPoint {
    double above = 0.0;      ///< the pivot of the beam, in the frame of the beam [m]
    double x = 0.0, z = 0.0; ///< undeformed [m]
    TopLoad top = TopLoad::dead;
    double link_length = 0.0; ///< [m]: > 0 to a hinge above, < 0 to one below
};

namespace detail {

/// A force along the link: a strut pushes away from its hinge above, a tendon pulls to its
/// hinge below. One square root for each wall in each step.
template <class Real>
void along_link(const LoadPoint& p, Real rx, Real rz, Real size, Real& fx, Real& fz)
{
    const double way = p.link_length > 0.0 ? 1.0 : -1.0;
    for (int i = 0; i < lanes<Real>; ++i) {
        const double x = lane(rx, i) - p.x, z = lane(rz, i) - (p.z + p.link_length);
        const double force = way * lane(size, i) / std::sqrt(x * x + z * z);
        set_lane(fx, i, force * x);
        set_lane(fz, i, force * z);
    }
}

} // namespace detail

/// @param size of the load [N], >= 0;  turn: of the beam
///   dead        (0, -N) at a point of the beam
///   fixed_line  (0, -N) on the vertical through the undeformed point
///   follower    (0, -N) in the frame of the beam
///   link        N along the line to a fixed hinge
template <class Real>
[[nodiscard]] OuterForce<Real> top_load(const LoadPoint& p, const BlockFrame<Real>& beam,
                                        const Turn<Real>& turn, Real size)
{
    const Real rx = Real(p.above) * turn.s, rz = Real(p.above) * turn.c;
    switch (p.top) {
    case TopLoad::fixed_line:
        return force_at(Real(p.x) - beam.x, rz, Real(0.0), -size);
    case TopLoad::follower:
        return force_at(rx, rz, -(size * turn.s), -(size * turn.c));
    case TopLoad::link: {
        Real fx(0.0), fz(0.0);
        detail::along_link(p, beam.x + rx, beam.z + rz, size, fx, fz);
        return force_at(rx, rz, fx, fz);
    }
    case TopLoad::dead:
        break;
    }
    return force_at(rx, rz, Real(0.0), -size);
}

} // namespace dem
