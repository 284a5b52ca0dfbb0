#pragma once
/// Dry joints that close under pressure, in a step. Joints become stiffer than the masses allow
/// for: where one does, both of its blocks get more mass, so that the step stays stable by the
/// same proof, and no other block pays.

#include "dem/scene/layout.hpp"
#include "dem/solver/state/wall_state.hpp"

#include <array>
#include <cstddef>

namespace dem {

/// Calls `work.template operator()<closure, loses>()` of the closure of the walls, which is not
/// linear.
template <class Real, class Work> void with_closure(const LaneLaws<Real>& laws, Work&& work)
{
    if (laws.closure == Closure::hyperbolic)
        laws.loses ? work.template operator()<Closure::hyperbolic, true>()
                   : work.template operator()<Closure::hyperbolic, false>();
    else
        laws.loses ? work.template operator()<Closure::exponential, true>()
                   : work.template operator()<Closure::exponential, false>();
}

/// State of one dry contact that closes.
template <class Real>
[[nodiscard]] ClosingState<Real> closing_state(const WallState<Real>& s, int k)
{
    return {s.u_n[k], s.shear[k], s.rest[k]};
}

/// The same of a contact of FiniteState::further.
template <class Real>
[[nodiscard]] ClosingState<Real> closing_further(const WallState<Real>& s, std::size_t at)
{
    return {s.finite.further_u_n[at], s.finite.further_shear[at], s.finite.further_rest[at]};
}

/// Work that crushing takes, per area [J/m2]. Where a contact crushes by more than it closes in
/// a step it gives back what it has stored.
/// @param before,sigma of before this step;  by what is crushed in it [m]
template <Closure kClosure, class Real>
[[nodiscard]] Real work_of_crushing(const ClosureLaw<Real>& law,
                                    const ClosingState<Real>& before, Real sigma, Real by,
                                    const ClosingUpdate<Real>& u)
{
    const Real zero(0.0), mean = Real(-0.5) * (sigma + u.sigma); // [Pa]
    const Real opens = max(zero, -before.u_n) - max(zero, -u.state.u_n);
    const auto stored = [&](const ClosingState<Real>& s) {
        return stored_energy<kClosure>(law, ClosingState<Real>{s.u_n, zero, s.rest});
    };
    const Real released = stored(before) - stored(u.state) - u.closing - mean * opens;
    return mean * by + select(opens > zero, released, zero);
}

/// Advances one contact that may crush as it closes.
/// @param area of before this step, over which the energy of crushing counts [m2]
template <Closure kClosure, bool kLoses, class Real>
[[gnu::noinline]] ClosingUpdate<Real> crush_and_close(int law, const ClosureLaw<Real>& closing,
                                                      Real tan_phi, int k, Real du_n, Real du_s,
                                                      Real area, WallState<Real>& s)
{
    const ClosingState<Real> before = closing_state(s, k);
    const Real by = crushed_by<kClosure>(s.laws.dry_crushing[law], closing, s.crushed[k],
                                         before.u_n + du_n);
    const ClosingUpdate<Real> u =
        advance_closing<kClosure, kLoses>(closing, tan_phi, before, du_n + by, du_s);
    const auto crushes = by > Real(0.0);
    if (!any(crushes)) return u;
    const Real work = work_of_crushing<kClosure>(closing, before, s.stress[2 * k], by, u);
    s.crushing = multiply_add(area, select(crushes, work, Real(0.0)), s.crushing);
    s.crushed[k] += by;
    return u;
}

/// Advances one contact: crushing, closure, friction, wear.
/// @param area of before this step, over which the energy of crushing counts [m2]
/// @param closing, tan_phi of that law; a copy of its own lets the numbers stay in registers
template <Closure kClosure, bool kLoses, class Real>
[[gnu::always_inline]] inline ClosingUpdate<Real>
advance_closing_contact(int law, const ClosureLaw<Real>& closing, Real tan_phi, int k,
                        Real du_n, Real du_s, Real area, WallState<Real>& s)
{
    const bool wears = !s.roughness.empty();
    if (wears) tan_phi = worn_law(s, law, k).tan_phi;
    const ClosingUpdate<Real> u =
        s.crushed.empty()
            ? advance_closing<kClosure, kLoses>(closing, tan_phi, closing_state(s, k), du_n,
                                                du_s)
            : crush_and_close<kClosure, kLoses>(law, closing, tan_phi, k, du_n, du_s, area, s);
    if (wears)
        s.roughness[k] = roughness_after(s.laws.dry_wear[law], s.roughness[k], u.slip, u.sigma);
    set_contact(s, k, u.state.u_n, u.sigma, u.tau);
    s.shear[k] = u.state.shear;
    if constexpr (kLoses) s.rest[k] = u.state.rest;
    return u;
}

/// Normal, under load, and tangential [Pa/m].
struct JointStiffness {
    double kn, ks;
};

/// The stiffness of a contact as far as it has closed.
template <Closure kClosure>
[[nodiscard]] JointStiffness stiffness_of(const WallState<double>& s, int law, int k)
{
    const ClosureLaw<double>& c = s.laws.closing[law];
    const auto [p, root, relative] = closed_by<kClosure>(c, max(0.0, -s.u_n[k]));
    return {tangent_at<kClosure>(c, p), root * root};
}

/// Stiffness of a joint under pressure, over the reference [-].
template <Closure kClosure, class Real>
[[nodiscard]] Real stiffness_under(const LaneLaws<Real>& laws, int law, Real pressure)
{
    const ClosureLaw<Real>& c = laws.closing[law];
    const Real normal = c.turning * tangent_at<kClosure>(c, pressure);
    const Real shear = c.root_ks * c.root_ks * multiply_add(pressure, c.inv_rise, Real(1.0));
    return max(normal * laws.inv_reference_kn, shear * laws.inv_reference_ks);
}

/// Largest pressure under which a joint has at most this stiffness, over the reference [Pa];
/// kNothingBorne where it has more without pressure.
template <Closure kClosure, class Real>
[[nodiscard]] Real pressure_of_stiffness(const LaneLaws<Real>& laws, int law, Real stiffness)
{
    const ClosureLaw<Real>& c = laws.closing[law];
    const Real one(1.0), zero(0.0), normal = stiffness / (c.turning * laws.inv_reference_kn);
    const Real over = max(one, normal / c.k0);
    const Real secant = kClosure == Closure::hyperbolic ? sqrt(over) : over;
    const Real by_normal = select(normal < c.stiffest, c.rise * (secant - one), Real(1e300));
    const Real by_shear =
        c.rise * (stiffness / (laws.inv_reference_ks * c.root_ks * c.root_ks) - one);
    const auto less = (normal < c.k0) | (by_shear < zero);
    return select(less, Real(kNothingBorne), min(by_normal, by_shear));
}

constexpr double kMassMargin = 1.1, kMassGrowth = 1.25; // free choices

/// Gives the blocks of a joint the masses for its stiffness under the largest pressure on it.
/// The momentum of a block stays, what that takes of its kinetic energy counts as damping.
/// Called in every step, before the blocks move: a step adds less than the margin.
template <Closure kClosure, class Real>
void allow_for(const StepTables& t, int law, const std::array<int, 2>& blocks, Real pressure,
               WallState<Real>& s)
{
    const Real needed = Real(kMassMargin) * stiffness_under<kClosure>(s.laws, law, pressure);
    for (const int block : blocks) {
        if (block == kGround || !any(needed > s.laws.ratio[block])) continue;
        const Real before = s.laws.ratio[block];
        const Real after = select(needed > before, Real(kMassGrowth) * needed, before);
        const auto& b = t.blocks[block];
        for (int m = b.first_mode; m < b.first_mode + b.modes; ++m) {
            const Real own = s.laws.elasticity[m], two(2.0);
            const Real lighter = multiply_add(two, before, own) / multiply_add(two, after, own);
            const Real v = s.v[m], lost = Real(0.5) * v * v / s.laws.inv_mass[m];
            s.damping = multiply_add(lost, Real(1.0) - lighter, s.damping);
            s.v[m] = v * lighter;
            s.laws.inv_mass[m] = s.laws.inv_mass[m] * lighter;
        }
        s.laws.ratio[block] = after;
    }
}

/// The same of a run of dry contacts, which remembers up to which pressure there is nothing to
/// do.
template <Closure kClosure, class Real>
[[gnu::always_inline]] inline void allow_for_run(const StepTables& t, std::size_t run,
                                                 Real pressure, WallState<Real>& s)
{
    constexpr double kSurely = 1.0 - 1e-9; // the pressure of hardly more than k_0 is rounding
    if (!any(pressure > s.borne[run])) return;
    const int law = t.dry[run].law;
    allow_for<kClosure>(t, law, t.dry_blocks[run], pressure, s);
    // The stiffness grows with the pressure.
    Real least(1e300);
    for (const int block : t.dry_blocks[run])
        if (block != kGround) least = min(least, s.laws.ratio[block]);
    s.borne[run] =
        pressure_of_stiffness<kClosure>(s.laws, law, least * Real(kSurely / kMassMargin));
}

} // namespace dem
