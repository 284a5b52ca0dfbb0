#pragma once
/// Two blocks that face each other, wherever they have moved: how far their sides overlap, how
/// wide the gap is along the overlap, how fast they slide, and what the stresses between them
/// do to both.
///
/// Contact points belong to the overlap and to neither block: the points and weights of the
/// face rule are laid on the part of the two sides that lies opposite now. So a point slides
/// along its partner with the overlap, both ends of the overlap are points (a block turns about
/// the corner that is really there), the area goes to zero with the overlap, and whatever
/// passes an edge does so without a jump. Forces are equal and opposite at one and the same
/// point of space.
///
/// Direction: gap and overlap are measured in the mean direction of the two sides, which is
/// symmetric in the blocks and sees no slip where they turn about a common corner. Stresses act
/// along the normal of the side on whose plane the other's corner stands; corners that meet
/// have the mean direction. In between the direction changes linearly, as the gap of a point
/// does that slides with the overlap; all take that of the centre of pressure. The gap of a
/// corner is its distance from the other side over the cosine of the angle between that side
/// and the mean direction. So a stress s acts as the force (s, s tan) along the mean normal and
/// tangent, which does the work s d(gap) in every motion of the blocks: it is the gradient of
/// what contacts store, at any angle.

#include "dem/kinematics/block_frame.hpp"
#include "dem/kinematics/face_pair.hpp"

namespace dem {

/// Part of the two sides that lies opposite, in the mean direction of the two blocks; positions
/// from the pivot of block a.
template <class Real> struct Overlap {
    Real nx, nz;       ///< mean normal
    Real from, length; ///< along the tangent [m]; length >= 0
    Real along_sides;  ///< length, measured along the sides [m]
    Real gap;          ///< between the sides at `from` [m]
    Real widening;     ///< of the gap from there to the other end [m]
    Real height;       ///< of the line midway between the sides, along the normal [m]
    Real dt, dn;       ///< from the pivot of a to that of b
    Real pressed;      ///< the centre of pressure, along the tangent
    Real past_far,
        past_near; ///< overhang of b over the ends of a [m]; negative where b ends before
    Real tilt;     ///< tangent of the angle of the stresses against the mean normal
};

constexpr double kCornerRadius = 1e-3; // [face lengths] over which a corner hands on its normal
template <class Real> [[nodiscard]] Real corner_of(const FacePair& p, Real overhang)
{
    const Real radii = overhang * Real(1.0 / (kCornerRadius * p.length));
    return max(Real(-1.0), min(Real(1.0), radii));
}

/// @param centre of pressure along the overlap, 0 to 1
template <class Real>
[[nodiscard]] Overlap<Real> overlap_of(const FacePair& p, const BlockFrame<Real>& a,
                                       const BlockFrame<Real>& b, Real centre)
{
    const Real cm = a.half.c * b.half.c - a.half.s * b.half.s, // mean direction
        sm = a.half.s * b.half.c + a.half.c * b.half.s;
    const Real ch =
                   a.half.c * b.half.c + a.half.s * b.half.s, // half of what b is turned past a
        sh = b.half.s * a.half.c - b.half.c * a.half.s;
    Overlap<Real> o;
    o.nx = multiply_add(Real(p.nx), cm, Real(p.nz) * sm);
    o.nz = multiply_add(Real(p.nz), cm, Real(-p.nx) * sm);
    const Real dx = b.x - a.x, dz = b.z - a.z;
    o.dt = multiply_add(o.nz, dx, -(o.nx * dz));
    o.dn = multiply_add(o.nx, dx, o.nz * dz);

    const Real shift_a = Real(-p.side_a.normal) * sh;
    const Real shift_b = multiply_add(Real(p.side_b.normal), sh, o.dt);
    const Real a_from = multiply_add(Real(p.side_a.from), ch, shift_a),
               a_to = multiply_add(Real(p.side_a.to), ch, shift_a),
               b_from = multiply_add(Real(p.side_b.from), ch, shift_b),
               b_to = multiply_add(Real(p.side_b.to), ch, shift_b);
    o.from = max(a_from, b_from);
    const Real to = min(a_to, b_to);
    // Blocks turned almost upside down against each other are no partners.
    const auto facing = ch > Real(0.3);
    o.length = select(facing, max(Real(0.0), to - o.from), Real(0.0));

    const Real per_ch = Real(1.0) / select(facing, ch, Real(1.0)), slope = sh * per_ch;
    o.along_sides = o.length * per_ch;
    const Real height_a =
        multiply_add(slope, o.from - a_from,
                     multiply_add(Real(p.side_a.normal), ch, Real(p.side_a.from) * sh));
    const Real height_b = multiply_add(
        slope, b_from - o.from,
        multiply_add(Real(p.side_b.normal), ch, multiply_add(Real(-p.side_b.from), sh, o.dn)));
    o.gap = height_b - height_a;
    o.widening = Real(-2.0) * slope * o.length;
    o.height = Real(0.5) * (height_a + height_b);

    o.pressed = multiply_add(centre, o.length, o.from);
    o.past_far = b_to - a_to;
    o.past_near = a_from - b_from;
    const Real near = corner_of(p, o.past_near), far = corner_of(p, o.past_far);
    const Real corner = multiply_add(centre, far - near, near);
    o.tilt = corner * slope;
    return o;
}

/// By how much the sides may come closer at both ends of an overlap because what was there is
/// crushed [m].
template <class Real> struct EndDepths {
    Real from{0.0}, to{0.0};
};

/// Area of the overlap over that of the undeformed face [-]; zero where blocks have passed
/// through each other. Sides that face each other along all of their face may be pressed
/// together deeply where the joint is soft, others in proportion to their overlap. Sides that
/// come to overlap from beside must lie nearly outside each other: a block that fell beside
/// another, and swings back below its side, would be thrown out of it.
/// @param before the share one step earlier
template <class Real>
[[nodiscard]] Real share_of(const FacePair& p, const Overlap<Real>& o, Real before,
                            const EndDepths<Real>& crushed = {})
{
    const Real share = o.along_sides * Real(1.0 / p.length);
    const Real most = select(before > Real(0.0), max(Real(p.shallow), Real(p.deepest) * share),
                             Real(p.shallow));
    const Real deepest = min(o.gap + crushed.from, o.gap + o.widening + crushed.to);
    return select(deepest < -most, Real(0.0), share);
}

/// Tangential displacement of b past a in the last step, where they touch [m].
template <class Real>
[[nodiscard]] Real slip_of(const Overlap<Real>& o, const BlockFrame<Real>& a,
                           const BlockFrame<Real>& b)
{
    const Real vx = b.vx - a.vx, vz = b.vz - a.vz;
    const Real spin = b.spin - a.spin; // of b past a
    const Real t = multiply_add(
        o.nz, vx, multiply_add(spin, o.height, -multiply_add(o.nx, vz, b.spin * o.dn)));
    const Real n = multiply_add(
        o.nx, vx, multiply_add(o.nz, vz, multiply_add(b.spin, o.dt, -(spin * o.pressed))));
    return multiply_add(-o.tilt, n, t);
}

/// Stresses of the contacts of a pair, summed with their areas.
template <class Real> struct StressSum {
    Real normal{0.0}, tangential{0.0}; ///< [N]
    Real normal_first{0.0},
        tangential_first{0.0}; ///< times the place along the overlap, 0 to 1

    /// @param place along the overlap, 0 to 1;  normal_force, shear of one contact [N]
    void add(Real place, Real normal_force, Real shear)
    {
        normal += normal_force;
        tangential += shear;
        normal_first = multiply_add(place, normal_force, normal_first);
        tangential_first = multiply_add(place, shear, tangential_first);
    }

    /// The same on a share of the area.
    [[nodiscard]] StressSum on(Real share) const
    {
        return {share * normal, share * tangential, share * normal_first,
                share * tangential_first};
    }
};

/// Where along the overlap the stresses press, 0 to 1; where none do, the end that closes as
/// the blocks turn.
template <class Real>
[[nodiscard]] Real centre_of_pressure(const Overlap<Real>& o, const StressSum<Real>& s)
{
    const auto presses = s.normal < Real(0.0);
    const Real centre = s.normal_first / select(presses, s.normal, Real(-1.0));
    const Real closes = select(o.widening < Real(0.0), Real(1.0), Real(0.0));
    return select(presses, max(Real(0.0), min(Real(1.0), centre)), closes);
}

/// The forces on both blocks; tension pulls them together.
template <class Real>
void add_forces(const Overlap<Real>& o, const StressSum<Real>& s, BlockFrame<Real>& a,
                BlockFrame<Real>& b)
{
    const Real n = multiply_add(-o.tilt, s.tangential, s.normal),
               t = multiply_add(o.tilt, s.normal, s.tangential),
               first = multiply_add(-o.tilt, s.tangential_first, s.normal_first);
    const Real fx = multiply_add(o.nx, n, o.nz * t), fz = multiply_add(o.nz, n, -(o.nx * t));
    const Real moment = multiply_add(o.height, t, -multiply_add(o.from, n, o.length * first));
    a.fx += fx;
    a.fz += fz;
    a.moment += moment;
    b.fx -= fx;
    b.fz -= fz;
    b.moment -= moment - multiply_add(o.dn, t, -(o.dt * n));
}

} // namespace dem
