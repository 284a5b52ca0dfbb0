#include "dem/solver/state/lane_laws.hpp"

#include "dem/block/model.hpp"

#include <algorithm>
#include <cmath>

namespace dem {

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

namespace {

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

template <class Real> void set_law(int i, const CrackMaterial& c, MixedLaw<Real>& law)
{
    const MixedLaw<double> one = mixed_law(c);
    set_lane(law.inv_energy, i, one.inv_energy);
    set_lane(law.brittle, i, one.brittle);
    set_lane(law.brittle_open, i, one.brittle_open);
    set_lane(law.inv_u_ul, i, one.inv_u_ul);
    set_lane(law.kappa, i, one.kappa);
    set_lane(law.hyperbolic, i, one.hyperbolic);
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

/// By crack ID, then joints with mortar.
template <class Real>
void set_cracks(const Model& m, const WallMaterials& w, int lane, LaneLaws<Real>& laws)
{
    const auto set = [&](int i, const CrackMaterial& c) {
        set_law(lane, c, laws.cracks[i]);
        if (!laws.mixed.empty()) set_law(lane, c, laws.mixed[i]);
    };
    for (int i = 0; i < m.layout.n_cracks; ++i) set(i, w.cracks[i]);
    if (m.layout.mortar)
        for (int j = 0; j < m.layout.n_joints; ++j)
            set(m.layout.n_cracks + j, bond_of(w.joints[j]));
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

/// By joint ID, then base and beam.
template <class Real>
void set_closing(const Model& m, const WallMaterials& w, int lane, LaneLaws<Real>& laws)
{
    const auto set = [&](const JointMaterial& j, std::size_t at) {
        const Closing& c = j.closing;
        const ClosureLaw<double> one = closure_law(m.layout.closure, c.initial_stiffness,
                                                   c.maximum, c.stiffest, c.loss, j.ks / j.kn);
        ClosureLaw<Real>& law = laws.closing[at];
        for_each_number(one, law, [lane](double x, Real& to) { set_lane(to, lane, x); });
        laws.loses = laws.loses || c.loss > 0.0;
    };
    for (int j = 0; j < m.layout.n_joints; ++j) set(w.joints[j], j);
    set(w.base_joint, m.layout.n_joints);
    set(w.beam_joint, m.layout.n_joints + 1);
    laws.inv_reference_kn = Real(1.0 / m.reference.joint.kn);
    laws.inv_reference_ks = Real(1.0 / m.reference.joint.ks);
}

/// Loads, elasticity and fictitious masses of one lane.
template <class Real>
void set_modes(const Model& m, const StepTables& t, const WallMaterials& w,
               const SolverOptions& options, int lane, LaneLaws<Real>& laws)
{
    const std::vector<double> ratio = stiffness_ratio(m, w);
    for (std::size_t b = 0; b < laws.ratio.size(); ++b) set_lane(laws.ratio[b], lane, ratio[b]);
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
            set_lane(laws.elasticity[mode], lane, lambda);
            set_lane(laws.load[mode], lane, load);
            set_lane(laws.inv_mass[mode], lane, 4.0 * f2 / (lambda + 2.0 * ratio[b]));
            if (!t.body_forces) continue;
            const double pull = material.density * m.loads.gravity; // [N/m3]
            set_lane(laws.weight[mode], lane, pull * e.weight(i));
            set_lane(laws.sway[mode], lane, pull * e.sway(i));
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

MixedLaw<double> mixed_law(const CrackMaterial& c)
{
    // A little less than the energy that a crack stores when it breaks, so that rounding does
    // not let it soften.
    constexpr double kBitLess = 1.0 - 1e-9;
    const double drop = c.cohesion - c.cohesion_res;
    const double energy =
        std::max(c.shear_fracture_energy, kBitLess * drop * drop / (2.0 * c.ks));
    const double u_ul =
        c.ft > 0.0 ? std::max(2.0 * c.fracture_energy / c.ft, c.ft / c.kn) : 0.0;
    MixedLaw<double> law;
    const bool as_printed = c.envelope == Envelope::coulomb && c.shear_fracture_energy == 0.0;
    law.inv_energy = drop > 0.0 ? 0.5 / energy : 0.0;
    law.brittle = drop > 0.0 ? 0.0 : kBreaksInShear;
    law.brittle_open = as_printed ? kBreaksInShear : 0.0;
    law.inv_u_ul = u_ul > 0.0 ? 1.0 / u_ul : 0.0;
    law.kappa = c.cohesion > 0.0 ? std::min(1.0, c.ft * c.tan_phi / c.cohesion) : 1.0;
    law.hyperbolic = c.envelope == Envelope::hyperbolic ? 1.0 : 0.0;
    return law;
}

template <class Real> LaneLaws<Real> empty_laws(const Model& m, const StepTables& t)
{
    LaneLaws<Real> laws;
    for (auto* by_mode : {&laws.inv_mass, &laws.load, &laws.elasticity})
        by_mode->assign(m.n_modes, Real(0.0));
    if (t.body_forces)
        for (auto* by_mode : {&laws.weight, &laws.sway}) by_mode->assign(m.n_modes, Real(0.0));
    laws.dry.resize(m.layout.n_joints + 2);
    laws.tied.resize(1);
    laws.cracks.resize(m.layout.n_cracks + (m.layout.mortar ? m.layout.n_joints : 0));
    if (m.layout.mixed_mode) laws.mixed.resize(laws.cracks.size());
    if (m.layout.crushing) {
        laws.dry_crushing.resize(laws.dry.size());
        laws.crack_crushing.resize(laws.cracks.size());
    }
    if (m.layout.wear) laws.dry_wear.resize(laws.dry.size());
    laws.closure = m.layout.closure;
    if (laws.closure != Closure::linear) {
        laws.closing.resize(laws.dry.size());
        laws.ratio.resize(m.layout.blocks.size());
    }
    return laws;
}

template <class Real>
void set_laws(const Model& m, const StepTables& t, const WallMaterials& w,
              const SolverOptions& options, int lane, LaneLaws<Real>& laws)
{
    laws.unloading = options.unloading;
    for (int j = 0; j < m.layout.n_joints; ++j) set_law(lane, w.joints[j], laws.dry[j]);
    set_law(lane, w.base_joint, laws.dry[m.layout.n_joints]);
    set_law(lane, w.beam_joint, laws.dry[m.layout.n_joints + 1]);
    set_law(lane, w.beam_joint, laws.tied[0]);
    set_cracks(m, w, lane, laws);
    if (m.layout.crushing) set_crushing(m, w, lane, laws);
    if (m.layout.wear) set_wear(m, w, lane, laws.dry_wear);
    if (laws.closure != Closure::linear) set_closing(m, w, lane, laws);
    set_modes(m, t, w, options, lane, laws);
    if (t.body_forces) set_weights(m, w, lane, laws);
}

template LaneLaws<double> empty_laws(const Model&, const StepTables&);
template LaneLaws<Pack> empty_laws(const Model&, const StepTables&);
template void set_laws(const Model&, const StepTables&, const WallMaterials&,
                       const SolverOptions&, int, LaneLaws<double>&);
template void set_laws(const Model&, const StepTables&, const WallMaterials&,
                       const SolverOptions&, int, LaneLaws<Pack>&);

} // namespace dem
