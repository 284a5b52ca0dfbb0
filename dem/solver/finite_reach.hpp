#pragma once
/// Blocks that slide beyond the blocks under them, onto the next ones.

#include "dem/kinematics/overlap.hpp"
#include "dem/solver/wall_state.hpp"

#include <cstddef>

namespace dem {

/// Per area [J/m2]. Area that comes into contact while a block slides brings this along, area that
/// leaves takes it away; neither is work of a force, so the ledger has it with the friction.
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

/// Thickness that is crushed of a contact onto which a block slides. The block brings the crushed face of its home along;
/// what the contact crushes itself stays with it.
/// @param at contact of `further`;  home: contact of the pair it came from
/// @param u_n opening without what is crushed [m];  area of before this step, over which the energy counts [m2]
template <class Real, class Mask>
Real crushed_further(const CrushingLaw<Real>& law, std::size_t at, int home, Real u_n,
                     Real area, Mask touches, WallState<Real>& s)
{
    Real& crushed = s.finite.further_crushed[at];
    const Real before = crushed, known = max(before, s.crushed[home]);
    const Real after = select(touches, known + crushed_by(law, known, u_n + known), before);
    const Real pressure = max(Real(0.0), Real(0.0) - law.kn * s.finite.further_u_n[at]) +
                          max(Real(0.0), Real(0.0) - law.kn * (u_n + after));
    s.crushing = multiply_add(area * (Real(0.5) * pressure), after - before, s.crushing);
    crushed = after;
    return after;
}

/// A block and one onto which it slides. Both are felt as rigid: the elastic modes know the contacts of
/// the undeformed wall. It brings its worn and crushed face along.
/// @param active walls whose blocks have come that far
template <class Real, class Mask>
void advance_further(const StepTables& t, const ContactRun& run, int row, Mask active,
                     WallState<Real>& s)
{
    const DryLaw<Real> law = s.laws.dry[run.law];
    const FacePair& pair = t.finite.further[row];
    BlockFrame<Real>&a = s.finite.frames[pair.a], &b = s.finite.frames[pair.b];
    const Overlap<Real> o = overlap_of(pair, a, b, s.finite.further[row].centre);
    const Real before = s.finite.further[row].share;
    const Real share = select(active, share_of(pair, o, before, crushed_ends(t.finite, run, s)),
                              Real(0.0)),
               slip = slip_of(o, a, b);
    const Real grown = share - before;
    StressSum<Real> sum;
    Real friction(0.0), stored(0.0);
    for (int i = 0; i < run.count; ++i) {
        const std::size_t at = static_cast<std::size_t>(row) * t.finite.most_points + i;
        const Real place(t.finite.place[run.first + i]), area(t.area[run.first + i]);
        Real u_n = multiply_add(place, o.widening, o.gap);
        if (!s.crushed.empty())
            u_n += crushed_further(s.laws.dry_crushing[run.law], at, run.first + i, u_n,
                                   before * area, share > Real(0.0), s);
        const DryUpdate<Real> u =
            advance(s.roughness.empty() ? law : worn_law(s, run.law, run.first + i),
                    {Real(0.0), s.finite.further_tau[at]}, u_n, slip);
        s.finite.further_u_n[at] = u_n;
        s.finite.further_tau[at] = select(share > Real(0.0), u.state.tau, Real(0.0));
        friction = multiply_add(area, u.friction, friction);
        stored =
            multiply_add(area, stored_energy(law, u.state.u_n, u.sigma, u.state.tau), stored);
        sum.add(place, area * u.sigma, area * u.state.tau);
    }
    s.friction += share * friction - grown * stored;
    auto& last = s.finite.further[row];
    last = {o.gap,
            o.widening,
            share,
            Real(0.0),
            o.past_far,
            o.past_near,
            select(active, centre_of_pressure(o, sum), last.centre)};
    add_forces(o, sum.on(share), a, b);
}

/// Blocks that overhang the last block under them. Where no wall of the register has such a block
/// nothing is done; a wall without one is not changed by its neighbours'.
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
