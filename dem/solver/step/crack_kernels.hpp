#pragma once
/// The laws that cracks may follow, and the one place that chooses between them.

#include "dem/contact/mixed_crack.hpp"
#include "dem/solver/state/wall_state.hpp"

namespace dem {

/// The law of the paper, for the cracks of one face.
template <ContactLaw kLaw, Unloading kUnloading, class Real> struct PaperCrack {
    const CrackLaw<Real>& law;

    PaperCrack(const LaneLaws<Real>& laws, int i) : law(laws.cracks[i]) {}
    [[nodiscard, gnu::always_inline]] ElasticTrial<Real> try_elastic(const CrackState<Real>& s,
                                                                     Real du_n, Real du_s) const
    {
        return dem::try_elastic<kUnloading>(law, s, du_n, du_s);
    }
    [[nodiscard]] CrackUpdate<Real> advance(const CrackState<Real>& s, Real du_n,
                                            Real du_s) const
    {
        return dem::advance<kLaw, kUnloading>(law, s, du_n, du_s);
    }
    [[nodiscard]] static CrackState<Real> without_bond(const CrackState<Real>& s)
    {
        return dem::without_bond<kLaw, kUnloading>(s);
    }
    /// Opening at which an open crack carries nothing [m].
    [[nodiscard]] static Real propped(const CrackState<Real>& s)
    {
        return kUnloading == Unloading::elastic ? s.unloading : Real(0.0);
    }
    static constexpr bool kShearEndsTension = is_coupled(kLaw);
};

/// The law of mixed modes, for the cracks of one face.
template <class Real> struct MixedCrack {
    const CrackLaw<Real>& law;
    const MixedLaw<Real>& mixed;

    MixedCrack(const LaneLaws<Real>& laws, int i) : law(laws.cracks[i]), mixed(laws.mixed[i]) {}
    [[nodiscard, gnu::always_inline]] ElasticTrial<Real> try_elastic(const CrackState<Real>& s,
                                                                     Real du_n, Real du_s) const
    {
        return dem::try_elastic(law, mixed, s, du_n, du_s);
    }
    [[nodiscard]] CrackUpdate<Real> advance(const CrackState<Real>& s, Real du_n,
                                            Real du_s) const
    {
        return dem::advance(law, mixed, s, du_n, du_s);
    }
    [[nodiscard]] static CrackState<Real> without_bond(const CrackState<Real>& s)
    {
        return dem::without_bond<ContactLaw::coupled, Unloading::secant>(s);
    }
    [[nodiscard]] static Real propped(const CrackState<Real>&) { return Real(0.0); }
    static constexpr bool kShearEndsTension = true;
};

/// Calls `work.template operator()<Law>()` of the law that the cracks of all lanes follow.
template <class Real, class Work>
void with_crack_law(ContactLaw law, const LaneLaws<Real>& laws, Work&& work)
{
    if (!laws.mixed.empty()) return work.template operator()<MixedCrack<Real>>();
    with_contact_law(law, [&]<ContactLaw kLaw>() {
        if (laws.unloading == Unloading::secant)
            work.template operator()<PaperCrack<kLaw, Unloading::secant, Real>>();
        else
            work.template operator()<PaperCrack<kLaw, Unloading::elastic, Real>>();
    });
}

/// crush() of a crack: where it has begun to crush, its bond is gone.
/// @param share of its area that is in contact [-]
template <class Law, class Real>
[[nodiscard]] Real crush_crack(const StepTables& t, int law, int k, Real du_n, Real share,
                               WallState<Real>& s)
{
    const Real rest = crush(s.laws.crack_crushing[law], k, du_n, share * Real(t.area[k]), s);
    const auto broken = s.crushed[k] > Real(0.0);
    if (!any(broken)) return rest;
    const CrackState<Real> after = Law::without_bond(crack_state(t, s, k));
    auto& memory = s.cracks[k - t.first_crack];
    memory = {select(broken, after.u_max, memory.u_max),
              select(broken, after.bond, memory.bond),
              select(broken, after.unloading, memory.unloading),
              select(broken, after.integrity, memory.integrity)};
    return rest;
}

/// Counts a crack that in this step for the first time has lost a part of its strength in
/// tension, or in shear, but not all. Where a shear failure ends tension, its opening after
/// that is no damage.
template <class Law, class Real>
void count_softened(const Law& law, const CrackState<Real>& before,
                    const CrackState<Real>& after, WallState<Real>& s)
{
    const Real zero(0.0), one(1.0);
    const Real left = tension_left(law.law, after.u_max);
    const Real bond = Law::kShearEndsTension ? after.bond : one;
    const Real opened = select(before.u_max > law.law.u_el, zero,
                               select(after.u_max > law.law.u_el, one, zero));
    s.softened_in_tension += select(left * bond > zero, opened, zero);
    const Real slipped = select(before.bond < one, zero, select(after.bond < one, one, zero));
    s.softened_in_shear += select(after.bond > zero, slipped, zero);
}

/// Moves crack contact k.
/// @param area over which its energy counts [m2]
template <class Law, class Real>
[[gnu::always_inline]] inline void move_crack(const StepTables& t, const Law& law,
                                              bool shortcuts, int k, Real du_n, Real du_s,
                                              Real area, WallState<Real>& s)
{
    const CrackState<Real> before = crack_state(t, s, k);
    const ElasticTrial<Real> trial = law.try_elastic(before, du_n, du_s);
    if (trial.holds && shortcuts) {
        set_contact(s, k, trial.u_n, trial.sigma, trial.tau);
        return;
    }
    const auto [c, loss] = law.advance(before, du_n, du_s);
    set_contact(s, k, c.u_n, c.sigma, c.tau);
    s.cracks[k - t.first_crack] = {c.u_max, c.bond, c.unloading, c.integrity};
    s.friction = multiply_add(area, loss.friction, s.friction);
    s.fracture = multiply_add(area, loss.fracture, s.fracture);
    count_softened(law, before, c, s);
}

} // namespace dem
