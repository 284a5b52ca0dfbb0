#pragma once
/// The contact laws of the paper (Tables 1 and 2) as pure functions over Real = double or Pack:
/// they take a state and return a state.
///
/// Tension and opening are positive. The normal stress is a function of the total opening u_n
/// and of the damage; the shear stress is advanced by increments. Where the paper is silent or
/// misprinted, we chose:
///   - u_el = f_T / k_n. Table 2 prints f_T / u_n.
///   - Unloading in tension is secant to the origin, so that an open crack is in contact again
///     when it
///     closes to u_n = 0. The plain increments of Table 1 would leave it propped open, in
///     contact at
///     u_p = u_max - (1 - D) f_T/k_n. That is an option (Unloading).
///   - Where u_ul = 2 G / f_T <= u_el, that is f_T > sqrt(2 G k_n), the contact breaks at u_el
///     and
///     releases f_T^2/(2 k_n) > G.
///   - The shear limit is checked with the damage known so far. A contact that reaches it falls
///     to its
///     residual strength in the same step.
///   - Tension lowers the shear strength, as Table 2 (step 5) says. The other reading, a shear
///     strength
///     c under any tension, is an option. It decides whether units crack at all at moderate
///     stress
///     (docs/model.md).
///   - Between initial and residual friction, tan(theta) is interpolated and not theta. In the
///     paper the
///     two are equal, so that this makes no difference there.

#include "dem/contact/contact_options.hpp"
#include "dem/contact/pack.hpp"

namespace dem {

/// Energy lost by a contact in one update, per area [J/m2].
template <class Real> struct ContactLoss {
    Real friction;
    Real fracture;
};

template <class Real> struct DryLaw {
    Real kn;      ///< [Pa/m]
    Real ks;      ///< [Pa/m]
    Real inv_ks;  ///< [m/Pa]
    Real tan_phi; ///< [-]
};

template <class Real> struct DryState {
    Real u_n; ///< [m]
    Real tau; ///< [Pa]
};

/// Normal stress of a dry joint.   sigma = min(0, k_n u_n)
template <class Real> [[nodiscard]] Real dry_stress(const DryLaw<Real>& law, Real u_n)
{
    return min(Real(0.0), law.kn * u_n);
}

template <class Real> struct DryUpdate {
    DryState<Real> state;
    Real sigma;
    Real friction; ///< [J/m2]
    Real slip;     ///< plastic [m]
};

/// Dry joint: no tension, Coulomb friction.
///   sigma = min(0, k_n u_n),   tau* = tau + k_s du_s,   |tau| <= -sigma tan_phi
template <class Real>
[[nodiscard]] DryUpdate<Real> advance(const DryLaw<Real>& law, const DryState<Real>& s,
                                      Real du_n, Real du_s)
{
    const Real u_n = s.u_n + du_n;
    const Real sigma = dry_stress(law, u_n);
    const Real limit = -(sigma * law.tan_phi);
    const Real tau = max(-limit, min(limit, multiply_add(law.ks, du_s, s.tau)));
    const Real slip = du_s - (tau - s.tau) * law.inv_ks; // plastic part
    return {{u_n, tau}, sigma, Real(0.5) * (s.tau + tau) * slip, slip};
}

/// Stands for 1/(u_ul - u_el) of a contact that snaps back: any opening beyond u_el is full
/// damage.
constexpr double kBreaksAtOnce = 1e30; // [1/m]

template <class Real> struct CrackLaw {
    Real kn;            ///< [Pa/m]
    Real ks;            ///< [Pa/m]
    Real inv_ks;        ///< [m/Pa]
    Real ft;            ///< tensile strength [Pa]
    Real u_el;          ///< ft / kn [m]
    Real inv_softening; ///< 1/(u_ul - u_el) [1/m], or kBreaksAtOnce
    Real cohesion_res;  ///< [Pa]
    Real cohesion_drop; ///< initial - residual cohesion [Pa]
    Real tan_phi_res;   ///< [-]
    Real tan_phi_drop;  ///< initial - residual [-]
    Real
        tension_weight; ///< 1 where tension lowers the shear strength, 0 for the other reading [-]
};

template <class Real> struct CrackState {
    Real u_n;   ///< [m]
    Real tau;   ///< [Pa]
    Real sigma; ///< [Pa]
    Real u_max; ///< largest opening so far, at least u_el; beyond it the damage grows [m]
    Real bond;  ///< 1 - d_s: 1 while intact, 0 once the shear limit has been reached [-]
    Real
        unloading; ///< secant: sigma / u_n in tension [Pa/m]; elastic: u_p, where sigma = 0 [m]
    Real integrity; ///< what is left against slip, see Integrity [-]
};

template <Unloading kUnloading = Unloading::secant, class Real>
[[nodiscard]] CrackState<Real> intact(const CrackLaw<Real>& law)
{
    const Real zero(0.0), one(1.0);
    const Real unloading = kUnloading == Unloading::secant ? law.kn : zero;
    return {zero, zero, zero, law.u_el, one, unloading, one};
}

/// 1 - d_t (Table 2, step 3), from the largest opening so far.
template <class Real> [[nodiscard]] Real tension_left(const CrackLaw<Real>& law, Real u_max)
{
    return Real(1.0) - min(Real(1.0), (u_max - law.u_el) * law.inv_softening);
}

/// Whether damage in tension and damage in shear weaken each other. A further law has to
/// answer, or it does not compile.
[[nodiscard]] constexpr bool is_coupled(ContactLaw law)
{
    switch (law) {
    case ContactLaw::coupled:
        return true;
    case ContactLaw::uncoupled:
        return false;
    }
    __builtin_unreachable();
}

/// Calls `work.template operator()<kLaw>()` of the law: the one place that chooses.
template <class Work>
[[gnu::always_inline]] inline void with_contact_law(ContactLaw law, Work&& work)
{
    switch (law) {
    case ContactLaw::coupled:
        return work.template operator()<ContactLaw::coupled>();
    case ContactLaw::uncoupled:
        return work.template operator()<ContactLaw::uncoupled>();
    }
}

/// The integrity left against opening and against slip. With the coupled law both are
/// 1 - D = (1 - d_t)(1 - d_s) (Table 2, step 4).
template <ContactLaw kLaw, class Real> struct Integrity {
    Real normal;
    Real shear;
    Integrity(Real left, Real bond)
        : normal(is_coupled(kLaw) ? left * bond : left),
          shear(is_coupled(kLaw) ? left * bond : bond)
    {
    }
};

/// Normal stress at an opening of at most u_max.
///   secant    u_n <= 0: k_n u_n        u_n > 0: (1 - D) f_T u_n / u_max
///   elastic   k_n (u_n - u_p)
template <Unloading kUnloading, class Real>
[[nodiscard]] Real crack_stress(const CrackLaw<Real>& law, Real unloading, Real u_n)
{
    if constexpr (kUnloading == Unloading::secant)
        return select(u_n > Real(0.0), unloading, law.kn) * u_n;
    else
        return law.kn * (u_n - unloading);
}

/// CrackState::unloading of a crack that has opened to u_max and has the share 1 - D of its
/// strength left.
///   secant    (1 - D) f_T / u_max        elastic   u_p = u_max - (1 - D) f_T / k_n
template <Unloading kUnloading, class Real>
[[nodiscard]] Real unloading_from(const CrackLaw<Real>& law, Real u_max, Real left)
{
    if constexpr (kUnloading == Unloading::secant)
        return left * (law.ft / u_max);
    else
        return u_max - left * law.u_el;
}

/// CrackState::unloading after a shear failure at u_n, which leaves no strength in tension.
template <Unloading kUnloading, class Real>
[[nodiscard]] Real unloading_of_broken(Real unloading, Real u_n)
{
    if constexpr (kUnloading == Unloading::secant)
        return Real(0.0);
    else
        return max(unloading, u_n);
}

/// tau_max = c(D) - sigma tan(theta(D)), not below zero (Table 2, step 5).
template <class Real>
[[nodiscard]] Real shear_strength(const CrackLaw<Real>& law, Real integrity, Real sigma)
{
    const Real c = multiply_add(law.cohesion_drop, integrity, law.cohesion_res);
    const Real tan_phi = multiply_add(law.tan_phi_drop, integrity, law.tan_phi_res);
    const Real acting = min(Real(0.0), sigma) + law.tension_weight * max(Real(0.0), sigma);
    return max(Real(0.0), c - acting * tan_phi);
}

template <class Real> struct CrackUpdate {
    CrackState<Real> state;
    ContactLoss<Real> loss;
};

/// The state of a crack that opens no further than before and stays below its shear limit. Most
/// cracks do so most of the time. `holds` says whether this one does, in every lane; if it does
/// not, advance() has to be called instead, for all lanes.
template <class Real> struct ElasticTrial {
    Real u_n, tau, sigma;
    bool holds;
};

template <Unloading kUnloading = Unloading::secant, class Real>
[[nodiscard,
  gnu::always_inline]] inline ElasticTrial<Real> // called for every crack in every step
try_elastic(const CrackLaw<Real>& law, const CrackState<Real>& s, Real du_n, Real du_s)
{
    const Real u_n = s.u_n + du_n;
    const Real sigma = crack_stress<kUnloading>(law, s.unloading, u_n);
    const Real tau = multiply_add(law.ks, du_s, s.tau);
    const auto leaves = (u_n > s.u_max) | (abs(tau) > shear_strength(law, s.integrity, sigma));
    return {u_n, tau, sigma, !any(leaves)};
}

/// Energy lost in tension on the way from s to sigma and u_n.
///   secant    the work of sigma minus the change of sigma u_n / 2, which is zero as long as
///   sigma is
///             proportional to u_n
///   elastic   the work of sigma on the change of u_p, because sigma^2 / (2 k_n) is stored
template <Unloading kUnloading, class Real, class Mask>
[[nodiscard]] Real opening_loss(const CrackState<Real>& s, Real u_n, Real sigma, Real unloading,
                                Mask opens)
{
    if constexpr (kUnloading == Unloading::secant) {
        const Real changes = Real(0.5) * (s.sigma * u_n - sigma * s.u_n);
        return select(opens, changes, select(unloading < s.unloading, changes, Real(0.0)));
    } else {
        return Real(0.5) * (s.sigma + sigma) * (unloading - s.unloading);
    }
}

/// A potential crack in a unit (Table 2): linear softening in tension, brittle in shear. Where
/// try_elastic holds, this gives the same bits.
template <ContactLaw kLaw, Unloading kUnloading = Unloading::secant, class Real>
[[nodiscard]] CrackUpdate<Real> advance(const CrackLaw<Real>& law, const CrackState<Real>& s,
                                        Real du_n, Real du_s)
{
    const Real zero(0.0);
    const Real u_n = s.u_n + du_n;
    const auto opens = u_n > s.u_max;
    const Real u_max = select(opens, u_n, s.u_max);
    const Real left = tension_left(law, u_max);
    const Integrity<kLaw, Real> before(left, s.bond);
    const Real unloading_trial =
        select(opens, unloading_from<kUnloading>(law, u_max, before.normal), s.unloading);
    const Real integrity_trial = select(opens, before.shear, s.integrity);
    const Real sigma_trial = crack_stress<kUnloading>(law, unloading_trial, u_n);
    const Real tau_trial = multiply_add(law.ks, du_s, s.tau);

    const auto yields = abs(tau_trial) > shear_strength(law, integrity_trial, sigma_trial);
    const Real bond = select(yields, zero, s.bond);
    const Integrity<kLaw, Real> after(left, bond);
    const Real unloading =
        is_coupled(kLaw) ? select(yields, unloading_of_broken<kUnloading>(unloading_trial, u_n),
                                  unloading_trial)
                         : unloading_trial;
    const Real integrity = select(yields, after.shear, integrity_trial);
    const Real sigma = crack_stress<kUnloading>(law, unloading, u_n);
    const Real limit = shear_strength(law, integrity, sigma);
    const Real tau = select(yields, max(-limit, min(limit, tau_trial)), tau_trial);

    const Real slip = select(yields, du_s - (tau - s.tau) * law.inv_ks, zero);
    const Real shear_loss = Real(0.5) * (s.tau + tau) * slip;
    // In the step that breaks the bond, the work against the residual strength counts as
    // friction and the rest as fracture.
    const Real friction = select(bond < s.bond, min(shear_loss, abs(tau * slip)), shear_loss);
    const Real opening = opening_loss<kUnloading>(s, u_n, sigma, unloading, opens);
    // A propped crack that is broken in shear opens from u_p on; its d_t no longer matters.
    constexpr bool kOpensAtProp = is_coupled(kLaw) && kUnloading == Unloading::elastic;
    const Real opens_from = kOpensAtProp ? select(yields, unloading, u_max) : u_max;
    return {{u_n, tau, sigma, opens_from, bond, unloading, integrity},
            {friction, opening + (shear_loss - friction)}};
}

/// A crack that has lost its bond under compression: as one that has failed in shear.
template <ContactLaw kLaw, Unloading kUnloading, class Real>
[[nodiscard]] CrackState<Real> without_bond(const CrackState<Real>& s)
{
    CrackState<Real> broken = s;
    broken.bond = broken.integrity = Real(0.0);
    if constexpr (is_coupled(kLaw)) {
        broken.unloading = unloading_of_broken<kUnloading>(s.unloading, s.u_n);
        if constexpr (kUnloading == Unloading::elastic) broken.u_max = broken.unloading;
    }
    return broken;
}

/// D of Table 2.
template <class Real>
[[nodiscard]] Real damage(const CrackLaw<Real>& law, const CrackState<Real>& s)
{
    return Real(1.0) - tension_left(law, s.u_max) * s.bond;
}

} // namespace dem
