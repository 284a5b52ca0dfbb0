/// The pushed wall of the paper as a whole: what must hold whatever the numbers are.

#include "dem/block/model.hpp"
#include "dem/scene/mechanism/mechanism.hpp"
#include "dem/solver/slower.hpp"
#include "dem/solver/step/step.hpp"
#include "scenes/paper_wall.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <string>

namespace {

dem::Discretisation coarse()
{
    dem::Discretisation d;
    d.contact_points = 3;
    d.block_modes = 6;
    return d;
}

dem::PushResult pushed(const scenes::Scene& s, const dem::PushPlan& plan = {},
                       const dem::SolverOptions& o = {},
                       const dem::Discretisation& d = coarse())
{
    const dem::Model m = scenes::model_of(s, d);
    return dem::push(m, scenes::uniform(s, m), plan, o);
}

double worst_residual(const dem::PushResult& r)
{
    double worst = 0.0;
    for (const dem::CurvePoint& p : r.curve)
        worst = std::max(worst, std::abs(p.energy.residual()));
    return worst;
}

dem::PushPlan to(std::vector<double> targets)
{
    dem::PushPlan plan;
    plan.targets = std::move(targets);
    return plan;
}

} // namespace

TEST_CASE(
    "push: the energy ledger closes within 0.5 % of the work, whatever the law and the damping",
    "[dem][push][slow]")
{
    dem::SolverOptions o;
    o.law = GENERATE(dem::ContactLaw::coupled, dem::ContactLaw::uncoupled);
    o.damping = GENERATE(dem::Damping::combined, dem::Damping::local);
    const double stress = GENERATE(0.15, 1.25);
    const dem::PushResult r = pushed(scenes::paper_wall(stress), to({0.015}), o);
    CHECK(worst_residual(r) < 0.005);
    CHECK(r.energy.friction > 0.0);
    CHECK(r.energy.damping > 0.0);
    CHECK(r.energy.work > r.energy.friction);
}

TEST_CASE("push: the ledger closes as well with cracks that stay propped, to and fro too",
          "[slow][dem][push]")
{
    int propped = 0; // walls in which a crack closed again
    for (const double stress : {0.75, 1.25})
        for (const auto law : {dem::ContactLaw::coupled, dem::ContactLaw::uncoupled})
            for (const dem::PushPlan& plan : {to({0.015}), to({0.008, -0.008, 0.0})}) {
                INFO(stress << " MPa, to " << plan.targets.front());
                const scenes::Scene s = scenes::paper_wall(stress);
                dem::SolverOptions secant, elastic;
                secant.law = elastic.law = law;
                secant.most_slowdowns = elastic.most_slowdowns = 0; // the same speed
                elastic.unloading = dem::Unloading::elastic;
                const dem::PushResult a = pushed(s, plan, secant), b = pushed(s, plan, elastic);
                CHECK(worst_residual(b) < 0.005);
                CHECK(b.energy.fracture > 0.0);
                CHECK(b.curve[10].force ==
                      Approx(a.curve[10].force).epsilon(1e-9)); // none open yet
                propped += b.energy.elastic != a.energy.elastic;
            }
    CHECK(propped > 5); // of 8
}

TEST_CASE("push: the load on the beam comes down to the ground", "[dem][push]")
{
    for (const dem::Base base : {dem::Base::fixed, dem::Base::joint}) {
        scenes::Scene s = scenes::paper_wall(0.50);
        s.wall.base = base;
        const dem::PushResult r = pushed(s, to({0.008}));
        for (const dem::CurvePoint& p : r.curve)
            CHECK(p.base_shear == Approx(p.force).margin(0.01 * s.loads.vertical_stress * 0.2));
    }
}

TEST_CASE("push: half the time step, and half the speed, move the peak by less than 1 %",
          "[dem][push][slow]")
{
    const scenes::Scene s = scenes::paper_wall(GENERATE(0.50, 1.25));
    const double peak = scenes::peak_force(pushed(s, to({0.015})));
    dem::SolverOptions shorter;
    const dem::SolverOptions slower = dem::slower({}, 2.0);
    shorter.step_fraction = 0.5 * shorter.step_fraction;
    CHECK(scenes::peak_force(pushed(s, to({0.015}), shorter)) == Approx(peak).epsilon(0.01));
    CHECK(scenes::peak_force(pushed(s, to({0.015}), slower)) == Approx(peak).epsilon(0.01));
}

TEST_CASE("push: the same wall twice gives the same bits", "[dem][push]")
{
    const scenes::Scene s = scenes::paper_wall(1.00);
    const dem::PushResult a = pushed(s, to({0.010})), b = pushed(s, to({0.010}));
    REQUIRE(a.curve.size() == b.curve.size());
    for (std::size_t i = 0; i < a.curve.size(); ++i) {
        REQUIRE(a.curve[i].force == b.curve[i].force);
        REQUIRE(a.curve[i].energy.friction == b.curve[i].energy.friction);
    }
}

TEST_CASE("push: a wall moves by the same bits wherever its push is to end", "[dem][push]")
{
    dem::SolverOptions o;
    o.kinematics = dem::Kinematics::finite;
    o.accuracy = 0.03;
    const auto first_of_a_push_to = [&](double target) {
        dem::PushPlan plan = to({target});
        plan.decided = [](std::span<const dem::CurvePoint> curve) {
            return curve.back().displacement > 0.012;
        };
        return pushed(scenes::paper_wall(1.00), plan, o);
    };
    const dem::PushResult near = first_of_a_push_to(0.06), far = first_of_a_push_to(0.15);
    REQUIRE(near.curve.size() == far.curve.size());
    CHECK(near.curve.size() > 100);
    CHECK(near.cost.steps == far.cost.steps);
    for (std::size_t i = 0; i < near.curve.size(); ++i) {
        CHECK(near.curve[i].displacement == far.curve[i].displacement);
        CHECK(near.curve[i].force == far.curve[i].force);
    }
}

TEST_CASE(
    "push: what stands at the end of a push is known at half of its way, and what dropped is "
    "not",
    "[dem][push]")
{
    dem::SolverOptions o;
    o.kinematics = dem::Kinematics::finite;
    o.accuracy = 0.05;
    const double target = GENERATE(4e-3, 5.1e-3, -7e-3);
    dem::PushPlan plan = to({target});
    CHECK_FALSE(pushed(scenes::paper_wall(0.15), plan, o).at_half); // not asked for
    plan.drop = 0.8;
    const dem::PushResult r = pushed(scenes::paper_wall(0.15), plan, o);
    REQUIRE_FALSE(r.at_drop);
    REQUIRE(r.at_half);
    CHECK(r.at_half->displacement / target > 0.44);
    CHECK(r.at_half->displacement / target <= 0.5);
    CHECK(r.at_half->blocks.back().displacement[0].x / target > 0.4);
    plan.drop = 0.999999; // the curve is not smooth
    const dem::PushResult dropped = pushed(scenes::paper_wall(0.15), plan, o);
    CHECK(dropped.at_drop.has_value() != dropped.at_half.has_value());
}

TEST_CASE("push: a wall in a lane of a pack moves as it does alone, bit for bit",
          "[dem][push][pack]")
{
    const scenes::Scene s = scenes::paper_wall(1.25);
    const dem::Model m = scenes::model_of(s, coarse());
    const dem::StepTables t = dem::step_tables(m);
    const dem::SolverOptions o;
    std::vector<dem::WallMaterials> walls;
    for (int i = 0; i < dem::lanes<dem::Pack>; ++i)
        walls.push_back(scenes::table5_sample(s, m, i));
    dem::WallState<dem::Pack> together = dem::unloaded<dem::Pack>(m, t, walls, o);
    std::vector<dem::WallState<double>> alone;
    for (const dem::WallMaterials& w : walls)
        alone.push_back(dem::unloaded<double>(m, t, {&w, 1}, o));
    for (int step = 0; step < 3000; ++step) {
        const double drive = step < 500 ? 0.0 : 4e-6;
        dem::step<dem::Pack>(t, o, {dem::Pack(std::min(1.0, step / 300.0)), dem::Pack(drive)},
                             together);
        for (auto& w : alone) dem::step<double>(t, o, {std::min(1.0, step / 300.0), drive}, w);
    }
    for (int i = 0; i < dem::lanes<dem::Pack>; ++i) {
        REQUIRE(together.top_force[i] == alone[i].top_force);
        REQUIRE(together.friction[i] == alone[i].friction);
        for (std::size_t mode = 0; mode < together.q.size(); ++mode)
            REQUIRE(together.q[mode][i] == alone[i].q[mode]);
    }
}

TEST_CASE("push: stiffer joints carry the fictitious masses with them and stay stable",
          "[dem][push]")
{
    const scenes::Scene s = scenes::paper_wall(0.50);
    const dem::Model m = scenes::model_of(s, coarse());
    dem::WallMaterials w = scenes::uniform(s, m);
    for (dem::JointMaterial& j : w.joints) j.kn *= 20.0, j.ks *= 20.0;
    for (dem::CrackMaterial& c : w.cracks) c.kn *= 20.0, c.ks *= 20.0;
    const dem::PushResult r = dem::push(m, w, to({0.003}));
    CHECK(r.outcome == dem::Outcome::reached_target);
    CHECK(worst_residual(r) < 0.005);
    CHECK(scenes::peak_force(r) <
          0.55 * (100e3 + 6e3)); // below the rocking limit of the 1.10 m lever
}

TEST_CASE("push: coupled and uncoupled laws share the peak and part after it (Fig. 7)",
          "[dem][push][slow]")
{
    const scenes::Scene s = scenes::paper_wall(1.25);
    dem::SolverOptions uncoupled;
    uncoupled.law = dem::ContactLaw::uncoupled;
    const dem::PushResult a = pushed(s, {}, {}, {}), b = pushed(s, {}, uncoupled, {});
    CHECK(scenes::peak_force(b) == Approx(scenes::peak_force(a)).epsilon(0.02));
    const auto area = [](const dem::PushResult& r) {
        double sum = 0.0;
        for (std::size_t i = 1; i < r.curve.size(); ++i)
            sum += r.curve[i].force * (r.curve[i].displacement - r.curve[i - 1].displacement);
        return sum;
    };
    CHECK(area(a) < area(b));
}

TEST_CASE("push: at 0.15 MPa the wall rocks and keeps its load, at 1.25 MPa units crack",
          "[dem][push][slow]")
{
    const dem::PushResult low = pushed(scenes::paper_wall(0.15)),
                          high = pushed(scenes::paper_wall(1.25));
    const dem::Mechanism l = dem::mechanism(low.at_end, 1.10),
                         h = dem::mechanism(high.at_end, 1.10);
    CHECK(l.cracked_units == 0);
    CHECK(dem::failure_mode(l, false) == dem::FailureMode::rocking);
    CHECK(low.curve.back().force > 0.95 * scenes::peak_force(low));
    CHECK(h.cracked_units > 0);
    CHECK(dem::failure_mode(h, false) == dem::FailureMode::mixed);
}

TEST_CASE("push: pushed back and forth, the wall dissipates and the ledger still closes",
          "[dem][push]")
{
    const dem::PushResult r = pushed(scenes::paper_wall(0.50), to({0.004, -0.004, 0.0}));
    CHECK(r.curve.back().displacement == Approx(0.0).margin(1e-4));
    const auto least =
        std::min_element(r.curve.begin(), r.curve.end(),
                         [](const auto& a, const auto& b) { return a.force < b.force; });
    CHECK(least->force <
          -0.5 * scenes::peak_force(
                     r)); // the toe on the other side is held as well: by the fixed base
    CHECK(worst_residual(r) < 0.005);
}

TEST_CASE(
    "push: a wall whose blocks are further apart than its height has lost its equilibrium",
    "[dem][push]")
{
    dem::SolverOptions fast;
    fast.steps_per_mm = 6;
    fast.unbalance_limit = 0.0;
    const dem::PushResult r = pushed(scenes::paper_wall(0.15), to({5.0}), fast);
    CHECK(r.outcome == dem::Outcome::lost_equilibrium);
    CHECK(r.curve.size() > 2);
    for (const dem::CurvePoint& p : r.curve) CHECK(std::isfinite(p.force));
}

TEST_CASE("push: a target given twice adds no point and no NaN", "[dem][push]")
{
    const dem::PushResult r = pushed(scenes::paper_wall(0.50), to({5e-4, 5e-4}));
    for (const dem::CurvePoint& p : r.curve) CHECK(std::isfinite(p.force));
    CHECK(r.curve.size() == pushed(scenes::paper_wall(0.50), to({5e-4})).curve.size());
}

TEST_CASE("push: snap-back contacts are counted", "[dem][push]")
{
    const scenes::Scene s = scenes::paper_wall(0.15); // f_T 3.7 > sqrt(2 G k_n) = 3.595 MPa
    CHECK(pushed(s, to({1e-5})).snap_back_contacts == 45 * 3);
    CHECK(pushed(scenes::paper_wall(0.50), to({1e-5})).snap_back_contacts == 0); // 4.216 MPa
}

TEST_CASE("push: materials that do not fit the wall are refused", "[dem][push]")
{
    const scenes::Scene s = scenes::paper_wall(0.50);
    const dem::Model m = scenes::model_of(s, coarse());
    dem::WallMaterials w = scenes::uniform(s, m);
    std::string message;
    SECTION("a joint too few") { w.joints.pop_back(), message = "its 135 joint IDs"; }
    SECTION("a crack too few") { w.cracks.pop_back(), message = "its 45 crack IDs"; }
    SECTION("no stiffness") { w.joints[7].kn = 0.0, message = "joint 8: "; }
    SECTION("not a number") { w.cracks[3].ft = std::nan(""), message = "crack 4: "; }
    SECTION("a residual cohesion above the initial one")
    {
        w.cracks[3].cohesion_res = 2.0 * w.cracks[3].cohesion;
        message = "crack 4: the residual cohesion";
    }
    SECTION("a beam joint that was forgotten") { w.beam_joint = {}, message = "beam joint: "; }
    SECTION("a beam joint that has no friction coefficient")
    {
        w.beam_joint.tan_phi = std::nan("");
        message = "beam joint: the friction";
    }
    SECTION("a stone that was forgotten") { w.stone = {}, message = "stone: Young's"; }
    SECTION("no density") { w.stone.density = std::nan(""), message = "stone: the density"; }
    SECTION("another Poisson's ratio than the model's")
    {
        w.stone.poisson_ratio = 0.25;
        message = "stone: Poisson's ratio must be that of the model";
    }
    SECTION("tension on the beam") { w.vertical_stress = -1.0, message = "vertical stress"; }
    CHECK_THROWS_WITH(dem::push(m, w, to({1e-3})), Catch::Contains(message));
}

TEST_CASE("push: a base joint is asked for where the wall stands on one, and only there",
          "[dem][push]")
{
    scenes::Scene s = scenes::paper_wall(0.50);
    s.wall.base = GENERATE(dem::Base::fixed, dem::Base::joint);
    const dem::Model m = scenes::model_of(s, coarse());
    dem::WallMaterials w = scenes::uniform(s, m);
    w.base_joint = {};
    if (s.wall.base == dem::Base::fixed)
        CHECK_NOTHROW(dem::check(m, w));
    else
        CHECK_THROWS_WITH(dem::check(m, w), Catch::Contains("base joint: "));
}

TEST_CASE("push: Poisson's ratio of the stone reaches the blocks", "[dem][push]")
{
    const auto stiffness = [](double nu) {
        scenes::Scene s = scenes::paper_wall(0.50);
        s.stone.poisson_ratio = nu;
        s.joint.ks = s.joint.kn / 2.4; // as at 0.2: joints and cracks stay the same
        s.crack.ks = s.crack.kn / 2.4;
        const dem::PushResult r = pushed(s, to({2e-4}));
        return r.curve.back().force / r.curve.back().displacement;
    };
    const double soft = stiffness(0.49), stiff = stiffness(0.0);
    CHECK(std::abs(stiff / soft - 1.0) > 1e-3);
    CHECK(stiff == Approx(soft).epsilon(0.1));
}
