#include "bench/stability/stress_scene.hpp"

#include "bench/draw.hpp"
#include "dem/block/model.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <utility>

namespace bench {

namespace {

/// Most walls are small; a few are tall.
int draw_courses(Draw& d)
{
    if (d.chance(0.70)) return d.integer(1, 6);
    if (d.chance(0.80)) return d.integer(7, 20);
    return d.integer(21, 60);
}

dem::WallGeometry draw_geometry(Draw& d)
{
    dem::WallGeometry w;
    w.courses = draw_courses(d);
    w.unit_length = d.uniform(0.1, 0.5);
    const double most = w.courses > 20 ? 2.0 : w.courses > 6 ? 4.0 : 6.0;
    w.length = w.unit_length *
               (d.chance(0.5) ? d.integer(1, static_cast<int>(most)) : d.uniform(0.7, most));
    w.course_height = d.uniform(0.05, 0.3);
    w.thickness = d.uniform(0.1, 0.5);
    w.bond_offset = d.chance(0.5) ? 0.5 : d.chance(0.3) ? 0.0 : d.uniform(0.1, 0.9);
    w.first_course = d.one_of({dem::FirstCourse::whole, dem::FirstCourse::shifted});
    if (!d.chance(0.75)) w.cracks.pattern.kind = dem::CrackPattern::Kind::none;
    w.base = d.one_of({dem::Base::fixed, dem::Base::joint});
    w.toe = d.one_of({dem::Toe::held, dem::Toe::free});
    return w;
}

/// Units of some walls of few courses crack in another way than the paper's.
void draw_patterns(Draw& d, dem::WallGeometry& w)
{
    using Kind = dem::CrackPattern::Kind;
    if (w.cracks.pattern.kind == Kind::none || w.courses > 6 || !d.chance(0.5)) return;
    w.cracks.pattern = {d.one_of({Kind::grid, Kind::grid, Kind::diagonals, Kind::voronoi}),
                        d.integer(1, 4), d.integer(1, 4), w.unit_length * d.uniform(0.3, 0.8)};
    w.cracks.seed = static_cast<unsigned>(d.integer(0, 1000));
    w.cracks.rigidity = d.log_uniform(6.0, 200.0); // Poisson's ratio is up to 0.4
    w.cracks.elsewhere = {Kind::mid};
    if (d.chance(0.5))
        w.cracks.where = {dem::Region{0.5 * w.length, 0.0, w.length, 3.0 * w.course_height}};
}

/// Strengths from far below the stress to far above, brittle and ductile.
dem::Crushing draw_crushing(Draw& d)
{
    return {d.log_uniform(1e4, 1e8), d.chance(0.3) ? 0.0 : d.log_uniform(1.0, 1e6)};
}

double tan_of_draw(Draw& d) { return scenes::tan_deg(d.uniform(1.0, 80.0)); }

void draw_materials(Draw& d, scenes::Scene& s)
{
    s.stone = {d.log_uniform(1e9, 1e11), d.uniform(0.0, 0.4), d.uniform(1500.0, 3000.0)};
    s.joint.kn = d.log_uniform(1e8, 1e12);
    s.joint.ks = s.joint.kn * d.log_uniform(0.05, 1.0);
    s.joint.tan_phi = tan_of_draw(d);
    s.crack.kn = s.joint.kn * d.log_uniform(1.0, 1000.0);
    s.crack.ks = s.crack.kn * d.log_uniform(0.05, 1.0);
    s.crack.ft = d.log_uniform(1e4, 50e6);
    s.crack.cohesion = s.crack.ft * d.log_uniform(0.3, 3.0);
    s.crack.cohesion_res = d.chance(0.5) ? 0.0 : s.crack.cohesion * d.uniform(0.0, 1.0);
    s.crack.tan_phi = tan_of_draw(d);
    s.crack.tan_phi_res = d.chance(0.5) ? s.crack.tan_phi : tan_of_draw(d);
    s.crack.fracture_energy = d.log_uniform(0.1, 1e4);
    s.crack.tension_reduces_shear = d.chance(0.7);
}

void draw_load(Draw& d, scenes::Scene& s)
{
    s.beam.height = d.uniform(0.05, 0.3);
    s.beam.material = {d.log_uniform(1e9, 2e11), d.uniform(0.0, 0.4), d.uniform(0.0, 8000.0)};
    s.beam.interface = d.one_of({dem::BeamInterface::tied, dem::BeamInterface::joint});
    s.beam.rotation = d.one_of({dem::BeamRotation::free, dem::BeamRotation::fixed});
    s.loads.vertical_stress = d.chance(0.05) ? 0.0 : d.uniform(0.0, 5e6);
    s.loads.height =
        s.wall.courses * s.wall.course_height + s.beam.height * d.uniform(0.0, 1.0);
}

dem::Discretisation draw_discretisation(Draw& d)
{
    dem::Discretisation x = dem::discretisation_of(
        d.one_of({dem::Fidelity::rigid, dem::Fidelity::simple, dem::Fidelity::standard}));
    x.contact_points = d.integer(2, 6);
    x.face_rule = d.one_of({dem::FaceRule::even, dem::FaceRule::lobatto});
    x.zones_per_interval = d.integer(1, 2);
    return x;
}

dem::SolverOptions draw_solver(Draw& d)
{
    dem::SolverOptions o;
    o.law = d.one_of({dem::ContactLaw::coupled, dem::ContactLaw::uncoupled});
    o.damping = d.one_of({dem::Damping::local, dem::Damping::combined});
    o.damping_factor = d.chance(0.1) ? 0.0 : d.uniform(0.0, 0.95);
    o.step_fraction = d.chance(0.5) ? d.uniform(0.2, 1.0) : d.uniform(1.0, 2.0);
    o.steps_per_mm = d.chance(0.2) ? d.log_uniform(5.0, 100.0) : d.log_uniform(100.0, 3000.0);
    o.accuracy = std::clamp(10.0 / o.steps_per_mm, 0.005, 0.5); // fast drives bear much
    o.unbalance_limit = d.chance(0.2) ? 0.0 : d.log_uniform(0.05, 1.0);
    o.min_speed = d.log_uniform(0.05, 1.0);
    o.preload = d.one_of({dem::Preload::solved, dem::Preload::ramped});
    o.preload_steps = d.integer(500, 3000);
    return o;
}

/// A way of at most some mm and about `steps` steps at full speed; few go on until the blocks
/// part.
dem::PushPlan draw_plan(Draw& d, const dem::WallGeometry& wall, double steps,
                        dem::SolverOptions& o)
{
    double way = std::min(d.log_uniform(3e-4, 6e-3), 1e-3 * steps / o.steps_per_mm);
    if (d.chance(0.03)) { // much too fast
        way = 3.0 * wall.courses * wall.course_height;
        o.steps_per_mm = 1e-3 * steps / way;
        o.unbalance_limit = 0.0;
    }
    dem::PushPlan plan;
    plan.targets = {way};
    if (d.chance(0.35)) plan.targets = {way / 4.0, -way / 4.0, way / 8.0, 0.0};
    plan.record_every = way / d.integer(10, 60);
    plan.snapshot_every = d.chance(0.1) ? way / 3.0 : 0.0;
    return plan;
}

std::string describe(const StressScene& s)
{
    const dem::WallGeometry& w = s.scene.wall;
    const dem::SolverOptions& o = s.solver;
    std::ostringstream text;
    text.precision(3);
    text << w.courses << " courses, " << w.length << " m, base "
         << (w.base == dem::Base::fixed ? "fixed" : "joint") << ", "
         << s.scene.loads.vertical_stress * 1e-6 << " MPa, kn " << s.scene.joint.kn * 1e-9
         << " GPa/m, ratio " << s.scene.crack.kn / s.scene.joint.kn << ", tan phi "
         << s.scene.joint.tan_phi << ", f_T " << s.scene.crack.ft * 1e-6 << " MPa, G "
         << s.scene.crack.fracture_energy << " N/m, modes " << s.discretisation.block_modes
         << ", " << (o.damping == dem::Damping::local ? "local " : "combined ")
         << o.damping_factor << ", step " << o.step_fraction << ", " << o.steps_per_mm
         << " steps/mm, " << (o.preload == dem::Preload::solved ? "solved" : "ramped")
         << (s.plan.targets.size() > 1 ? ", cyclic" : "") << ", way "
         << s.plan.targets.front() * 1e3 << " mm, decades " << s.decades
         << (s.by_joint ? " by joint" : "") << ", pattern "
         << static_cast<int>(w.cracks.pattern.kind) << ' ' << w.cracks.pattern.columns << " x "
         << w.cracks.pattern.rows << ", f_c " << s.scene.joint.crushing.strength * 1e-6
         << " and " << s.scene.crack.crushing.strength * 1e-6 << " MPa, wear "
         << s.scene.joint.wear.length * 1e3 << " mm";
    return text.str();
}

/// Initial stiffness and maximum closure over decades, straight on at once or as late as can
/// be.
void draw_closure(Draw& d, StressScene& s)
{
    dem::JointMaterial& j = s.scene.joint;
    s.scene.closure = d.one_of({dem::Closure::hyperbolic, dem::Closure::exponential});
    j.closing.initial_stiffness = j.kn * d.log_uniform(0.001, 1.0);
    j.closing.maximum = d.chance(0.7) ? d.log_uniform(1e-6, 1e-3) : d.log_uniform(1e-3, 10.0);
    j.closing.loss = d.chance(0.4) ? 0.0 : d.uniform(0.0, 0.9);
    j.closing.stiffest =
        j.closing.initial_stiffness * (d.chance(0.1) ? 1.0 : d.log_uniform(1.0, 1000.0));
    if (s.solver.step_fraction > 1.0) s.solver.step_fraction = d.chance(0.5) ? 1.0 : 0.95;
}

void draw_mixed_modes(Draw& d, StressScene& s)
{
    const auto envelope = [&] {
        return d.one_of({dem::Envelope::coulomb, dem::Envelope::hyperbolic});
    };
    const auto energy = [&] { return d.chance(0.25) ? 0.0 : d.log_uniform(0.1, 1e6); };
    s.mixed_mode = true;
    s.solver.law = dem::ContactLaw::coupled;
    s.scene.crack.envelope = envelope();
    s.scene.crack.shear_fracture_energy = energy();
    s.mortar = s.scene.closure == dem::Closure::linear && d.chance(0.5);
    if (!s.mortar) return;
    dem::JointMaterial& j = s.scene.joint;
    j.wear = {};
    j.ft = d.log_uniform(1e3, 1e6);
    j.cohesion = j.ft * d.log_uniform(0.3, 3.0);
    j.fracture_energy = d.log_uniform(0.1, 1e3);
    j.envelope = envelope();
    j.shear_fracture_energy = energy();
}

/// Laws beyond those of the paper, and loads that are rare among the other scenes.
void draw_laws(Draw& d, StressScene& s)
{
    if (d.chance(0.8)) draw_closure(d, s);
    if (s.scene.closure == dem::Closure::linear || d.chance(0.4)) draw_mixed_modes(d, s);
    s.solver.kinematics = d.one_of({dem::Kinematics::small, dem::Kinematics::finite});
    if (d.chance(0.1)) s.scene.loads.vertical_stress = 0.0;
    double& strength = s.scene.joint.crushing.strength;
    if (strength > 0.0 && d.chance(0.7)) // else most of these walls come down under their load
        strength = std::max(strength, s.scene.loads.vertical_stress * d.log_uniform(2.0, 20.0));
    if (d.chance(0.15)) {
        s.scene.loads.pattern = dem::LoadPattern::body;
        s.scene.beam.rotation = dem::BeamRotation::free; // body forces know no other
    } else if (d.chance(0.1))
        s.scene.stone.density = s.scene.beam.material.density = 0.0;
}

std::string describe_laws(const StressScene& s)
{
    const dem::JointMaterial& j = s.scene.joint;
    std::ostringstream text;
    text.precision(3);
    if (s.scene.closure != dem::Closure::linear)
        text << (s.scene.closure == dem::Closure::hyperbolic ? ", hyperbolic" : ", exponential")
             << " closure, k_0 " << j.closing.initial_stiffness * 1e-9 << " GPa/m, V_m "
             << j.closing.maximum * 1e3 << " mm, loss " << j.closing.loss << ", stiffest "
             << j.closing.stiffest / j.closing.initial_stiffness << " k_0";
    const auto mixed = [&](const char* name, dem::Envelope envelope, double energy) {
        text << name << (envelope == dem::Envelope::coulomb ? "coulomb" : "hyperbolic")
             << ", G_II " << energy << " N/m";
    };
    if (s.mixed_mode)
        mixed(", units ", s.scene.crack.envelope, s.scene.crack.shear_fracture_energy);
    if (s.mortar) mixed(", bonds ", j.envelope, j.shear_fracture_energy);
    if (s.solver.kinematics == dem::Kinematics::finite) text << ", finite";
    if (s.scene.loads.pattern == dem::LoadPattern::body) text << ", body forces";
    if (s.scene.stone.density == 0.0) text << ", weightless";
    return text.str();
}

/// Absurd values that check() lets pass.
void spoil(Draw& d, dem::WallMaterials& w)
{
    const auto set = [&w](auto change) {
        for (auto& j : w.joints) change(j);
        for (auto& c : w.cracks) change(c);
    };
    const double absurd = d.one_of({1e300, 1e200, 1e60, 1e-300, 1e-310});
    switch (d.integer(0, 7)) {
    case 0:
        set([&](auto& m) { m.kn = absurd; });
        break;
    case 1:
        set([&](auto& m) { m.ks = absurd; });
        break;
    case 2:
        set([&](auto& m) { m.kn = m.ks = std::numeric_limits<double>::infinity(); });
        break;
    case 3:
        w.stone.young_modulus = absurd;
        break;
    case 4:
        w.vertical_stress = 1e300;
        break;
    case 5:
        set([&](auto& m) { m.tan_phi = absurd; });
        for (dem::JointMaterial& j : w.joints)
            j.wear.tan_phi_res = std::min(j.wear.tan_phi_res, absurd);
        break;
    case 6:
        w.base_joint.kn = w.beam_joint.ks = absurd;
        break;
    default:
        (w.cracks.empty() ? w.beam_joint.kn : w.cracks.front().ft) = absurd;
    }
}

void spoil_closing(Draw& d, dem::WallMaterials& w)
{
    const double absurd = d.one_of({1e300, 1e200, 1e60, 1e-300, 1e-310});
    const int what = d.integer(0, 3);
    for (dem::JointMaterial& j : w.joints) {
        if (what == 0) j.closing.initial_stiffness = j.closing.stiffest = absurd;
        if (what == 1) j.closing.maximum = absurd;
        if (what == 2) j.closing.loss = 1.0 - 1e-16;
        if (what == 3) j.ks = absurd;
    }
}

} // namespace

dem::Model model_of(const StressScene& s)
{
    if (!s.mortar) {
        dem::Model m = scenes::model_of(s.scene, s.discretisation);
        m.layout.mixed_mode = s.mixed_mode;
        return m;
    }
    const scenes::Scene& c = s.scene;
    dem::Layout layout = dem::lay_out(c.wall, c.beam.height);
    layout.mortar = true;
    layout.mixed_mode = s.mixed_mode;
    layout.crushing = c.joint.crushing.strength > 0.0 || c.crack.crushing.strength > 0.0;
    return dem::discretise(std::move(layout), c.stone, c.beam, c.loads, {c.joint, c.crack},
                           s.discretisation);
}

StressScene stress_scene(std::uint64_t seed, std::uint64_t number, DrawnLaws laws)
{
    Draw d(seed, number);
    StressScene s;
    s.scene.wall = draw_geometry(d);
    const bool all = laws == DrawnLaws::all;
    if (all) s.scene.wall.courses = std::min(s.scene.wall.courses, 12); // for less time
    draw_materials(d, s.scene);
    draw_load(d, s.scene);
    s.discretisation = draw_discretisation(d);
    s.solver = draw_solver(d);
    const double steps =
        (all ? 0.5 : 1.0) * std::clamp(40'000.0 / s.scene.wall.courses, 2'000.0, 10'000.0);
    s.plan = draw_plan(d, s.scene.wall, steps, s.solver);
    s.solver.most_steps = static_cast<long long>((all ? 15.0 : 30.0) * steps);
    s.material_seed = static_cast<std::uint64_t>(d.uniform(0.0, 0x1p52));
    s.walls = d.integer(4, 12);
    s.decades = d.chance(0.2) ? 0.0 : d.uniform(0.1, 2.0);
    s.by_joint = d.chance(0.4);
    if (d.chance(0.1)) s.spoil = d.integer(0, s.walls - 1);
    draw_patterns(d, s.scene.wall);
    if (d.chance(0.4)) s.scene.joint.crushing = draw_crushing(d);
    if (d.chance(0.2)) s.scene.crack.crushing = draw_crushing(d);
    if (d.chance(0.3))
        s.scene.joint.wear = {s.scene.joint.tan_phi * d.uniform(0.0, 1.0),
                              d.log_uniform(1e-5, 1e-1)};
    s.laws = laws;
    if (all) draw_laws(d, s);
    s.text = describe(s) + describe_laws(s);
    return s;
}

dem::WallMaterials stress_wall(const StressScene& s, const dem::Model& model, int wall)
{
    Draw d(s.material_seed, static_cast<std::uint64_t>(wall));
    dem::WallMaterials w = scenes::uniform(s.scene, model);
    const auto factor = [&] { return std::pow(10.0, s.decades * d.uniform(-0.5, 0.5)); };
    const auto scatter = [&](auto& materials, auto change) {
        if (materials.empty()) return;
        change(materials.front());
        for (auto& m : materials) s.by_joint ? change(m) : void(m = materials.front());
    };
    scatter(w.joints, [&](dem::JointMaterial& j) {
        const double stiffer = factor();
        j = s.scene.joint;
        j.kn *= stiffer;
        j.ks *= stiffer;
        const double rougher = factor();
        j.tan_phi *= rougher;
        j.wear.tan_phi_res *= rougher;
        j.crushing.strength *= factor();
    });
    scatter(w.cracks, [&](dem::CrackMaterial& c) {
        const double stiffer = factor(), stronger = factor();
        c = s.scene.crack;
        c.kn *= stiffer;
        c.ks *= stiffer;
        c.ft *= stronger;
        c.cohesion *= stronger;
        c.cohesion_res *= stronger;
        c.fracture_energy *= factor();
        c.crushing.strength *= factor();
    });
    w.stone.young_modulus *= std::pow(factor(), 0.2);
    w.vertical_stress = s.scene.loads.vertical_stress * d.uniform(0.5, 1.5);
    if (s.spoil == wall) spoil(d, w);
    if (s.scene.closure == dem::Closure::linear) return w;
    const auto scatter_closing = [&](dem::Closing& c) {
        const double stiffer = factor();
        c.initial_stiffness *= stiffer;
        c.stiffest *= stiffer;
        c.maximum *= factor();
        if (d.chance(0.3)) c.loss = 0.0;
    };
    const dem::Closing one = [&] {
        dem::Closing c = s.scene.joint.closing;
        scatter_closing(c);
        return c;
    }();
    for (dem::JointMaterial& j : w.joints)
        s.by_joint ? scatter_closing(j.closing) : void(j.closing = one);
    if (s.spoil == wall && d.chance(0.6)) spoil_closing(d, w);
    return w;
}

} // namespace bench
