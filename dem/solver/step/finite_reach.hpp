#pragma once
/// Blocks that slide beyond the blocks under them, onto the next ones.

#include "dem/kinematics/overlap.hpp"
#include "dem/solver/state/closing_joint.hpp"
#include "dem/solver/state/wall_state.hpp"

#include <cstddef>

namespace dem {

/// Per area [J/m2]. Area that comes into contact while a block slides brings this along, area
/// that leaves takes it away; neither is work of a force, so the ledger has it with the
/// friction.
template <class Law, class Real>
[[nodiscard]] Real stored_energy(const Law& law, Real stretch, Real sigma, Real tau)
{
    return Real(0.5) * (sigma * stretch + tau * tau * law.inv_ks);
}

/// Thickness that is crushed at both ends of an overlap [m].
template <class Real>
[[nodiscard]] EndDepths<Real> crushed_ends(const FiniteTables& t, const ContactRun& run,
                                           const WallState<Real>& s)
{
    if (s.crushed.empty()) return {};
    const int first = run.first, last = run.first + run.count - 1;
    const bool forward = t.place[first] <= t.place[last];
    return {s.crushed[forward ? first : last], s.crushed[forward ? last : first]};
}

/// Thickness that is crushed of a contact onto which a block slides. The block brings the
/// crushed face of its home along; what the contact crushes itself stays with it.
/// @param at contact of `further`;  home: contact of the pair it came from
/// @param u_n opening without what is crushed [m];  area of before this step, over which the
/// energy counts [m2]
/// @param crushed_by, pressure_at of the law of the contact, see crushing.hpp: of what is
/// crushed and of the opening
template <class Real, class Mask, class CrushedBy, class PressureAt>
Real crushed_further(std::size_t at, int home, Real u_n, Real area, Mask touches,
                     CrushedBy crushed_by, PressureAt pressure_at, WallState<Real>& s)
{
    Real& crushed = s.finite.further_crushed[at];
    const Real before = crushed, known = max(before, s.crushed[home]);
    const Real after = select(touches, known + crushed_by(known, u_n + known), before);
    const Real pressure = pressure_at(s.finite.further_u_n[at]) + pressure_at(u_n + after);
    s.crushing = multiply_add(area * (Real(0.5) * pressure), after - before, s.crushing);
    crushed = after;
    return after;
}

/// Stresses and energies of one contact of `further` after a step.
template <class Real> struct FurtherUpdate {
    Real sigma, tau;       ///< [Pa]
    Real friction, stored; ///< per area [J/m2]
    Real closing;          ///< lost in closing, per area [J/m2]
    Real pressure;         ///< of a joint that closes [Pa]
};

/// @param u_n gap where the contact is [m];  before area of before this step [m2]
template <class Real, class Mask>
FurtherUpdate<Real> advance_further_contact(const ContactRun& run, int i, std::size_t at,
                                            Real u_n, Real slip, Real before, Mask touches,
                                            WallState<Real>& s)
{
    const DryLaw<Real>& law = s.laws.dry[run.law];
    const Real zero(0.0);
    if (!s.crushed.empty())
        u_n += crushed_further(
            at, run.first + i, u_n, before, touches,
            [&](Real crushed, Real u_e) {
                return crushed_by(s.laws.dry_crushing[run.law], crushed, u_e);
            },
            [&](Real u_e) { return max(zero, zero - law.kn * u_e); }, s);
    const DryState<Real> last{zero, s.finite.further_tau[at]};
    const DryUpdate<Real> u =
        s.roughness.empty() ? advance(law, last, u_n, slip)
                            : advance(worn_law(s, run.law, run.first + i), last, u_n, slip);
    s.finite.further_u_n[at] = u_n;
    s.finite.further_tau[at] = select(touches, u.state.tau, zero);
    return {u.sigma,    u.state.tau,
            u.friction, stored_energy(law, u.state.u_n, u.sigma, u.state.tau),
            zero,       zero};
}

/// The same where joints close.
template <Closure kClosure, bool kLoses, class Real, class Mask>
FurtherUpdate<Real> advance_further_closing(const ContactRun& run, int i, std::size_t at,
                                            Real u_n, Real slip, Real before, Mask touches,
                                            WallState<Real>& s)
{
    const ClosureLaw<Real>& law = s.laws.closing[run.law];
    const Real zero(0.0);
    if (!s.crushed.empty())
        u_n += crushed_further(
            at, run.first + i, u_n, before, touches,
            [&](Real crushed, Real u_e) {
                return crushed_by<kClosure>(s.laws.dry_crushing[run.law], law, crushed, u_e);
            },
            [&](Real u_e) { return pressure_of<kClosure>(law, max(zero, -u_e)); }, s);
    const Real tan_phi = s.roughness.empty() ? s.laws.dry[run.law].tan_phi
                                             : worn_law(s, run.law, run.first + i).tan_phi;
    const ClosingState<Real> last = closing_further(s, at);
    const ClosingUpdate<Real> u =
        advance_closing<kClosure, kLoses>(law, tan_phi, last, u_n - last.u_n, slip);
    s.finite.further_u_n[at] = select(touches, u.state.u_n, zero);
    s.finite.further_shear[at] = select(touches, u.state.shear, zero);
    s.finite.further_rest[at] = select(touches, u.state.rest, zero);
    return {u.sigma,    u.tau,
            u.friction, stored_energy<kClosure>(law, u.state),
            u.closing,  select(touches, u.pressure, zero)};
}

/// A block and one onto which it slides. Both are felt as rigid: the elastic modes know the
/// contacts of the undeformed wall. It brings its worn and crushed face along.
/// @param active walls whose blocks have come that far
template <class Real, class Mask>
void advance_further(const StepTables& t, const ContactRun& run, int row, Mask active,
                     WallState<Real>& s)
{
    const FacePair& pair = t.finite.further[row];
    BlockFrame<Real>&a = s.finite.frames[pair.a], &b = s.finite.frames[pair.b];
    const Overlap<Real> o = overlap_of(pair, a, b, s.finite.further[row].centre);
    const Real before = s.finite.further[row].share;
    const Real share = select(active, share_of(pair, o, before, crushed_ends(t.finite, run, s)),
                              Real(0.0)),
               slip = slip_of(o, a, b);
    const Real grown = share - before;
    StressSum<Real> sum;
    Real friction(0.0), closing(0.0), stored(0.0), most(0.0); // [J], [J], [J], [Pa]
    for (int i = 0; i < run.count; ++i) {
        const std::size_t at = static_cast<std::size_t>(row) * t.finite.most_points + i;
        const Real place(t.finite.place[run.first + i]), area(t.area[run.first + i]);
        const Real u_n = multiply_add(place, o.widening, o.gap);
        const auto touches = share > Real(0.0);
        FurtherUpdate<Real> u;
        if (s.laws.closure == Closure::linear)
            u = advance_further_contact(run, i, at, u_n, slip, before * area, touches, s);
        else
            with_closure(s.laws, [&]<Closure kClosure, bool kLoses>() {
                u = advance_further_closing<kClosure, kLoses>(run, i, at, u_n, slip,
                                                              before * area, touches, s);
            });
        friction = multiply_add(area, u.friction, friction);
        closing = multiply_add(area, u.closing, closing);
        stored = multiply_add(area, u.stored, stored);
        sum.add(place, area * u.sigma, area * u.tau);
        most = max(most, u.pressure);
    }
    s.friction += share * friction - grown * stored;
    s.closing += share * closing;
    auto& last = s.finite.further[row];
    last = {o.gap,
            o.widening,
            share,
            Real(0.0),
            o.past_far,
            o.past_near,
            select(active, centre_of_pressure(o, sum), last.centre)};
    add_forces(o, sum.on(share), a, b);
    if (s.laws.closure == Closure::linear) return;
    const auto block = [&](int frame) { return frame == t.finite.ground ? kGround : frame; };
    with_closure(s.laws, [&]<Closure kClosure, bool>() {
        allow_for<kClosure>(t, run.law, {block(pair.a), block(pair.b)}, most, s);
    });
}

/// Blocks that overhang the last block under them. Where no wall of the register has such a
/// block nothing is done; a wall without one is not changed by its neighbours'.
template <class Real> void advance_reaches(const StepTables& t, WallState<Real>& s)
{
    for (const FiniteTables::Reach& r : t.finite.reaches) {
        const Real needs(kRoundedCorner * t.finite.pairs[r.home].length);
        const auto* last = &s.finite.pairs[r.home];
        auto active = needs > Real(0.0);
        for (int row = r.first; row < r.first + r.count; ++row) {
            const Real past = r.far ? last->past_far : last->past_near;
            active = active & ((past > needs) | (s.finite.further[row].share > Real(0.0)));
            if (!any(active)) break;
            advance_further(t, t.dry[r.run], row, active, s);
            last = &s.finite.further[row];
        }
    }
}

} // namespace dem
