/// Joints that wear: the law, a block that slides to and fro, and the same bits in every lane.

#include "dem/block/model.hpp"
#include "dem/contact/contact_law.hpp"
#include "dem/contact/wear.hpp"
#include "dem/solver/ensemble.hpp"
#include "dem/solver/push.hpp"
#include "scenes/paper_wall.hpp"
#include "tests/dem/small_wall.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <stdexcept>
#include <vector>

namespace {

constexpr double kNew = 0.1, kWorn = 0.04, kLength = 8e-3; // tan phi, tan phi, [m]

/// Friction coefficient after a slip, and its integral [m].
double exact(double slip) { return kWorn + (kNew - kWorn) * std::exp(-slip / kLength); }
double exact_work(double slip)
{
    return kWorn * slip + (kNew - kWorn) * kLength * (1.0 - std::exp(-slip / kLength));
}

/// A low rigid block of 1 m x 0.02 m under 0.5 MPa that slides on its base.
struct Slider {
    scenes::Scene scene = scenes::monolith(1.0, 0.02, 0.5e6, 1e10);
    dem::Model model;
    dem::WallMaterials materials;
    double pressed = 0.0, stiffness = 0.0; ///< [N] [N/m]

    Slider()
    {
        scene.wall.toe = dem::Toe::free;
        scene.loads.height = 0.02;
        scene.stone.young_modulus = scene.beam.material.young_modulus = 1e15;
        dem::Discretisation d;
        d.contact_points = 5;
        d.block_modes = d.beam_modes = 3;
        d.zones_per_interval = 1;
        model = scenes::model_of(scene, d);
        model.layout.wear = true;
        materials = scenes::uniform(scene, model);
        materials.base_joint.tan_phi = kNew;
        materials.base_joint.wear = {kWorn, kLength};
        const double t = scene.wall.thickness;
        pressed = 0.5e6 * t + scene.stone.density * 9.81 * 0.02 * t;
        // Shear of base and beam joint in series, and the turn of the block on its base.
        stiffness =
            1.0 / (2.0 / (scene.joint.ks * t) + 12.0 * 0.02 * 0.02 / (scene.joint.kn * t));
    }
};

} // namespace

TEST_CASE("wear: friction falls exponentially with the slip under pressure, whatever its steps",
          "[dem][wear]")
{
    const dem::DryLaw<double> joint{1e10, 4e9, 1.0 / 4e9, kNew};
    const dem::WearLaw<double> wear{kNew - kWorn, 1.0 / kLength};
    const int steps = GENERATE(2000, 20000);
    const double du = 2e-2 / steps;
    dem::DryState<double> state{-1e-4, 0.0}; // 1 MPa
    double roughness = 1.0, slip = 0.0, lost = 0.0;
    for (int i = 0; i < 2 * steps; ++i) { // there and back
        dem::DryLaw<double> worn = joint;
        worn.tan_phi = dem::worn_tan_phi(wear, joint.tan_phi, roughness);
        const auto u = dem::advance(worn, state, 0.0, i < steps ? du : -du);
        roughness = dem::roughness_after(wear, roughness, u.slip, u.sigma);
        state = u.state;
        slip += std::abs(u.slip);
        lost += u.friction;
    }
    const double step = du / kLength;
    CHECK(roughness == Approx(std::exp(-slip / kLength)).epsilon(step * step));
    CHECK(-state.tau == Approx(1e6 * exact(slip)).epsilon(step));
    CHECK(lost == Approx(1e6 * exact_work(slip)).epsilon(step));
}

TEST_CASE(
    "wear: nothing wears without pressure, without slip, or without a length; nothing heals",
    "[dem][wear]")
{
    const dem::WearLaw<double> wear{0.1, 1.0 / kLength}, none{0.0, 0.0};
    CHECK(dem::roughness_after(wear, 0.7, 1e-3, 0.0) == 0.7);
    CHECK(dem::roughness_after(wear, 0.7, 0.0, -1e6) == 0.7);
    CHECK(dem::roughness_after(none, 1.0, 1e-3, -1e6) == 1.0);
    CHECK(dem::roughness_after(wear, 0.7, -1e-3, -1e6) ==
          dem::roughness_after(wear, 0.7, 1e-3, -1e6));
    CHECK(dem::roughness_after(wear, 0.7, 1e9, -1e6) >= 1e-12); // no denormal numbers
    CHECK(dem::worn_tan_phi(wear, 0.62, 1.0) == 0.62);
}

TEST_CASE("wear: force and energy of every cycle of a sliding block are those of the law",
          "[dem][wear]")
{
    const Slider s;
    const double d = 5e-3;
    dem::PushPlan plan;
    plan.targets = {d, -d, d, -d, d, -d, 0.0};
    dem::SolverOptions options;
    options.accuracy = 0.001;
    options.kinematics = GENERATE(dem::Kinematics::small, dem::Kinematics::finite);
    const dem::PushResult r = dem::push(s.model, s.materials, plan, options);
    double slip = 0.0, at = 0.0; // plastic
    std::size_t turns = 0;
    for (std::size_t i = 1; i < r.curve.size(); ++i) {
        const dem::CurvePoint& p = r.curve[i];
        const double plastic = p.displacement - p.force / s.stiffness;
        slip += std::abs(plastic - at);
        at = plastic;
        if (turns + 1 >= plan.targets.size() || p.displacement != plan.targets[turns])
            continue; // the last target is the end, where the block still slides
        ++turns;
        INFO("turn " << turns << ", slip " << slip);
        CHECK(std::abs(p.force) == Approx(s.pressed * exact(slip)).epsilon(1e-3));
        CHECK(p.energy.friction == Approx(s.pressed * exact_work(slip)).epsilon(1e-3));
    }
    CHECK(turns == 6);
    CHECK(r.energy.friction == Approx(s.pressed * exact_work(slip)).epsilon(1e-3));
    CHECK(exact(slip) < 0.5 * kNew); // worn indeed
    CHECK(r.residual < 1e-3);
}

TEST_CASE("wear: a wall whose joints do not wear has the bits of a layout without wear",
          "[dem][wear]")
{
    dem::Model m = small_wall::model();
    const dem::WallMaterials w = scenes::uniform(small_wall::scene(), m);
    dem::SolverOptions options = small_wall::quick();
    options.kinematics = GENERATE(dem::Kinematics::small, dem::Kinematics::finite);
    const dem::PushResult without = dem::push(m, w, small_wall::to(0.003), options);
    m.layout.wear = true;
    CHECK(small_wall::same(dem::push(m, w, small_wall::to(0.003), options), without));
}

TEST_CASE("wear: the same bits alone and in any lane", "[dem][wear]")
{
    const scenes::Scene s = small_wall::scene();
    dem::Model m = small_wall::model(s);
    m.layout.wear = true;
    dem::SolverOptions options = small_wall::quick();
    options.kinematics = GENERATE(dem::Kinematics::small, dem::Kinematics::finite);
    dem::PushPlan plan;
    plan.targets = {0.003, -0.003, 0.0};
    std::vector<dem::WallMaterials> walls;
    for (std::size_t i = 0; i < dem::lanes<dem::Pack> + 1; ++i) {
        walls.push_back(scenes::table5_sample(s, m, i));
        if (i % 3 == 0) continue; // some do not wear
        for (dem::JointMaterial& j : walls.back().joints) j.wear = {0.3 * j.tan_phi, i * 1e-4};
    }
    std::vector<dem::PushResult> together(walls.size());
    dem::Ensemble e;
    e.size = walls.size();
    e.wall = [&](std::size_t i) { return walls.at(i); };
    e.done = [&](std::size_t i, dem::PushResult&& r) { together[i] = std::move(r); };
    dem::push_ensemble(m, e, plan, options, {.threads = 1});
    for (std::size_t i = 0; i < walls.size(); ++i) {
        INFO("wall " << i);
        CHECK(small_wall::same(dem::push(m, walls[i], plan, options), together[i]));
        CHECK(together[i].residual < 0.01);
    }
}

TEST_CASE("wear: is refused where the layout has none, and above the initial friction",
          "[dem][wear]")
{
    dem::Model m = small_wall::model();
    dem::WallMaterials w = scenes::uniform(small_wall::scene(), m);
    w.joints.front().wear = {0.1, 1e-3};
    CHECK_THROWS_AS(dem::check(m, w), std::invalid_argument);
    m.layout.wear = true;
    CHECK_NOTHROW(dem::check(m, w));
    w.joints.front().wear.tan_phi_res = 2.0 * w.joints.front().tan_phi;
    CHECK_THROWS_AS(dem::check(m, w), std::invalid_argument);
    w.joints.front().wear = {0.1, -1e-3};
    CHECK_THROWS_AS(dem::check(m, w), std::invalid_argument);
}
