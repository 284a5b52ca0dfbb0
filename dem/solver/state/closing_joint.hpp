#pragma once
/// Dry joints that close under pressure, in a step. Joints become stiffer than the masses allow
/// for: where one does, both of its blocks get more mass, so that the step stays stable by the
/// same proof, and no other block pays.

#include "dem/scene/layout.hpp"
#include "dem/solver/state/wall_state.hpp"

#include <algorithm>
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

/// Normal, under load, and tangential [Pa/m].
struct JointStiffness {
    double kn, ks;
};

/// The stiffness of a contact as far as it has closed.
template <Closure kClosure>
[[nodiscard]] JointStiffness stiffness_of(const WallState<double>& s, int law, int k)
{
    const ClosureLaw<double>& c = s.laws.closing[law];
    const auto closed = closed_by<kClosure>(c, max(0.0, -s.u_n[k]));
    const double root = closed.root_ks(c);
    return {tangent_at<kClosure>(c, closed.p), root * root};
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

/// Relative displacement of a contact in a step [m].
template <class Real> struct ContactStep {
    Real normal, tangential;
};

/// Thickness of a contact that is crushed in a step [m].
template <Closure kClosure, class Real>
[[gnu::noinline]] Real crushed_in_step(const WallState<Real>& s, int law, int k, Real du_n)
{
    return crushed_by<kClosure>(s.laws.dry_crushing[law], s.laws.closing[law], s.crushed[k],
                                s.u_n[k] + du_n);
}

/// Crushes a contact, before it gets its new state and stresses.
template <Closure kClosure, class Real>
[[gnu::noinline]] void crush_closing(int law, int k, Real by, Real area,
                                     const ClosingUpdate<Real>& u, WallState<Real>& s)
{
    const auto crushes = by > Real(0.0);
    if (!any(crushes)) return;
    const Real work = work_of_crushing<kClosure>(s.laws.closing[law], closing_state(s, k),
                                                 s.stress[2 * k], by, u);
    s.crushing = multiply_add(area, select(crushes, work, Real(0.0)), s.crushing);
    s.crushed[k] += by;
}

/// Advances the contacts of a run: crushing, closure, friction, wear, masses. All of them close
/// before the first one slides: so the root or the exponential of one contact, which take long,
/// are at work together with those of the others.
/// @param kPlain whether nothing can crush or wear
/// @param r number of the run
/// @param share of the area of its contacts, before this step, over which crushing counts [-]
/// @param moved called as moved(k), gives a ContactStep, once for each contact
/// @param done called as done(k, ClosingUpdate), once for each contact, in order
template <Closure kClosure, bool kLoses, bool kPlain, class Real, class Moved, class Done>
[[gnu::always_inline]] inline void advance_closing_run(const StepTables& t, std::size_t r,
                                                       Real share, WallState<Real>& s,
                                                       Moved moved, Done done)
{
    constexpr int kAtOnce = 8;
    const int law = t.dry[r].law, last = t.dry[r].first + t.dry[r].count;
    const ClosureLaw<Real>& closing = s.laws.closing[law];
    const bool crushes = !kPlain && !s.crushed.empty(), wears = !kPlain && !s.roughness.empty();
    Closed<kClosure, Real> closed[kAtOnce];
    Real u_n[kAtOnce], du_s[kAtOnce], by[kPlain ? 1 : kAtOnce]; // by: crushed [m]
    Real most(0.0);                                             // pressure [Pa]
    for (int first = t.dry[r].first; first < last; first += kAtOnce) {
        const int n = std::min(kAtOnce, last - first);
        for (int i = 0; i < n; ++i) {
            const int k = first + i;
            auto [normal, tangential] = moved(k);
            if (crushes) {
                by[i] = crushed_in_step<kClosure>(s, law, k, normal);
                normal += by[i];
            }
            du_s[i] = tangential;
            u_n[i] = s.u_n[k] + normal;
            closed[i] = closed_by<kClosure>(closing, max(Real(0.0), -u_n[i]));
        }
        for (int i = 0; i < n; ++i) {
            const int k = first + i;
            const Real tan_phi = wears ? worn_law(s, law, k).tan_phi : s.laws.dry[law].tan_phi;
            const ClosingUpdate<Real> u = slide_closed<kClosure, kLoses>(
                closing, tan_phi, closing_state(s, k), u_n[i], closed[i], du_s[i]);
            if (crushes) crush_closing<kClosure>(law, k, by[i], share * Real(t.area[k]), u, s);
            if (wears)
                s.roughness[k] =
                    roughness_after(s.laws.dry_wear[law], s.roughness[k], u.slip, u.sigma);
            set_contact(s, k, u.state.u_n, u.sigma, u.tau);
            s.shear[k] = u.state.shear;
            if constexpr (kLoses) s.rest[k] = u.state.rest;
            most = max(most, u.pressure);
            done(k, u);
        }
    }
    allow_for_run<kClosure>(t, r, most, s);
}

} // namespace dem
