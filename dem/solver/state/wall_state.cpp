#include "dem/solver/state/wall_state.hpp"

#include "dem/block/model.hpp"
#include "dem/solver/state/closing_joint.hpp"

#include <algorithm>
#include <cmath>

namespace dem {

template <class Real> void clear_lane(const StepTables& t, int lane, WallState<Real>& s)
{
    for (auto* values :
         {&s.q, &s.v, &s.last_force, &s.du, &s.stress, &s.u_n, &s.crushed, &s.shear, &s.rest})
        for (Real& x : *values) set_lane(x, lane, 0.0);
    for (Real& r : s.roughness) set_lane(r, lane, 1.0);
    for (Real& p : s.borne) set_lane(p, lane, kNothingBorne);
    for (Real* x : {&s.work, &s.friction, &s.fracture, &s.crushing, &s.damping, &s.closing,
                    &s.top_force, &s.base_shear, &s.load_x, &s.body_factor,
                    &s.softened_in_tension, &s.softened_in_shear})
        set_lane(*x, lane, 0.0);
    if (!s.finite.frames.empty()) clear_lane(t.finite, lane, s.finite);
}

template <class Real>
void load_lane(const Model& m, const StepTables& t, const WallMaterials& w,
               const SolverOptions& options, int lane, WallState<Real>& s)
{
    clear_lane(t, lane, s);
    set_laws(m, t, w, options, lane, s.laws);
    for (const ContactRun& run : t.cracks) {
        const CrackLaw<Real>& law = s.laws.cracks[run.law];
        const CrackState<Real> fresh = s.laws.unloading == Unloading::secant
                                           ? intact<Unloading::secant>(law)
                                           : intact<Unloading::elastic>(law);
        for (int k = run.first; k < run.first + run.count; ++k) {
            auto& memory = s.cracks[k - t.first_crack];
            set_lane(memory.u_max, lane, dem::lane(fresh.u_max, lane));
            set_lane(memory.bond, lane, dem::lane(fresh.bond, lane));
            set_lane(memory.unloading, lane, dem::lane(fresh.unloading, lane));
            set_lane(memory.integrity, lane, dem::lane(fresh.integrity, lane));
        }
    }
    if (!s.finite.frames.empty()) load_lane(m, t.finite, w, lane, s.finite);
}

template <class Real>
WallState<Real> empty_lanes(const Model& m, const StepTables& t, Kinematics kinematics)
{
    WallState<Real> s;
    s.laws = empty_laws<Real>(m, t);
    for (auto* by_mode : {&s.q, &s.v, &s.last_force}) by_mode->assign(m.n_modes, Real(0.0));
    if (t.body_forces)
        for (auto* by_mode : {&s.total, &s.loaded, &s.pull})
            by_mode->assign(m.n_modes, Real(0.0));
    int most = 0;
    for (const auto& b : t.blocks) most = std::max(most, b.modes);
    s.block_force.assign(most, Real(0.0));
    s.du.assign(static_cast<std::size_t>(2) * t.n_contacts, Real(0.0));
    s.stress = s.du;
    s.u_n.assign(t.n_contacts, Real(0.0));
    s.cracks.resize(m.cracks.size());
    if (m.layout.crushing) s.crushed.assign(t.n_contacts, Real(0.0));
    if (m.layout.wear) s.roughness.assign(m.dry.size(), Real(1.0));
    if (m.layout.closure != Closure::linear) {
        s.shear.assign(m.dry.size(), Real(0.0));
        s.rest = s.shear;
        s.borne.assign(t.dry.size(), Real(kNothingBorne));
    }
    if (kinematics == Kinematics::finite)
        s.finite = undeformed<Real>(t.finite, m.n_modes, t.n_contacts, m.layout.crushing,
                                    m.layout.closure != Closure::linear);
    return s;
}

template <class Real>
WallState<Real> unloaded(const Model& m, const StepTables& t,
                         std::span<const WallMaterials> walls, const SolverOptions& options)
{
    WallState<Real> s = empty_lanes<Real>(m, t, options.kinematics);
    for (int i = 0; i < lanes<Real>; ++i)
        load_lane(m, t, walls[std::min<std::size_t>(i, walls.size() - 1)], options, i, s);
    return s;
}

/// Stored in a contact that closes, per area [J/m2].
template <class Real>
double stored_of(const WallState<Real>& s, int law, const ClosingState<Real>& state, int lane)
{
    ClosureLaw<double> one;
    for_each_number(s.laws.closing[law], one,
                    [lane](const Real& from, double& x) { x = dem::lane(from, lane); });
    const ClosingState<double> contact{dem::lane(state.u_n, lane), dem::lane(state.shear, lane),
                                       dem::lane(state.rest, lane)};
    return s.laws.closure == Closure::hyperbolic
               ? stored_energy<Closure::hyperbolic>(one, contact)
               : stored_energy<Closure::exponential>(one, contact);
}

/// Energy in the contacts of blocks with those onto which they have slid.
template <class Real>
double stored_further(const StepTables& t, const FiniteTables::Reach& r,
                      const WallState<Real>& s, int lane)
{
    const ContactRun& run = t.dry[r.run];
    const double kn = dem::lane(s.laws.dry[run.law].kn, lane),
                 inv_ks = dem::lane(s.laws.dry[run.law].inv_ks, lane);
    const bool closes = s.laws.closure != Closure::linear;
    double sum = 0.0;
    for (int row = r.first; row < r.first + r.count; ++row) {
        const double share = dem::lane(s.finite.further[row].share, lane);
        if (share == 0.0) continue;
        for (int i = 0; i < run.count; ++i) {
            const auto at = static_cast<std::size_t>(row) * t.finite.most_points + i;
            const double u_n = std::min(0.0, dem::lane(s.finite.further_u_n[at], lane)),
                         tau = dem::lane(s.finite.further_tau[at], lane);
            const double area = share * t.area[run.first + i];
            sum += closes ? area * stored_of(s, run.law, closing_further(s, at), lane)
                          : 0.5 * area * (kn * u_n * u_n + tau * tau * inv_ks);
        }
    }
    return sum;
}

template <class Real> Energy energy_of(const StepTables& t, const WallState<Real>& s, int lane)
{
    Energy e;
    const auto at = [lane](const Real& x) { return dem::lane(x, lane); };
    for (std::size_t i = 0; i < s.q.size(); ++i) {
        e.kinetic += 0.5 * at(s.v[i]) * at(s.v[i]) / at(s.laws.inv_mass[i]);
        e.elastic += 0.5 * at(s.laws.elasticity[i]) * at(s.q[i]) * at(s.q[i]);
    }
    std::size_t pair = 0;
    const auto share_of_pair = [&] {
        return s.finite.pairs.empty() ? 1.0 : at(s.finite.pairs[pair].share);
    };
    const auto closing = [&] {
        for (const ContactRun& run : t.dry) {
            const double share = share_of_pair();
            ++pair;
            for (int k = run.first; k < run.first + run.count; ++k)
                e.elastic +=
                    share * t.area[k] * stored_of(s, run.law, closing_state(s, k), lane);
        }
    };
    // All of u_n springs back, or sigma / k_n where a crack stays propped open.
    const auto contacts = [&](const std::vector<ContactRun>& runs, const auto& laws,
                              bool propped) {
        for (const ContactRun& run : runs) {
            const double kn = at(laws[run.law].kn), inv_ks = at(laws[run.law].inv_ks);
            const double share = share_of_pair();
            ++pair;
            for (int k = run.first; k < run.first + run.count; ++k) {
                const double sigma = at(s.stress[2 * k]), tau = at(s.stress[2 * k + 1]);
                const double springs_back = propped ? sigma / kn : at(s.u_n[k]);
                e.elastic +=
                    0.5 * (share * t.area[k]) * (sigma * springs_back + tau * tau * inv_ks);
            }
        }
    };
    if (s.laws.closure == Closure::linear)
        contacts(t.dry, s.laws.dry, false);
    else
        closing();
    contacts(t.tied, s.laws.tied, false);
    contacts(t.cracks, s.laws.cracks, s.laws.unloading == Unloading::elastic);
    for (const FiniteTables::Reach& r : t.finite.reaches)
        if (!s.finite.frames.empty()) e.elastic += stored_further(t, r, s, lane);
    e.work = at(s.work);
    e.friction = at(s.friction);
    e.fracture = at(s.fracture);
    e.crushing = at(s.crushing);
    e.damping = at(s.damping);
    e.closing = at(s.closing);
    return e;
}

template void clear_lane(const StepTables&, int, WallState<double>&);
template WallState<double> empty_lanes(const Model&, const StepTables&, Kinematics);
template void load_lane(const Model&, const StepTables&, const WallMaterials&,
                        const SolverOptions&, int, WallState<double>&);
template WallState<double> unloaded(const Model&, const StepTables&,
                                    std::span<const WallMaterials>, const SolverOptions&);
template Energy energy_of(const StepTables&, const WallState<double>&, int);
template void clear_lane(const StepTables&, int, WallState<Pack>&);
template WallState<Pack> empty_lanes(const Model&, const StepTables&, Kinematics);
template void load_lane(const Model&, const StepTables&, const WallMaterials&,
                        const SolverOptions&, int, WallState<Pack>&);
template WallState<Pack> unloaded(const Model&, const StepTables&,
                                  std::span<const WallMaterials>, const SolverOptions&);
template Energy energy_of(const StepTables&, const WallState<Pack>&, int);

} // namespace dem
