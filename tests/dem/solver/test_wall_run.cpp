/// Tests of what a run makes of a step that is too large, and of a wall that comes down.

#include "dem/block/model.hpp"
#include "dem/small_wall.hpp"
#include "dem/solver/ensemble.hpp"
#include "dem/solver/state/recorder.hpp"
#include "dem/solver/step/stability_limit.hpp"
#include "dem/solver/step/vertical_load.hpp"
#include "scenes/paper_wall.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace {

dem::Discretisation coarse()
{
    dem::Discretisation d;
    d.contact_points = 3;
    d.block_modes = 6;
    return d;
}

scenes::Scene low_wall(double stress_mpa)
{
    scenes::Scene s = scenes::paper_wall(stress_mpa);
    s.wall.courses = 4;
    s.loads.height = 0.45;
    return s;
}

dem::PushPlan to(double target)
{
    dem::PushPlan plan;
    plan.targets = {target};
    return plan;
}

dem::PushResult pushed(const scenes::Scene& s, const dem::PushPlan& plan,
                       const dem::SolverOptions& o)
{
    const dem::Model m = scenes::model_of(s, coarse());
    return dem::push(m, scenes::uniform(s, m), plan, o);
}

double worst_residual(const dem::PushResult& r)
{
    double worst = std::abs(r.energy.residual());
    for (const dem::CurvePoint& p : r.curve)
        worst = std::max(worst, std::abs(p.energy.residual()));
    return worst;
}

} // namespace

TEST_CASE("wall run: a step beyond the limit is halved before it is tried, and says so",
          "[dem][wall_run]")
{
    dem::SolverOptions large, small;
    large.step_fraction = 1.9;
    small.step_fraction = 0.95;
    small.steps_per_mm = 2.0 * large.steps_per_mm;
    const dem::PushResult r = pushed(low_wall(0.50), to(0.001), large),
                          same = pushed(low_wall(0.50), to(0.001), small);
    CHECK(r.outcome == dem::Outcome::reached_target);
    CHECK(r.step_fraction == 0.95);
    CHECK(r.step_reductions == 1);
    CHECK(r.cost.steps == same.cost.steps); // none of them with the large step
    REQUIRE(r.curve.size() == same.curve.size());
    for (std::size_t i = 0; i < r.curve.size(); ++i)
        REQUIRE(r.curve[i].force == same.curve[i].force);
}

TEST_CASE("wall run: a step beyond the bound that the wall can bear is left alone",
          "[dem][wall_run]")
{
    scenes::Scene s =
        scenes::monolith(0.2, 0.1, 0.5e6, 1e10); // limit at sqrt(2), worked out in
    s.wall.base = dem::Base::fixed;              // test_stability_limit
    s.beam.rotation = dem::BeamRotation::fixed;
    dem::Discretisation d = coarse();
    d.block_modes = d.beam_modes = 3;
    const dem::Model m = scenes::model_of(s, d);
    dem::SolverOptions o;
    o.step_fraction = GENERATE(1.2, 1.39, 1.41, 2.0);
    const dem::PushResult r = dem::push(m, scenes::uniform(s, m), to(1e-4), o);
    CHECK(r.outcome == dem::Outcome::reached_target);
    CHECK(r.step_reductions == (o.step_fraction < 1.4 ? 0 : 1));
}

TEST_CASE("wall run: a joint that would chatter unseen by the ledger is not given the chance",
          "[dem][wall_run]")
{
    scenes::Scene s = low_wall(0.50);
    s.joint.kn *= 20.0;
    s.joint.ks *= 20.0;
    dem::Discretisation d = coarse();
    d.block_modes = 3;
    const dem::Model m = scenes::model_of(s, d);
    dem::SolverOptions o;
    o.step_fraction = 1.0;
    o.step_fraction = 1.02 / dem::step_over_limit(m, scenes::uniform(s, m), o);
    const dem::PushResult r = dem::push(m, scenes::uniform(s, m), to(0.001), o);
    CHECK(r.step_reductions == 1);
}

TEST_CASE(
    "wall run: a wall shaken to pieces while it settles is no collapse but a step too large",
    "[dem][wall_run]")
{
    // Within the bound: joints that open and close without damping (stability_limit.hpp).
    const scenes::Scene s = scenes::paper_wall(0.50);
    dem::Discretisation d = coarse();
    d.block_modes = 12;
    const dem::Model m = scenes::model_of(s, d);
    dem::SolverOptions o;
    o.damping_factor = 0.0;
    o.step_fraction = 1.0;
    const dem::PushResult r = dem::push(m, scenes::uniform(s, m), to(1e-4), o);
    CHECK(r.outcome == dem::Outcome::reached_target);
    CHECK(r.step_reductions > 0);
    CHECK(worst_residual(r) < 0.01);
}

TEST_CASE("wall run: what is called ok keeps its energy tolerance at every point of its curve",
          "[dem][wall_run]")
{
    dem::SolverOptions fast;
    fast.steps_per_mm = 30.0;
    fast.unbalance_limit = 0.0;
    fast.energy_tolerance = GENERATE(1e-5, 1e-4, 3e-4, 1e-3, 3e-3, 1e-2);
    dem::PushPlan plan = to(0.002);
    plan.record_every = 1e-4;
    const dem::PushResult r = pushed(low_wall(0.50), plan, fast);
    if (dem::failed(r.outcome))
        CHECK(r.outcome == dem::Outcome::energy_astray);
    else
        CHECK(worst_residual(r) <= fast.energy_tolerance);
    CHECK(worst_residual(r) <= r.residual);
}

TEST_CASE("wall run: a wall has come down only if its ledger closes", "[dem][wall_run]")
{
    dem::SolverOptions flying;
    flying.steps_per_mm = 0.05; // 10 m before the first look
    flying.unbalance_limit = 0.0;
    CHECK(pushed(low_wall(0.50), to(20.0), flying).outcome == dem::Outcome::lost_equilibrium);
    flying.energy_tolerance = 1e-12;
    CHECK(pushed(low_wall(0.50), to(20.0), flying).outcome == dem::Outcome::energy_astray);
}

TEST_CASE("wall run: a wall that falls has come down before its blocks strike each other",
          "[dem][wall_run]")
{
    const scenes::Scene s = low_wall(0.75);
    const dem::Model m = scenes::model_of(s, coarse());
    dem::SolverOptions o;
    o.kinematics = dem::Kinematics::finite;
    o.steps_per_mm = 50;
    o.accuracy = 0.1;
    const dem::PushResult r = dem::push(m, scenes::table5_sample(s, m, 2), to(0.9), o);
    REQUIRE(r.outcome == dem::Outcome::lost_equilibrium);
    CHECK(r.step_reductions == 0);
    CHECK(r.energy.kinetic < 0.3 * r.energy.passed()); // it has only begun to fall
}

TEST_CASE("wall run: a wall that misses the accuracy is pushed again more slowly, and says how "
          "often",
          "[dem][wall_run]")
{
    const scenes::Scene s = small_wall::scene(0.15);
    const dem::Model m = small_wall::model(s);
    const dem::SolverOptions o;
    bool again = false, at_once = false;
    for (int sample = 0; sample < 4; ++sample) {
        const dem::WallMaterials w = scenes::table5_sample(s, m, sample);
        dem::PushPlan plan = small_wall::to(2e-3);
        dem::PushProgress told;
        plan.progress = [&](const dem::PushProgress& p) { told = p; };
        const dem::PushResult r = dem::push(m, w, plan, o);
        CHECK(r.outcome == dem::Outcome::reached_target);
        CHECK(told.slowdowns == r.slowdowns);
        CHECK(told.done == 1.0);
        CHECK((told.error_before > o.accuracy) == (r.slowdowns > 0));
        CHECK(r.slowdowns >= 0);
        CHECK(r.slowdowns <= 3);
        CHECK((r.slowdowns == 3 || r.solver_error <= o.accuracy));
        CHECK(r.solver_error >= 0.5 * o.accuracy); // less is not claimed
        again = again || r.slowdowns > 0;
        at_once = at_once || r.slowdowns == 0;
    }
    CHECK(again);
    CHECK(at_once);
}

TEST_CASE(
    "wall run: a push that misses the accuracy is given up once its peak is past, and the "
    "slower one goes on at the first speed once it is past its own",
    "[dem][wall_run]")
{
    const scenes::Scene s = low_wall(0.15);
    const dem::Model m = scenes::model_of(s, coarse());
    const dem::WallMaterials w = scenes::table5_sample(s, m, 0);
    dem::SolverOptions o, once;
    o.kinematics = once.kinematics = dem::Kinematics::finite;
    o.accuracy = once.accuracy = 0.03;
    once.most_slowdowns = 0;
    struct Told {
        double given_up = 0.0; ///< share of the way
        int looks = 0;         ///< in the last push, far behind its peak: one in 500 steps
        dem::PushResult result;
    };
    const auto push = [&](const dem::SolverOptions& options) {
        Told told;
        dem::PushPlan plan = to(0.14);
        plan.progress = [&](const dem::PushProgress& p) {
            if (p.slowdowns == 0) told.given_up = p.done;
            told.looks += p.displacement > 0.11 ? 1 : 0;
        };
        told.result = dem::push(m, w, plan, options);
        return told;
    };
    const Told repeated = push(o), first = push(once);
    REQUIRE(repeated.result.slowdowns > 0);
    CHECK(repeated.given_up < 0.2);
    CHECK(first.given_up == 1.0);
    CHECK(first.looks > 5);
    CHECK(repeated.looks < 1.5 * first.looks);
}

TEST_CASE(
    "wall run: a push begins with close points, over one interval one way and two to and fro",
    "[dem][wall_run]")
{
    const scenes::Scene s = low_wall(0.5);
    dem::PushPlan one_way = to(2e-4), cycle = to(2e-4);
    cycle.targets.push_back(-2e-4);
    const auto points = [&](const dem::PushPlan& plan, double intervals) {
        const auto curve = pushed(s, plan, {}).curve;
        const auto beyond = std::ranges::find_if(curve, [&](const dem::CurvePoint& p) {
            return p.interval_end > (intervals + 0.5) * plan.record_every;
        });
        return beyond - curve.begin() - 1; // without the one at zero
    };
    CHECK(points(one_way, 1) == dem::Recorder::kAtStart);
    CHECK(points(one_way, 2) == dem::Recorder::kAtStart + 1);
    CHECK(points(cycle, 2) == dem::Recorder::kAfterTurn);
}

TEST_CASE("wall run: a force that holds the loaded wall is no peak that is past",
          "[dem][wall_run]")
{
    scenes::Scene s = low_wall(0.15);
    s.wall.openings = {{0.15, 0.0, 0.2, 0.3}};
    s.wall.lintel_bearing = 0.1;
    s.wall.lintel = {30e9, 0.2, 2500.0};
    const dem::Model m = scenes::model_of(s, coarse());
    dem::SolverOptions o;
    o.accuracy = 1e-5; // none is so accurate
    o.most_slowdowns = 1;
    for (const double target : {0.02, -0.02}) {
        dem::PushPlan plan = to(target);
        double given_up = 0.0;
        plan.progress = [&](const dem::PushProgress& p) {
            if (p.slowdowns == 0) given_up = p.displacement;
        };
        const dem::PushResult r = dem::push(m, scenes::uniform(s, m), plan, o);
        INFO(r.curve.front().force);
        CHECK(r.slowdowns == 1);
        CHECK(given_up / target > 0.05);
    }
}

TEST_CASE("wall run: a stiff and slender wall is pushed no faster than it can follow",
          "[dem][wall_run]")
{
    scenes::Scene s = scenes::paper_wall(0.50);
    s.wall.length = 0.4;
    s.wall.courses = 12;
    s.wall.base = dem::Base::joint;
    s.wall.toe = dem::Toe::free;
    s.wall.cracks.pattern = {dem::CrackPattern::Kind::none};
    s.loads.height = 1.2 + s.beam.height;
    s.joint.kn = s.joint.ks = 1e12;
    dem::Discretisation d;
    d.contact_points = 2;
    d.block_modes = d.beam_modes = 3;
    const dem::Model m = scenes::model_of(s, d);
    const dem::PushResult r = dem::push(m, scenes::uniform(s, m), to(2e-3), {});
    const double limit =
        dem::vertical_load(m, scenes::uniform(s, m)) * s.wall.length / (2.0 * s.loads.height);
    INFO(scenes::peak_force(r) / limit);
    CHECK(scenes::peak_force(r) < 1.01 * limit);
}

TEST_CASE("wall run: the ledger closes over a ramp of the load, however short",
          "[dem][wall_run]")
{
    dem::SolverOptions o;
    o.preload = dem::Preload::ramped;
    o.preload_steps = GENERATE(400, 1000, 3000);
    o.step_fraction = 0.5;
    const dem::PushResult r = pushed(low_wall(0.50), to(1e-5), o);
    CHECK(r.outcome == dem::Outcome::reached_target);
    CHECK(std::abs(r.curve.front().energy.residual()) < 1e-7);
}

TEST_CASE("wall run: the residual of a run covers the start of its curve", "[dem][wall_run]")
{
    dem::SolverOptions o; // swings all the time
    o.damping_factor = 0.0;
    o.step_fraction = 0.5;
    o.preload = dem::Preload::ramped;
    o.preload_steps = GENERATE(400, 420, 440, 460);
    dem::PushPlan plan = to(1e-5);
    const dem::PushResult r = pushed(low_wall(0.50), plan, o);
    CHECK(std::abs(r.curve.front().energy.residual()) <= r.residual);
}

TEST_CASE("wall run: a wall pressed together by more than its height has not come down",
          "[dem][wall_run]")
{
    scenes::Scene s = low_wall(0.50);
    s.joint.kn *= 1e-4;
    s.joint.ks *= 1e-4;
    s.loads.vertical_stress = 5e6;
    const dem::PushResult r = pushed(s, to(1e-3), {});
    REQUIRE(r.settlement > 0.4);
    CHECK(r.outcome == dem::Outcome::reached_target);
}

TEST_CASE("wall run: absurd stiffness ends with a reason and leaves the neighbours as they are",
          "[dem][wall_run]")
{
    const scenes::Scene s = low_wall(0.50);
    const dem::Model m = scenes::model_of(s, coarse());
    const int n = 5;
    const auto curves = [&](bool absurd) {
        std::vector<dem::PushResult> results(n);
        dem::Ensemble e;
        e.size = n;
        e.wall = [&](std::size_t i) {
            dem::WallMaterials w = scenes::table5_sample(s, m, i);
            if (absurd && i == 2)
                for (dem::JointMaterial& j : w.joints) j.kn = HUGE_VAL;
            return w;
        };
        e.done = [&](std::size_t i, dem::PushResult&& r) { results[i] = std::move(r); };
        dem::push_ensemble(m, e, to(5e-4));
        return results;
    };
    const auto with = curves(true), without = curves(false);
    CHECK(with[2].outcome == dem::Outcome::not_finite);
    for (int i = 0; i < n; ++i) {
        if (i == 2) continue;
        REQUIRE(with[i].curve.size() == without[i].curve.size());
        for (std::size_t k = 0; k < with[i].curve.size(); ++k)
            REQUIRE(with[i].curve[k].force == without[i].curve[k].force);
    }
}
