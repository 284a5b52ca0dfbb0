#pragma once
/// Damping of the explicit step.

#include "dem/contact/pack.hpp"
#include "dem/solver/state/solver_options.hpp"

namespace dem {

/// |f| with the sign of x; 0 where x is 0.
template <class Real> Real with_sign_of(Real size, Real x)
{
    const Real zero(0.0);
    return select(x > zero, size, select(x < zero, -size, zero));
}

/// Damping force on a mode: Eq. 1 (local), or combined: half of it follows the change of the
/// force, so that a body in steady motion, whose force does not change, is not dragged.
template <Damping kDamping, class Real>
Real damping_force(Real gamma, Real force, Real last_force, Real velocity)
{
    const Real size = gamma * abs(force);
    if constexpr (kDamping == Damping::local) return -with_sign_of(size, velocity);
    return Real(0.5) * (with_sign_of(size, force - last_force) - with_sign_of(size, velocity));
}

} // namespace dem
