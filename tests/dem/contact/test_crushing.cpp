/// Contacts that crush: the law, a row of blocks, a toe, and the same bits in every lane.

#include "dem/block/model.hpp"
#include "dem/contact/crushing.hpp"
#include "dem/scene/drawn_layout.hpp"
#include "dem/scene/mechanism/mechanism.hpp"
#include "dem/solver/ensemble.hpp"
#include "dem/solver/push.hpp"
#include "scenes/paper_wall.hpp"
#include "tests/dem/crack_path.hpp"
#include "tests/dem/small_wall.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace {

using dem::Crushing;
using dem::CrushingLaw;

/// One contact that is closed and opened.
struct Contact {
    CrushingLaw<double> law;
    double u_n = 0.0, crushed = 0.0, pressure = 0.0, lost = 0.0;

    void move(double to, int steps = 1000)
    {
        const double du = (to - u_n) / steps;
        for (int i = 0; i < steps; ++i) {
            u_n += du;
            const double by = dem::crushed_by(law, crushed, u_n + crushed);
            crushed += by;
            const double after = std::max(0.0, -law.kn * (u_n + crushed));
            lost += 0.5 * (pressure + after) * by;
            pressure = after;
        }
    }
};

} // namespace

TEST_CASE("crushing: a contact carries f_c, softens to nothing and costs G_c",
          "[dem][crushing]")
{
    const double fc = 10e6, g = 20e3, kn = 10e9; // u_cu = 4 mm; f_c^2 / 2 k_n = 5 kJ/m2 < G_c
    Contact c{dem::crushing_law(kn, fc, g)};
    c.move(-0.9e-3);
    CHECK(c.pressure == Approx(9e6));
    CHECK(c.crushed == 0.0);
    // Half of the strength is left once half of u_cu is crushed: u = -2 mm - 0.5 mm.
    c.move(-2.5e-3);
    CHECK(c.pressure == Approx(5e6).epsilon(1e-9));
    CHECK(c.crushed == Approx(2e-3).epsilon(1e-9));
    CHECK(dem::strength_lost(c.law, c.crushed) == Approx(0.5).epsilon(1e-9));
    CHECK(c.lost == Approx(0.75 * g).epsilon(1e-3));
    // Unloads with k_n, leaves a gap of 2 mm, and comes back on the same way.
    const double lost = c.lost;
    c.move(-2.0e-3);
    CHECK(c.pressure == Approx(0.0).margin(1.0));
    c.move(0.0);
    CHECK(c.pressure == 0.0);
    c.move(-2.25e-3);
    CHECK(c.pressure == Approx(2.5e6).epsilon(1e-9));
    CHECK(c.lost == lost);
    c.move(-6e-3);
    CHECK(c.pressure == 0.0);
    CHECK(dem::strength_lost(c.law, c.crushed) == 1.0);
    CHECK(c.lost == Approx(g).epsilon(1e-3));
}

TEST_CASE("crushing: without an energy the strength stays; too little breaks at once",
          "[dem][crushing]")
{
    Contact plastic{dem::crushing_law(10e9, 10e6, 0.0)};
    plastic.move(-5e-3);
    CHECK(plastic.pressure == Approx(10e6));
    CHECK(plastic.lost == Approx(10e6 * 4e-3).epsilon(1e-3));
    Contact brittle{dem::crushing_law(10e9, 10e6, 4e3)}; // below 5 kJ/m2
    brittle.move(-0.999e-3);
    CHECK(brittle.crushed == 0.0);
    brittle.move(-1.01e-3, 10);
    CHECK(brittle.pressure == 0.0);
    CHECK(brittle.lost == Approx(5e3).epsilon(0.01));
    Contact hard{dem::crushing_law(10e9, 0.0, 0.0)};
    hard.move(-1.0);
    CHECK(hard.crushed == 0.0);
    CHECK(hard.pressure == Approx(10e9));
}

namespace {

/// A crack that has begun to crush, opened by three times u_ul, closed and opened again.
template <dem::ContactLaw kLaw, dem::Unloading kUnloading> crack_path::Path reopened()
{
    const auto law = crack_path::crack();
    const double far = 3.0 * crack_path::kUul;
    crack_path::Path p{dem::intact<kUnloading>(law)};
    crack_path::move<kLaw, kUnloading>(law, -1e-5, 0.0, 10, p);
    p.state = dem::without_bond<kLaw, kUnloading>(p.state);
    for (const double by : {far + 1e-5, -far, far})
        crack_path::move<kLaw, kUnloading>(law, by, 0.0, 10000, p);
    return p;
}

} // namespace

TEST_CASE("crushing: a crack that has begun to crush has no bond, and makes no energy",
          "[dem][crushing]")
{
    using dem::ContactLaw;
    using dem::Unloading;
    for (const crack_path::Path& p : {reopened<ContactLaw::coupled, Unloading::secant>(),
                                      reopened<ContactLaw::coupled, Unloading::elastic>()}) {
        CHECK(p.largest_sigma == Approx(0.0).margin(1e-6 * crack_path::kFt));
        CHECK(p.work == Approx(0.0).margin(1e-6 * crack_path::kG));
        CHECK(p.fracture == Approx(0.0).margin(1e-6 * crack_path::kG));
    }
    // Without coupling only the cohesion is lost.
    const crack_path::Path p = reopened<ContactLaw::uncoupled, Unloading::secant>();
    CHECK(p.largest_sigma == Approx(crack_path::kFt).epsilon(1e-3));
    CHECK(p.fracture == Approx(crack_path::kG).epsilon(1e-3));
    CHECK(p.state.bond == 0.0);
}

namespace {

constexpr double kThickness = 0.1, kHigh = 0.4; // of the row [m]

/// Two blocks on a smooth ledge, driven against a post by body forces.
dem::PushResult row(int contact_points, const Crushing& crushing)
{
    dem::DrawnWall wall;
    wall.thickness = kThickness;
    wall.units = {{{{0, 0}, {1.0, 0}, {1.0, 0.5}, {0.6, 0.5}, {0.6, 0.1}, {0, 0.1}}, 0},
                  {{{0.2, 0.1}, {0.4, 0.1}, {0.4, 0.5}, {0.2, 0.5}}, 0},
                  {{{0.4, 0.1}, {0.6, 0.1}, {0.6, 0.5}, {0.4, 0.5}}, 0}};
    dem::Layout layout = dem::drawn_layout(wall, 0.0);
    layout.crushing = true;
    dem::Beam none;
    none.present = false;
    dem::Loads loads;
    loads.pattern = dem::LoadPattern::body;
    const dem::JointMaterial smooth{.kn = 10e9, .ks = 4e9};
    dem::Discretisation d;
    d.contact_points = contact_points;
    d.block_modes = 6;
    const dem::Model m = dem::discretise(layout, {1e12, 0.2, 2300.0}, none, loads,
                                         {smooth, {.kn = 1e11, .ks = 1e11}}, d);
    dem::WallMaterials w;
    w.stone = {1e12, 0.2, 2300.0};
    w.joints.assign(static_cast<std::size_t>(layout.n_joints), smooth);
    w.base_joint = w.beam_joint = smooth;
    for (const dem::Face& f : layout.faces)
        if (f.kind == dem::FaceKind::head_joint) w.joints[f.id - 1].crushing = crushing;
    dem::PushPlan plan;
    plan.targets = {1.1e-3}; // of the mean of all blocks; the two move 2.9 mm
    plan.record_every = 2e-6;
    dem::SolverOptions slow;
    slow.accuracy = 0.001;
    return dem::push(m, w, plan, slow);
}

/// A rigid block of 1 m x 1 m and 5 kN under 100 kN, on a joint of many points that crushes.
dem::PushResult toe(double strength, dem::Kinematics kinematics, double to)
{
    scenes::Scene s = scenes::monolith(1.0, 0.9, 100e3 / 0.2, 100e9);
    s.stone = {1e16, 0.0, 5e3 / (9.81 * 0.2)};
    s.beam.material = s.stone;
    s.joint.tan_phi = 10.0;
    dem::Layout layout = dem::lay_out(s.wall, s.beam.height);
    layout.crushing = true;
    dem::Discretisation rigid;
    rigid.contact_points = 101;
    rigid.block_modes = rigid.beam_modes = 3;
    rigid.zones_per_interval = 1;
    rigid.face_rule = dem::FaceRule::even;
    const dem::Model m =
        dem::discretise(layout, s.stone, s.beam, s.loads, {s.joint, s.crack}, rigid);
    dem::WallMaterials w = scenes::uniform(s, m);
    w.base_joint.crushing.strength = strength;
    dem::PushPlan plan;
    plan.targets = {to};
    dem::SolverOptions o;
    o.kinematics = kinematics;
    o.accuracy = 0.001;
    return dem::push(m, w, plan, o);
}

} // namespace

TEST_CASE("crushing: a row of blocks carries f_c A, and its weakest joint costs G_c A",
          "[dem][crushing]")
{
    const int points = GENERATE(3, 8);
    const double fc = 1e6, g = 1000.0, area = kHigh * kThickness;
    const dem::PushResult r = row(points, {fc, g});
    double factor = 0.0;
    for (const dem::CurvePoint& p : r.curve) factor = std::max(factor, p.force / r.weight);
    const double moved = 2300.0 * 9.81 * 0.4 * kHigh * kThickness; // of the two blocks [N]
    CHECK(factor * moved == Approx(fc * area).epsilon(0.01));
    CHECK(r.energy.crushing == Approx(g * area).epsilon(0.01));
    CHECK(dem::mechanism(r.at_end, 0.5).crushed_area == Approx(area));
    CHECK(r.residual < 0.01);
}

TEST_CASE("crushing: a rigid wall turns about the middle of its crushed toe",
          "[dem][crushing][slow]")
{
    const double strength = 2.625e6, n = 105e3; // a = N / (f_c t) = 0.2 m
    const dem::PushResult r = toe(strength, dem::Kinematics::small, 5e-3);
    const double a = n / (strength * 0.2);
    CHECK(r.curve.back().force == Approx(n * (0.5 - 0.5 * a) / 1.0).epsilon(0.01));
    CHECK(r.energy.crushing > 0.0);
    CHECK(r.residual < 0.01);
    const dem::PushResult finite = toe(strength, dem::Kinematics::finite, 5e-3);
    // The load and the weight have moved with the wall: N u and W u / 2.
    CHECK(finite.curve.back().force ==
          Approx(r.curve.back().force - (100e3 * 5e-3 + 5e3 * 2.5e-3)).epsilon(0.01));
    CHECK(finite.residual < 0.01);
}

TEST_CASE("crushing: the same bits alone and in any lane", "[dem][crushing]")
{
    dem::Layout layout =
        dem::lay_out(small_wall::scene().wall, small_wall::scene().beam.height);
    layout.crushing = true;
    const scenes::Scene s = small_wall::scene();
    dem::Discretisation d;
    d.contact_points = 3;
    d.block_modes = d.beam_modes = 6;
    const dem::Model m =
        dem::discretise(layout, s.stone, s.beam, s.loads, {s.joint, s.crack}, d);
    dem::SolverOptions options = small_wall::quick();
    options.kinematics = GENERATE(dem::Kinematics::small, dem::Kinematics::finite);
    std::vector<dem::WallMaterials> walls;
    for (std::size_t i = 0; i < dem::lanes<dem::Pack> + 1; ++i) {
        walls.push_back(scenes::table5_sample(s, m, i));
        if (i % 3 == 0) continue; // some do not crush
        for (dem::JointMaterial& j : walls.back().joints) j.crushing = {6e6, i % 3 * 2e3};
        for (dem::CrackMaterial& c : walls.back().cracks) c.crushing = {4e6, 1e3};
    }
    std::vector<dem::PushResult> together(walls.size());
    dem::Ensemble e;
    e.size = walls.size();
    e.wall = [&](std::size_t i) { return walls.at(i); };
    e.done = [&](std::size_t i, dem::PushResult&& r) { together[i] = std::move(r); };
    dem::push_ensemble(m, e, small_wall::to(0.003), options, {.threads = 1});
    int crushed = 0;
    for (std::size_t i = 0; i < walls.size(); ++i) {
        const dem::PushResult alone = dem::push(m, walls[i], small_wall::to(0.003), options);
        INFO("wall " << i);
        CHECK(small_wall::same(alone, together[i]));
        CHECK(alone.residual < 0.01);
        crushed += alone.energy.crushing > 0.0;
    }
    CHECK(crushed > 2);
}
