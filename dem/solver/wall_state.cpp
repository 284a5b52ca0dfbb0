#include "dem/solver/wall_state.hpp"

#include "dem/block/model.hpp"

#include <algorithm>
#include <cmath>

namespace dem {

namespace {

/// By block: the largest ratio of the stiffness of its contacts to the reference stiffness [-].
std::vector<double> stiffness_ratio(const Model& m, const WallMaterials& w)
{
    std::vector<double> ratio(m.layout.blocks.size(), 0.0);
    for (const Face& f : m.layout.faces) {
        double r = 0.0;
        if (f.kind == FaceKind::unit_crack) {
            const CrackMaterial& c = w.cracks[f.id - 1];
            const auto [kn, ks] = reference_of(m, f);
            r = std::max(c.kn / kn, c.ks / ks);
        } else {
            const JointMaterial& j = f.kind == FaceKind::base_joint   ? w.base_joint
                                     : f.kind == FaceKind::beam_joint ? w.beam_joint
                                                                      : w.joints[f.id - 1];
            r = std::max(j.kn / m.reference.joint.kn, j.ks / m.reference.joint.ks);
        }
        for (const int block : {f.a, f.b})
            if (block != kGround) ratio[block] = std::max(ratio[block], r);
    }
    return ratio;
}

CrackLaw<double> crack_law(const CrackMaterial& c)
{
    CrackLaw<double> law;
    law.kn = c.kn;
    law.ks = c.ks;
    law.inv_ks = 1.0 / c.ks;
    law.ft = c.ft;
    law.u_el = c.ft / c.kn;
    const double u_ul = c.ft > 0.0 ? 2.0 * c.fracture_energy / c.ft : 0.0;
    law.inv_softening = u_ul > law.u_el ? 1.0 / (u_ul - law.u_el) : kBreaksAtOnce;
    law.cohesion_res = c.cohesion_res;
    law.cohesion_drop = c.cohesion - c.cohesion_res;
    law.tan_phi_res = c.tan_phi_res;
    law.tan_phi_drop = c.tan_phi - c.tan_phi_res;
    law.tension_weight = c.tension_reduces_shear ? 1.0 : 0.0;
    return law;
}

template <class Real> void set_law(int i, const JointMaterial& j, DryLaw<Real>& law)
{
    set_lane(law.kn, i, j.kn);
    set_lane(law.ks, i, j.ks);
    set_lane(law.inv_ks, i, 1.0 / j.ks);
    set_lane(law.tan_phi, i, j.tan_phi);
}

template <class Real> void set_law(int i, const CrackMaterial& c, CrackLaw<Real>& law)
{
    const CrackLaw<double> one = crack_law(c);
    set_lane(law.kn, i, one.kn);
    set_lane(law.ks, i, one.ks);
    set_lane(law.inv_ks, i, one.inv_ks);
    set_lane(law.ft, i, one.ft);
    set_lane(law.u_el, i, one.u_el);
    set_lane(law.inv_softening, i, one.inv_softening);
    set_lane(law.cohesion_res, i, one.cohesion_res);
    set_lane(law.cohesion_drop, i, one.cohesion_drop);
    set_lane(law.tan_phi_res, i, one.tan_phi_res);
    set_lane(law.tan_phi_drop, i, one.tan_phi_drop);
    set_lane(law.tension_weight, i, one.tension_weight);
}

template <class Real>
void set_law(int i, double kn, const Crushing& crushing, CrushingLaw<Real>& law)
{
    const CrushingLaw<double> one = crushing_law(kn, crushing.strength, crushing.energy);
    set_lane(law.kn, i, one.kn);
    set_lane(law.strength, i, one.strength);
    set_lane(law.softening, i, one.softening);
    set_lane(law.flow, i, one.flow);
}

template <class Real> void set_law(int i, const JointMaterial& j, WearLaw<Real>& law)
{
    const bool wears = j.wear.length > 0.0;
    set_lane(law.drop, i, wears ? j.tan_phi - j.wear.tan_phi_res : 0.0);
    set_lane(law.inv_length, i, wears ? 1.0 / j.wear.length : 0.0);
}

/// By joint ID, then base and beam; by crack ID, then joints with mortar.
template <class Real>
void set_crushing(const Model& m, const WallMaterials& w, int lane, LaneLaws<Real>& laws)
{
    const auto set = [lane](const auto& material, CrushingLaw<Real>& law) {
        set_law(lane, material.kn, material.crushing, law);
    };
    for (int j = 0; j < m.layout.n_joints; ++j) set(w.joints[j], laws.dry_crushing[j]);
    set(w.base_joint, laws.dry_crushing[m.layout.n_joints]);
    set(w.beam_joint, laws.dry_crushing[m.layout.n_joints + 1]);
    for (int i = 0; i < m.layout.n_cracks; ++i) set(w.cracks[i], laws.crack_crushing[i]);
    if (m.layout.mortar)
        for (int j = 0; j < m.layout.n_joints; ++j)
            set(w.joints[j], laws.crack_crushing[m.layout.n_cracks + j]);
}

/// By joint ID, then base and beam.
template <class Real>
void set_wear(const Model& m, const WallMaterials& w, int lane,
              std::vector<WearLaw<Real>>& laws)
{
    for (int j = 0; j < m.layout.n_joints; ++j) set_law(lane, w.joints[j], laws[j]);
    set_law(lane, w.base_joint, laws[m.layout.n_joints]);
    set_law(lane, w.beam_joint, laws[m.layout.n_joints + 1]);
}

/// Loads, elasticity and fictitious masses of one lane.
template <class Real>
void set_modes(const Model& m, const StepTables& t, const WallMaterials& w,
               const SolverOptions& options, int lane, WallState<Real>& s)
{
    const std::vector<double> ratio = stiffness_ratio(m, w);
    const double stress = w.vertical_stress.value_or(m.loads.vertical_stress);
    for (std::size_t b = 0; b < t.blocks.size(); ++b) {
        const bool is_beam = static_cast<int>(b) == m.layout.beam;
        const BlockElement& e = m.elements[t.blocks[b].element];
        const Elastic& material = stone_of(m, static_cast<int>(b), w.stone);
        const double softer =
            material.young_modulus / stone_of(m, static_cast<int>(b), m.stone).young_modulus;
        for (int i = 0; i < t.blocks[b].modes; ++i) {
            const int mode = t.blocks[b].first_mode + i;
            const double lambda = t.lambda[mode] * softer;
            const double load = material.density * m.loads.gravity * e.weight(i) +
                                (is_beam ? stress * e.top_load(i) : 0.0);
            // Damping adds up to gamma |F| to a force that opposes the motion, hence 1 + gamma.
            const double f2 =
                options.step_fraction * options.step_fraction / (1.0 + options.damping_factor);
            set_lane(s.laws.elasticity[mode], lane, lambda);
            set_lane(s.laws.load[mode], lane, load);
            set_lane(s.laws.inv_mass[mode], lane, 4.0 * f2 / (lambda + 2.0 * ratio[b]));
            if (!t.body_forces) continue;
            const double pull = material.density * m.loads.gravity; // [N/m3]
            set_lane(s.laws.weight[mode], lane, pull * e.weight(i));
            set_lane(s.laws.sway[mode], lane, pull * e.sway(i));
        }
    }
}

/// Weights of one lane.
template <class Real>
void set_weights(const Model& m, const WallMaterials& w, int lane, LaneLaws<Real>& laws)
{
    double whole = 0.0, supported = 0.0; // [N]
    for (int b = 0; b < static_cast<int>(m.layout.blocks.size()); ++b) {
        const double volume = area_of(m.layout.blocks[b]) * m.layout.thickness;
        const double weight = volume * stone_of(m, b, w.stone).density * m.loads.gravity;
        whole += weight;
        if (is_supported(m, b)) supported += weight;
    }
    set_lane(laws.whole_weight, lane, whole);
    set_lane(laws.supported_weight, lane, supported);
}

} // namespace

template <class Real> void clear_lane(const StepTables& t, int lane, WallState<Real>& s)
{
    for (auto* values : {&s.q, &s.v, &s.last_force, &s.du, &s.stress, &s.u_n, &s.crushed})
        for (Real& x : *values) set_lane(x, lane, 0.0);
    for (Real& r : s.roughness) set_lane(r, lane, 1.0);
    for (Real* x : {&s.work, &s.friction, &s.fracture, &s.crushing, &s.damping, &s.top_force,
                    &s.base_shear, &s.load_x, &s.body_factor})
        set_lane(*x, lane, 0.0);
    if (!s.finite.frames.empty()) clear_lane(t.finite, lane, s.finite);
}

template <class Real>
void load_lane(const Model& m, const StepTables& t, const WallMaterials& w,
               const SolverOptions& options, int lane, WallState<Real>& s)
{
    clear_lane(t, lane, s);
    s.laws.unloading = options.unloading;
    for (int j = 0; j < m.layout.n_joints; ++j) set_law(lane, w.joints[j], s.laws.dry[j]);
    set_law(lane, w.base_joint, s.laws.dry[m.layout.n_joints]);
    set_law(lane, w.beam_joint, s.laws.dry[m.layout.n_joints + 1]);
    set_law(lane, w.beam_joint, s.laws.tied[0]);
    for (int i = 0; i < m.layout.n_cracks; ++i) set_law(lane, w.cracks[i], s.laws.cracks[i]);
    if (m.layout.mortar)
        for (int j = 0; j < m.layout.n_joints; ++j)
            set_law(lane, bond_of(w.joints[j]), s.laws.cracks[m.layout.n_cracks + j]);
    if (m.layout.crushing) set_crushing(m, w, lane, s.laws);
    if (m.layout.wear) set_wear(m, w, lane, s.laws.dry_wear);
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
    set_modes(m, t, w, options, lane, s);
    if (t.body_forces) set_weights(m, w, lane, s.laws);
    if (!s.finite.frames.empty()) load_lane(m, t.finite, w, lane, s.finite);
}

template <class Real>
WallState<Real> empty_lanes(const Model& m, const StepTables& t, Kinematics kinematics)
{
    WallState<Real> s;
    for (auto* by_mode :
         {&s.q, &s.v, &s.last_force, &s.laws.inv_mass, &s.laws.load, &s.laws.elasticity})
        by_mode->assign(m.n_modes, Real(0.0));
    if (t.body_forces)
        for (auto* by_mode : {&s.laws.weight, &s.laws.sway, &s.total, &s.loaded, &s.pull})
            by_mode->assign(m.n_modes, Real(0.0));
    int most = 0;
    for (const auto& b : t.blocks) most = std::max(most, b.modes);
    s.block_force.assign(most, Real(0.0));
    s.du.assign(static_cast<std::size_t>(2) * t.n_contacts, Real(0.0));
    s.stress = s.du;
    s.u_n.assign(t.n_contacts, Real(0.0));
    s.cracks.resize(m.cracks.size());
    s.laws.dry.resize(m.layout.n_joints + 2);
    s.laws.tied.resize(1);
    s.laws.cracks.resize(m.layout.n_cracks + (m.layout.mortar ? m.layout.n_joints : 0));
    if (m.layout.crushing) {
        s.crushed.assign(t.n_contacts, Real(0.0));
        s.laws.dry_crushing.resize(s.laws.dry.size());
        s.laws.crack_crushing.resize(s.laws.cracks.size());
    }
    if (m.layout.wear) {
        s.roughness.assign(m.dry.size(), Real(1.0));
        s.laws.dry_wear.resize(s.laws.dry.size());
    }
    if (kinematics == Kinematics::finite)
        s.finite = undeformed<Real>(t.finite, m.n_modes, t.n_contacts, m.layout.crushing);
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

/// Energy in the contacts of blocks with those onto which they have slid.
template <class Real>
double stored_further(const StepTables& t, const FiniteTables::Reach& r,
                      const WallState<Real>& s, int lane)
{
    const ContactRun& run = t.dry[r.run];
    const double kn = dem::lane(s.laws.dry[run.law].kn, lane),
                 inv_ks = dem::lane(s.laws.dry[run.law].inv_ks, lane);
    double sum = 0.0;
    for (int row = r.first; row < r.first + r.count; ++row) {
        const double share = dem::lane(s.finite.further[row].share, lane);
        if (share == 0.0) continue;
        for (int i = 0; i < run.count; ++i) {
            const auto at = static_cast<std::size_t>(row) * t.finite.most_points + i;
            const double u_n = std::min(0.0, dem::lane(s.finite.further_u_n[at], lane)),
                         tau = dem::lane(s.finite.further_tau[at], lane);
            sum +=
                0.5 * (share * t.area[run.first + i]) * (kn * u_n * u_n + tau * tau * inv_ks);
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
    // All of u_n springs back, or sigma / k_n where a crack stays propped open.
    std::size_t pair = 0;
    const auto contacts = [&](const std::vector<ContactRun>& runs, const auto& laws,
                              bool propped) {
        for (const ContactRun& run : runs) {
            const double kn = at(laws[run.law].kn), inv_ks = at(laws[run.law].inv_ks);
            const double share = s.finite.pairs.empty() ? 1.0 : at(s.finite.pairs[pair].share);
            ++pair;
            for (int k = run.first; k < run.first + run.count; ++k) {
                const double sigma = at(s.stress[2 * k]), tau = at(s.stress[2 * k + 1]);
                const double springs_back = propped ? sigma / kn : at(s.u_n[k]);
                e.elastic +=
                    0.5 * (share * t.area[k]) * (sigma * springs_back + tau * tau * inv_ks);
            }
        }
    };
    contacts(t.dry, s.laws.dry, false);
    contacts(t.tied, s.laws.tied, false);
    contacts(t.cracks, s.laws.cracks, s.laws.unloading == Unloading::elastic);
    for (const FiniteTables::Reach& r : t.finite.reaches)
        if (!s.finite.frames.empty()) e.elastic += stored_further(t, r, s, lane);
    e.work = at(s.work);
    e.friction = at(s.friction);
    e.fracture = at(s.fracture);
    e.crushing = at(s.crushing);
    e.damping = at(s.damping);
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
