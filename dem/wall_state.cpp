#include "dem/wall_state.hpp"

#include <algorithm>
#include <cmath>

namespace dem {

namespace {

SharedMatrix shared(const Eigen::MatrixXd& inputs_by_outputs)
{
    SharedMatrix a;
    a.inputs = static_cast<int>(inputs_by_outputs.rows());
    a.outputs = static_cast<int>(inputs_by_outputs.cols());
    for (int i = 0; i < a.inputs; ++i)
        for (int j = 0; j < a.outputs; ++j) a.values.push_back(inputs_by_outputs(i, j));
    return a;
}

/// Position of a dry contact's law: joints by ID, then the base, then the beam.
int dry_law(const Model& m, const Contact& c)
{
    if (c.material == kBaseMaterial) return m.layout.n_joints;
    if (c.material == kBeamMaterial) return m.layout.n_joints + 1;
    return c.material;
}

ContactIndex index_of(const Contact& c, int law)
{
    return {2 * c.a, 2 * c.b, law, c.nx, c.nz, c.area};
}

/// Blocks whose horizontal forces go straight into the ground.
bool is_supported(const Model& m, int block)
{
    const Block& b = m.layout.blocks[block];
    const bool at_toe = m.wall.toe == Toe::held && b.x1 == m.wall.length;
    return b.course == 1 && (m.wall.base == Base::fixed || at_toe);
}

void tabulate_block(const Model& m, int block, StepTables& t)
{
    const BlockPlace& place = m.places[block];
    const BlockElement& e = m.elements[place.element];
    const int rows = static_cast<int>(e.phi.rows()), modes = static_cast<int>(e.phi.cols());
    const int first_row = 2 * place.first_point;
    t.blocks.push_back({place.element, first_row, rows, place.first_mode, modes});
    for (int i = 0; i < modes; ++i) t.lambda.push_back(e.lambda(i));
    if (is_supported(m, block))
        for (int row = first_row; row < first_row + rows; row += 2)
            t.support_rows.push_back(row);
}

/// Vertical load and weight, with the reference density [N].
double vertical_load(const Model& m)
{
    double force = m.loads.vertical_stress * m.wall.length * m.wall.thickness;
    for (const Block& b : m.layout.blocks) {
        const Elastic& material = b.course == 0 ? m.beam.material : m.stone;
        const double volume = (b.x1 - b.x0) * (b.z1 - b.z0) * m.wall.thickness;
        force += volume * material.density * m.loads.gravity;
    }
    return force;
}

/// Largest stiffness of a wall's contacts over their reference, per block.
std::vector<double> stiffness_ratio(const Model& m, const WallMaterials& w)
{
    std::vector<double> ratio(m.layout.blocks.size(), 0.0);
    for (const Face& f : m.layout.faces) {
        double r = 0.0;
        if (f.kind == FaceKind::unit_crack) {
            const CrackMaterial& c = w.cracks[f.id - 1];
            r = std::max(c.kn / m.reference.crack.kn, c.ks / m.reference.crack.ks);
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

/// Loads, elasticity and fictitious masses of one lane.
template <class Real>
void set_modes(const Model& m, const StepTables& t, const WallMaterials& w,
               const SolverOptions& options, int lane, WallState<Real>& s)
{
    const std::vector<double> ratio = stiffness_ratio(m, w);
    for (std::size_t b = 0; b < t.blocks.size(); ++b) {
        const bool is_beam = static_cast<int>(b) == m.layout.beam;
        const BlockElement& e = m.elements[t.blocks[b].element];
        const Elastic& material = is_beam ? m.beam.material : w.stone;
        const double softer = is_beam ? 1.0 : w.stone.young_modulus / m.stone.young_modulus;
        for (int i = 0; i < t.blocks[b].modes; ++i) {
            const int mode = t.blocks[b].first_mode + i;
            const double lambda = t.lambda[mode] * softer;
            const double load = material.density * m.loads.gravity * e.weight(i) +
                                (is_beam ? m.loads.vertical_stress * e.top_load(i) : 0.0);
            // Damping adds up to gamma |F| to a force that opposes the motion, hence 1 + gamma.
            const double f2 =
                options.step_fraction * options.step_fraction / (1.0 + options.damping_factor);
            set_lane(s.elasticity[mode], lane, lambda);
            set_lane(s.load[mode], lane, load);
            set_lane(s.inv_mass[mode], lane, 4.0 * f2 / (lambda + 2.0 * ratio[b]));
        }
    }
}

} // namespace

StepTables step_tables(const Model& m)
{
    StepTables t;
    for (const BlockElement& e : m.elements) {
        t.to_modes.push_back(shared(e.phi));
        t.to_points.push_back(shared(e.phi.transpose()));
    }
    for (int b = 0; b < static_cast<int>(m.layout.blocks.size()); ++b) tabulate_block(m, b, t);
    for (const Contact& c : m.dry) t.dry.push_back(index_of(c, dry_law(m, c)));
    for (const Contact& c : m.cracks) t.cracks.push_back(index_of(c, c.material));
    for (const Contact& c : m.tied) t.tied.push_back(index_of(c, 0));
    const auto& beam = t.blocks[m.layout.beam];
    t.beam_first_row = beam.first_row;
    t.beam_rows = beam.rows;
    t.ground_row = 2 * m.ground_point;
    t.vertical_load = vertical_load(m);
    return t;
}

template <class Real>
void load_lane(const Model& m, const StepTables& t, const WallMaterials& w,
               const SolverOptions& options, int lane, WallState<Real>& s)
{
    for (auto* values : {&s.q, &s.v, &s.last_force, &s.du, &s.force})
        for (Real& x : *values) set_lane(x, lane, 0.0);
    for (Real* x : {&s.work, &s.friction, &s.fracture, &s.damping, &s.top_force, &s.base_shear})
        set_lane(*x, lane, 0.0);
    for (int j = 0; j < m.layout.n_joints; ++j) set_law(lane, w.joints[j], s.dry_laws[j]);
    set_law(lane, w.base_joint, s.dry_laws[m.layout.n_joints]);
    set_law(lane, w.beam_joint, s.dry_laws[m.layout.n_joints + 1]);
    set_law(lane, w.beam_joint, s.tied_laws[0]);
    for (int i = 0; i < m.layout.n_cracks; ++i) set_law(lane, w.cracks[i], s.crack_laws[i]);
    for (auto* states : {&s.dry, &s.tied})
        for (DryState<Real>& c : *states) {
            set_lane(c.u_n, lane, 0.0);
            set_lane(c.tau, lane, 0.0);
        }
    for (std::size_t k = 0; k < s.cracks.size(); ++k) {
        CrackState<Real>& c = s.cracks[k];
        for (Real* x : {&c.u_n, &c.tau, &c.sigma}) set_lane(*x, lane, 0.0);
        set_lane(c.u_max, lane, dem::lane(s.crack_laws[t.cracks[k].law].u_el, lane));
        set_lane(c.bond, lane, 1.0);
    }
    set_modes(m, t, w, options, lane, s);
}

template <class Real>
WallState<Real> unloaded(const Model& m, const StepTables& t,
                         std::span<const WallMaterials> walls, const SolverOptions& options)
{
    WallState<Real> s;
    for (auto* by_mode : {&s.q, &s.v, &s.last_force, &s.inv_mass, &s.load, &s.elasticity})
        by_mode->assign(m.n_modes, Real(0.0));
    const std::size_t rows = 2 * static_cast<std::size_t>(m.n_points) + 2; // and the ground
    s.du.assign(rows, Real(0.0));
    s.force.assign(rows, Real(0.0));
    s.dry_laws.resize(m.layout.n_joints + 2);
    s.tied_laws.resize(1);
    s.crack_laws.resize(m.layout.n_cracks);
    s.dry.resize(m.dry.size());
    s.tied.resize(m.tied.size());
    s.cracks.resize(m.cracks.size());
    for (int i = 0; i < lanes<Real>; ++i)
        load_lane(m, t, walls[std::min<std::size_t>(i, walls.size() - 1)], options, i, s);
    return s;
}

template <class Real> Energy energy_of(const StepTables& t, const WallState<Real>& s, int lane)
{
    Energy e;
    const auto at = [lane](const Real& x) { return dem::lane(x, lane); };
    for (std::size_t i = 0; i < s.q.size(); ++i) {
        e.kinetic += 0.5 * at(s.v[i]) * at(s.v[i]) / at(s.inv_mass[i]);
        e.elastic += 0.5 * at(s.elasticity[i]) * at(s.q[i]) * at(s.q[i]);
    }
    const auto contact = [&e](double area, double sigma, double u_n, double tau,
                              double inv_ks) {
        e.elastic += 0.5 * area * (sigma * u_n + tau * tau * inv_ks);
    };
    for (std::size_t k = 0; k < s.dry.size(); ++k) {
        const DryLaw<Real>& law = s.dry_laws[t.dry[k].law];
        contact(t.dry[k].area, at(dry_stress(law, s.dry[k].u_n)), at(s.dry[k].u_n),
                at(s.dry[k].tau), at(law.inv_ks));
    }
    for (std::size_t k = 0; k < s.tied.size(); ++k)
        contact(t.tied[k].area, at(s.tied_laws[0].kn) * at(s.tied[k].u_n), at(s.tied[k].u_n),
                at(s.tied[k].tau), at(s.tied_laws[0].inv_ks));
    for (std::size_t k = 0; k < s.cracks.size(); ++k)
        contact(t.cracks[k].area, at(s.cracks[k].sigma), at(s.cracks[k].u_n),
                at(s.cracks[k].tau), at(s.crack_laws[t.cracks[k].law].inv_ks));
    e.work = at(s.work);
    e.friction = at(s.friction);
    e.fracture = at(s.fracture);
    e.damping = at(s.damping);
    return e;
}

template WallState<double> unloaded(const Model&, const StepTables&,
                                    std::span<const WallMaterials>, const SolverOptions&);
template void load_lane(const Model&, const StepTables&, const WallMaterials&,
                        const SolverOptions&, int, WallState<double>&);
template Energy energy_of(const StepTables&, const WallState<double>&, int);
template WallState<Pack> unloaded(const Model&, const StepTables&,
                                  std::span<const WallMaterials>, const SolverOptions&);
template void load_lane(const Model&, const StepTables&, const WallMaterials&,
                        const SolverOptions&, int, WallState<Pack>&);
template Energy energy_of(const StepTables&, const WallState<Pack>&, int);

} // namespace dem
