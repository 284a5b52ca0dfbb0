#pragma once
/// The law of mixed modes for cracks in units and for joints with mortar, beside that of the
/// paper (contact_law.hpp): every loss of strength costs energy, in tension G_I, in shear G_II.
/// Its functions and states are those of the paper's law; CrackState means the same but for
/// `integrity`.
///
/// Tension as in the paper, x = u_n / u_max in [0, 1]:
///   u_n <= 0: sigma = k_n u_n        u_n > 0: sigma = (1 - D) f_T x        1 - D = (1 - d_t)(1
///   - d_s)
///   d_t = (u_max - u_el) / (u_ul - u_el),   u_ul = 2 G_I / f_T
/// Shear, elastic with k_s and plastic beyond the limit, with the pressure p = max(0, -sigma):
///   y = sqrt(1 - D), CrackState::integrity, is the share of the cohesion that is left
///   |tau| <= g (c_res + y c_drop) + p (tan_phi_res + y tan_phi_drop)
///   g = 1 where the crack is closed. Where it is open,
///     coulomb      max(0, 1 - sigma tan(phi) / c)
///     hyperbolic   sqrt((1 - x)(1 + x - 2 kappa x)),   kappa = min(1, f_T tan(phi) / c) of the
///     intact crack
///     and 0 once D = 1: a broken crack that is open carries nothing.
/// The hyperbolic curve is the conic tau^2 = c^2 - 2 c t sigma - (c^2 - 2 c t f_T)(sigma /
/// f_T)^2 with t = tan(phi): it meets Coulomb's line in (0, c) with its slope -t and goes
/// through (f_T, 0), so that compression is as it was and no tensile strength is lost. For c <
/// f_T t it is the chord between these points. The hyperbola of Carol, Prat and Lopez (1997),
/// tau^2 = (c - sigma t)^2 - (c - f_T t)^2, goes through (f_T, 0) but not through (0, c). Slip
/// costs more than friction takes: d_s grows so that
///   dD = dE_I / G_I + dE_II / G_II
/// on any path, with the energies that are lost through sigma and through tau less friction. A
/// crack that slips by ds while it is open also loses what is stored in tension; hence, with u
/// = x u_max,
///   dD = (|tau| - friction) ds / (G_II k),   k = 1 - u^2 / (u_max u_ul).
/// So D is the share of the fracture energy that is spent, and every path to D = 1 meets the
/// linear criterion E_I / G_I + E_II / G_II = 1 (Camanho and Davila 2002 compare it with that
/// of Benzeggagh and Kenane 1996). In pure shear y falls linearly with the slip, in pure
/// tension the law is that of the paper. Friction is p tan(phi), and the residual cohesion. A
/// crack cannot lose less in shear than it stores, c_drop^2 / (2 k_s). Where G_II is less, that
/// stands in its place, as f_T^2 / (2 k_n) does in tension: a closed crack then breaks at its
/// first slip, and one that opens loses strength as it slips against what is left of g. The
/// same holds of a hyperbolic envelope without G_II (0). Coulomb's without G_II is brittle as
/// the paper's: its first slip breaks a crack, closed or open. A crack without cohesion to lose
/// is broken by its first slip while it is closed.

#include "dem/contact/contact_law.hpp"
#include "dem/contact/pack.hpp"

namespace dem {

/// Stands for a softening in shear steeper than any k_s.
constexpr double kBreaksInShear = 1e300; // [Pa/m]

/// Constants of the law of mixed modes besides those of the CrackLaw.
template <class Real> struct MixedLaw {
    Real inv_energy; ///< 1 / (2 G_II) [m2/J]; 0 where no cohesion can be lost
    Real
        brittle; ///< kBreaksInShear where the first slip of the closed crack breaks it, else 0 [Pa/m]
    Real brittle_open; ///< the same of the open crack [Pa/m]
    Real inv_u_ul;     ///< 1 / max(u_ul, u_el) [1/m]
    Real kappa;        ///< of the hyperbolic envelope [-], in [0, 1]
    Real hyperbolic;   ///< 1, or 0 where the envelope is Coulomb's
};

/// x of a crack, in [0, 1].
template <class Real> [[nodiscard]] Real opening_share(Real u_n, Real u_max)
{
    constexpr double kNoLength = 1e-300; // u_max is 0 where f_T is
    return min(Real(1.0), max(Real(0.0), u_n) / max(Real(kNoLength), u_max));
}

/// g of an open crack.
template <class Real>
[[nodiscard]] Real cohesive_share(const CrackLaw<Real>& law, const MixedLaw<Real>& mixed,
                                  Real integrity, Real x, Real sigma)
{
    const Real zero(0.0), one(1.0);
    const Real curve =
        sqrt(max(zero, (one - x) * multiply_add(x, one - (mixed.kappa + mixed.kappa), one)));
    const Real cohesion = multiply_add(law.cohesion_drop, integrity, law.cohesion_res);
    const Real tan_phi = multiply_add(law.tan_phi_drop, integrity, law.tan_phi_res);
    const Real line = max(zero, one - law.tension_weight * sigma * tan_phi / cohesion);
    return select(integrity > zero, select(mixed.hyperbolic > zero, curve, line), zero);
}

/// The limit of tau by the integrity y.
template <class Real> struct ShearLimit {
    Real residual; ///< g c_res + p tan_phi_res [Pa]
    Real slope;    ///< g c_drop + p tan_phi_drop [Pa]
    Real cohesive; ///< g c_drop [Pa]
    Real held;     ///< g c_res [Pa]
    [[nodiscard]] Real at(Real integrity) const
    {
        return multiply_add(slope, integrity, residual);
    }
};

template <class Real>
[[nodiscard, gnu::always_inline]] inline ShearLimit<Real>
shear_limit(const CrackLaw<Real>& law, const MixedLaw<Real>& mixed, Real integrity, Real u_max,
            Real u_n, Real sigma)
{
    const Real zero(0.0);
    const Real pressure = max(zero, -sigma);
    const auto open = u_n > zero;
    Real share(1.0);
    if (any(open))
        share = select(open,
                       cohesive_share(law, mixed, integrity, opening_share(u_n, u_max), sigma),
                       share);
    const Real cohesive = law.cohesion_drop * share, held = law.cohesion_res * share;
    return {multiply_add(pressure, law.tan_phi_res, held),
            multiply_add(pressure, law.tan_phi_drop, cohesive), cohesive, held};
}

/// As that of the paper's law.
template <class Real>
[[nodiscard,
  gnu::always_inline]] inline ElasticTrial<Real> // called for every crack in every step
try_elastic(const CrackLaw<Real>& law, const MixedLaw<Real>& mixed, const CrackState<Real>& s,
            Real du_n, Real du_s)
{
    const Real u_n = s.u_n + du_n;
    const Real sigma = crack_stress<Unloading::secant>(law, s.unloading, u_n);
    const Real tau = multiply_add(law.ks, du_s, s.tau);
    const Real limit =
        shear_limit(law, mixed, s.integrity, s.u_max, u_n, sigma).at(s.integrity);
    const auto leaves = (u_n > s.u_max) | (abs(tau) > limit);
    return {u_n, tau, sigma, !any(leaves)};
}

/// The bond after a slip.
template <class Real> struct ShearReturn {
    Real tau;       ///< [Pa]
    Real integrity; ///< after the slip [-]
    Real friction;  ///< [J/m2]
    Real fracture;  ///< lost in shear [J/m2]
};

/// Returns tau* = tau + k_s du_s to the limit, which falls as the crack slips:
///   |tau*| - k_s ds = residual + slope (y - a ds),   a = g c_drop / (2 G_II k)
/// The damage is then that which the energy lost in this step pays for.
/// @param integrity before the slip
template <class Real>
[[nodiscard]] ShearReturn<Real>
return_to_limit(const CrackLaw<Real>& law, const MixedLaw<Real>& mixed,
                const ShearLimit<Real>& limit, const CrackState<Real>& s, Real integrity,
                Real u_max, Real u_n, Real sigma, Real du_s)
{
    const Real zero(0.0), half(0.5);
    constexpr double kLeastShare = 1e-9; // of G_II: k is 0 where x = 1 and D = 1 is near
    const Real trial = multiply_add(law.ks, du_s, s.tau);
    const auto yields = abs(trial) > limit.at(integrity);
    const Real stored = opening_share(u_n, u_max) * max(zero, u_n) * mixed.inv_u_ul;
    const Real cost = mixed.inv_energy / max(Real(kLeastShare), Real(1.0) - stored);
    const Real rate = limit.cohesive * cost;
    const Real softening =
        multiply_add(rate, limit.slope, select(u_n > zero, mixed.brittle_open, mixed.brittle));
    const Real slip_by = (abs(trial) - limit.at(integrity)) / (law.ks - softening);
    const Real left = select(softening < law.ks, integrity - rate * slip_by, zero);
    const auto gradual = left > zero;
    const Real broken = select(u_n > zero, zero, limit.residual);
    const Real end = select(gradual, limit.at(left), broken);
    const Real tau = select(yields, max(-end, min(end, trial)), trial);

    const Real slip = select(yields, du_s - (tau - s.tau) * law.inv_ks, zero);
    const Real lost = half * (s.tau + tau) * slip;
    const Real pressure = half * (max(zero, -s.sigma) + max(zero, -sigma));
    const Real tan_phi = multiply_add(law.tan_phi_drop, integrity, law.tan_phi_res);
    const Real rubs = multiply_add(pressure, tan_phi, limit.held) * abs(slip);
    const Real friction = select(integrity > zero, min(lost, rubs), lost);
    const Real fracture = lost - friction;
    const Real pays = multiply_add(Real(-2.0) * cost, fracture, integrity * integrity);
    const Real after = select(gradual, sqrt(max(zero, pays)), zero);
    return {tau, select(yields, after, integrity), friction, fracture};
}

/// A crack with damage of mixed modes. Where try_elastic holds, this gives the same bits.
template <class Real>
[[nodiscard]] CrackUpdate<Real> advance(const CrackLaw<Real>& law, const MixedLaw<Real>& mixed,
                                        const CrackState<Real>& s, Real du_n, Real du_s)
{
    constexpr auto kSecant = Unloading::secant;
    const Real zero(0.0);
    const Real u_n = s.u_n + du_n;
    const auto opens = u_n > s.u_max;
    const Real u_max = select(opens, u_n, s.u_max);
    const Real left = tension_left(law, u_max);
    const Real unloading_trial =
        select(opens, unloading_from<kSecant>(law, u_max, left * s.bond), s.unloading);
    const Real integrity_trial = select(opens, sqrt(left * s.bond), s.integrity);
    const Real sigma_trial = crack_stress<kSecant>(law, unloading_trial, u_n);

    const ShearLimit<Real> limit =
        shear_limit(law, mixed, integrity_trial, u_max, u_n, sigma_trial);
    const ShearReturn<Real> shear =
        return_to_limit(law, mixed, limit, s, integrity_trial, u_max, u_n, sigma_trial, du_s);
    const auto damages = shear.integrity < integrity_trial;
    const auto holds = shear.integrity > zero;
    const Real spared = shear.integrity * shear.integrity;
    const Real bond = select(damages, select(holds, spared / left, zero), s.bond);
    const Real unloading = select(
        damages,
        select(holds, unloading_trial * (spared / (integrity_trial * integrity_trial)), zero),
        unloading_trial);
    const Real sigma = crack_stress<kSecant>(law, unloading, u_n);
    const Real opening = opening_loss<kSecant>(s, u_n, sigma, unloading, opens);
    return {{u_n, shear.tau, sigma, u_max, bond, unloading, shear.integrity},
            {shear.friction, opening + shear.fracture}};
}

} // namespace dem
