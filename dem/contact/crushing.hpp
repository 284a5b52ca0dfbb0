#pragma once
/// Crushing of a contact: a plastic part in series with the law of the contact, so that every
/// law stays as it is.
///   u_n = u_e + u_p     u_e is what the law sees; -u_p is the crushed thickness, which only
///   grows
///   strength left f = f_c (1 - crushed / u_cu), not below zero;  u_cu = 2 G_c / f_c
///   -k_n u_e > f        crushes until -k_n u_e = f
/// Crushing costs G_c per area, and nothing of it is paid back: the contact unloads with
/// k_n, and a gap of the crushed thickness stays. Where f_c / u_cu >= k_n, that is f_c > sqrt(2
/// G_c k_n), the contact breaks at once and releases f_c^2 / (2 k_n) > G_c. Without an energy
/// the strength stays.

#include "dem/contact/pack.hpp"

#include <algorithm>
#include <limits>

namespace dem {

template <class Real> struct CrushingLaw {
    Real kn;        ///< [Pa/m]
    Real strength;  ///< f_c [Pa]; infinite where the contact does not crush
    Real softening; ///< f_c / u_cu [Pa/m]; 0: none
    Real flow;      ///< 1 / (k_n - softening) [m/Pa], or kCrushesAtOnce
};

/// Stands for 1 / (k_n - softening) of a contact that breaks at once.
constexpr double kCrushesAtOnce = 1e30; // [m/Pa]

/// @param kn [Pa/m]
/// @param strength f_c [Pa]; 0: the contact does not crush
/// @param energy G_c [J/m2]; 0: the strength stays
[[nodiscard]] inline CrushingLaw<double> crushing_law(double kn, double strength, double energy)
{
    if (strength == 0.0) return {kn, std::numeric_limits<double>::infinity(), 0.0, 1.0 / kn};
    const double softening = energy > 0.0 ? strength * strength / (2.0 * energy) : 0.0;
    const double stiffer = kn - softening;
    return {kn, strength, softening, stiffer > 0.0 ? 1.0 / stiffer : kCrushesAtOnce};
}

/// Thickness that is crushed on the way to u_e, >= 0 [m].
/// @param crushed so far [m]
/// @param u_e opening without what is crushed in this step [m]
template <class Real>
[[nodiscard]] Real crushed_by(const CrushingLaw<Real>& law, Real crushed, Real u_e)
{
    const Real zero(0.0);
    const Real pressure = zero - law.kn * u_e;
    const Real left = max(zero, law.strength - law.softening * crushed);
    const auto crushes = pressure > left;
    const Real by = (pressure - left) * law.flow;
    const auto holds = law.strength - law.softening * (crushed + by) > zero;
    return select(crushes, select(holds, by, zero - u_e), zero);
}

/// Share of the strength that is lost, in [0, 1].
[[nodiscard]] inline double strength_lost(const CrushingLaw<double>& law, double crushed)
{
    return std::min(1.0, law.softening * crushed / law.strength);
}

} // namespace dem
