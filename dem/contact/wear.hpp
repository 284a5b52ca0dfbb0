#pragma once
/// Wear of a dry joint: its asperities are ground off by slip under pressure, and the friction
/// they give goes with them.
///   tan phi = tan phi_r + (tan phi_0 - tan phi_r) r,   r = exp(-s / s_w)
///   s   slip travelled to and fro under pressure        s_w   wear length
/// Plesha (1987) lets the slope of the asperities of a rock joint fall as exp(-c W), with the
/// work W of the shear stress in slip; Hutson and Dowding (1990) measured it in cyclic tests.
/// Under one normal stress W is proportional to s. There is no dilatancy here, so that the
/// slope counts as friction alone.

#include "dem/contact/pack.hpp"

namespace dem {

template <class Real> struct WearLaw {
    Real drop;       ///< tan phi_0 - tan phi_r [-], >= 0
    Real inv_length; ///< 1 / s_w [1/m]; 0: no wear
};

/// Friction coefficient of a joint that has the share `roughness` of its asperities left.
template <class Real>
[[nodiscard]] Real worn_tan_phi(const WearLaw<Real>& law, Real tan_phi, Real roughness)
{
    return tan_phi - law.drop * (Real(1.0) - roughness);
}

/// r after a step with plastic slip: of second order in the step, so that it needs no exp().
/// @param slip [m]
/// @param sigma normal stress [Pa]; without pressure nothing wears
template <class Real>
[[nodiscard]] Real roughness_after(const WearLaw<Real>& law, Real roughness, Real slip,
                                   Real sigma)
{
    constexpr double kSmooth = 1e-12; // nothing is left; smaller numbers would become denormal
    const Real one(1.0), zero(0.0);
    const Real x = select(sigma < zero, abs(slip) * law.inv_length, zero);
    return max(Real(kSmooth),
               roughness / multiply_add(x, multiply_add(Real(0.5), x, one), one));
}

} // namespace dem
