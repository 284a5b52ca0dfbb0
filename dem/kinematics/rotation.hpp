#pragma once
/// Turning by any angle, for one wall or a register of walls.
///
/// The sine of the C library differs between platforms and takes no register. These polynomials
/// are those of fdlibm's kernels on [-pi/4, pi/4] (errors below 1e-16), so that every width and
/// compiler gives the same bits.

#include "dem/contact/pack.hpp"

namespace dem {

/// Cosine and sine of HALF an angle. The mean direction of two blocks and half the angle
/// between them are then products of theirs: no further sine is needed for a pair.
template <class Real> struct HalfTurn {
    Real c{1.0}, s{0.0};
};

namespace detail {

/// The nearest whole number, for |x| < 2^51.
template <class Real> Real nearest(Real x)
{
    const Real shift(6755399441055744.0); // 1.5 x 2^52: what is left of the sum has no fraction
    return (x + shift) - shift;
}

/// sin(r), |r| <= pi/4
template <class Real> Real sine_near_zero(Real r)
{
    const Real z = r * r;
    Real p(1.58969099521155010221e-10);
    p = multiply_add(p, z, Real(-2.50507602534068634195e-08));
    p = multiply_add(p, z, Real(2.75573137070700676789e-06));
    p = multiply_add(p, z, Real(-1.98412698298579493134e-04));
    p = multiply_add(p, z, Real(8.33333333332248946124e-03));
    p = multiply_add(p, z, Real(-1.66666666666666324348e-01));
    return multiply_add(z * r, p, r);
}

/// cos(r), |r| <= pi/4
template <class Real> Real cosine_near_zero(Real r)
{
    const Real z = r * r;
    Real p(-1.13596475577881948265e-11);
    p = multiply_add(p, z, Real(2.08757232129817482790e-09));
    p = multiply_add(p, z, Real(-2.75573143513906633035e-07));
    p = multiply_add(p, z, Real(2.48015872894767294178e-05));
    p = multiply_add(p, z, Real(-1.38888888888741095749e-03));
    p = multiply_add(p, z, Real(4.16666666666666019037e-02));
    return multiply_add(z, multiply_add(z, p, Real(-0.5)), Real(1.0));
}

/// Cosine and sine of x from those of x - k pi/2.
template <class Real> HalfTurn<Real> quarter_turns(Real k, const HalfTurn<Real>& r)
{
    const Real quarters = k - Real(4.0) * nearest(Real(0.25) * k); // -2 ... 2
    const auto turned = abs(quarters) > Real(1.5);                 // by two
    const auto ahead = quarters > Real(0.5), behind = quarters < Real(-0.5);
    const HalfTurn<Real> one{select(ahead, -r.s, select(behind, r.s, r.c)),
                             select(ahead, r.c, select(behind, -r.c, r.s))};
    return {select(turned, -r.c, one.c), select(turned, -r.s, one.s)};
}

} // namespace detail

/// @param angle [rad]; |angle| up to some 1e5
template <class Real> [[nodiscard]] HalfTurn<Real> half_turn(Real angle)
{
    const Real x = Real(0.5) * angle;
    if (!any(abs(x) > Real(0.78)))
        return {detail::cosine_near_zero(x), detail::sine_near_zero(x)};
    // Where |x| < 0.78, k is zero and the result is the same as above.
    const Real k = select(abs(x) > Real(0.78),
                          detail::nearest(x * Real(0.63661977236758138243)), Real(0.0));
    Real r = multiply_add(k, Real(-1.57079632679489655800e+00), x);
    r = multiply_add(k, Real(-6.12323399573676603587e-17), r);
    return detail::quarter_turns(
        k, HalfTurn<Real>{detail::cosine_near_zero(r), detail::sine_near_zero(r)});
}

/// Cosine and sine of the whole angle.
template <class Real> struct Turn {
    Real c, s;
};
template <class Real> [[nodiscard]] Turn<Real> whole(const HalfTurn<Real>& h)
{
    const Real twice = h.s + h.s;
    return {Real(1.0) - twice * h.s, twice * h.c};
}

} // namespace dem
