#include "dem/block/model.hpp"
#include "dem/solver/ensemble.hpp"
#include "dem/solver/thread_time.hpp"
#include "tests/dem/small_wall.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <stdexcept>
#include <utility>
#include <vector>

namespace {

using dem::Outcome;
using dem::PushPlan;
using dem::PushResult;
using dem::SolverOptions;

/// A wall whose units crack.
struct Weak {
    dem::Model model;
    dem::WallMaterials materials;
    explicit Weak(double stress_mpa = 0.75, int sample = 0)
        : model(small_wall::model(small_wall::scene(stress_mpa)))
    {
        materials = scenes::table5_sample(small_wall::scene(stress_mpa), model, sample);
        for (dem::CrackMaterial& c : materials.cracks) c.ft *= 0.5, c.cohesion *= 0.5;
        materials.cracks.front().ft *= 4.0; // snaps back
    }
    [[nodiscard]] PushResult pushed(const PushPlan& plan, const SolverOptions& options) const
    {
        return dem::push(model, materials, plan, options);
    }
};

PushPlan with_snapshots(double target = 0.003)
{
    PushPlan plan = small_wall::to(target);
    plan.snapshot_every = 5e-4;
    return plan;
}

/// The same run at 1/2^times of the step and of the speed.
SolverOptions reduced(SolverOptions o, int times)
{
    for (int i = 0; i < times; ++i) {
        o.step_fraction *= 0.5;
        o.steps_per_mm *= 2.0;
    }
    return o;
}

/// The answer, whatever was thrown away on the way to it.
bool same_answer(const PushResult& a, const PushResult& b)
{
    bool all = small_wall::same_curve(a, b) && a.outcome == b.outcome &&
               small_wall::same(a.energy, b.energy) && a.step_fraction == b.step_fraction &&
               a.settled == b.settled && bits::same(a.settlement, b.settlement) &&
               a.snap_back_contacts == b.snap_back_contacts &&
               small_wall::same(a.at_peak, b.at_peak) &&
               small_wall::same(a.faces_at_peak, b.faces_at_peak) &&
               small_wall::same(a.at_end, b.at_end) && a.snapshots.size() == b.snapshots.size();
    for (std::size_t i = 0; all && i < a.snapshots.size(); ++i)
        all = small_wall::same(a.snapshots[i], b.snapshots[i]);
    return all;
}

/// A constant speed, and no error that is too large: only the ledger asks for a second push.
SolverOptions constant_speed()
{
    SolverOptions o;
    o.steps_per_mm = 300;
    o.unbalance_limit = 0.0;
    o.accuracy = 0.5;
    return o;
}

double largest_residual(const PushResult& r)
{
    double most = 0.0;
    for (const dem::CurvePoint& p : r.curve)
        most = std::max(most, std::abs(p.energy.residual()));
    return most;
}

} // namespace

TEST_CASE("wall run: a step beyond the stable one is found, reduced and recorded",
          "[dem][wall_run]")
{
    const auto [fraction, reductions] =
        GENERATE(table<double, int>({{1.8, 1}, {3.7, 2}, {7.0, 3}}));
    const Weak wall(GENERATE(0.15, 1.25));
    SolverOptions o = small_wall::quick();
    o.step_fraction = fraction;
    o.preload = GENERATE(dem::Preload::solved, dem::Preload::ramped);
    const PushResult r = wall.pushed(with_snapshots(), o);
    CHECK(r.outcome == Outcome::reached_target);
    CHECK(r.step_reductions == reductions);
    CHECK(r.step_fraction == fraction / std::pow(2.0, reductions));
    CHECK(r.residual < o.energy_tolerance);
    const PushResult direct = wall.pushed(with_snapshots(), reduced(o, reductions));
    CHECK(direct.step_reductions == 0);
    CHECK(same_answer(r, direct));
}

TEST_CASE("wall run: a ledger that does not close halves the step and the wall starts anew",
          "[dem][wall_run]")
{
    PushPlan plan = with_snapshots();
    if (GENERATE(true, false)) // decided before the first look
        plan.decided = [](std::span<const dem::CurvePoint> curve) {
            return curve.back().displacement > 2.6e-4;
        };
    SolverOptions o = constant_speed();
    o.preload = GENERATE(dem::Preload::solved, dem::Preload::ramped);
    int reduced_once = 0;
    for (int sample = 0; sample < 6; ++sample) {
        const Weak wall(0.15, sample);
        o.energy_tolerance = 0.01;
        const PushResult first = wall.pushed(plan, o),
                         second = wall.pushed(plan, reduced(o, 1));
        if (first.residual < 1.5 * second.residual) continue; // no tolerance tells them apart
        o.energy_tolerance = std::sqrt(first.residual * second.residual);
        const PushResult r = wall.pushed(plan, o);
        CHECK_FALSE(dem::failed(r.outcome));
        CHECK(r.step_reductions == 1);
        CHECK(r.cost.steps > second.cost.steps); // what was thrown away was paid for
        CHECK(r.residual <= o.energy_tolerance);
        CHECK(r.snap_back_contacts > 0);
        CHECK(same_answer(r, second));
        ++reduced_once;
    }
    CHECK(reduced_once > 0);
}

TEST_CASE(
    "wall run: a sink takes the snapshots that would be kept, and forgets those of a push "
    "that starts anew",
    "[dem][wall_run]")
{
    PushPlan plan = with_snapshots(), streamed = plan;
    std::vector<dem::Snapshot> taken;
    std::size_t forgotten = 0;
    streamed.sink = {.take =
                         [&](std::size_t wall, dem::Snapshot&& shot) {
                             CHECK(wall == 0);
                             taken.push_back(std::move(shot));
                         },
                     .forget =
                         [&](std::size_t wall) {
                             CHECK(wall == 0);
                             forgotten += taken.size();
                             taken.clear();
                         }};
    SolverOptions o = constant_speed();
    for (int sample = 0; sample < 6 && forgotten == 0; ++sample) {
        const Weak wall(0.15, sample);
        o.energy_tolerance = 0.01;
        const PushResult first = wall.pushed(plan, o),
                         second = wall.pushed(plan, reduced(o, 1));
        if (first.residual < 1.5 * second.residual) continue;
        o.energy_tolerance = std::sqrt(first.residual * second.residual);
        taken.clear();
        const PushResult kept = wall.pushed(plan, o);
        PushResult r = wall.pushed(streamed, o);
        CHECK(r.step_reductions == 1);
        CHECK(r.snapshots.empty());
        REQUIRE(taken.size() == kept.snapshots.size());
        r.snapshots = taken;
        CHECK(same_answer(r, kept));
    }
    CHECK(forgotten > 0);
    streamed.sink.forget = nullptr;
    CHECK_THROWS_WITH(Weak().pushed(streamed, o), Catch::Contains("sink"));
}

TEST_CASE("wall run: the time of a sink is none of the solver's", "[dem][wall_run]")
{
    PushPlan plan = with_snapshots(2e-4);
    plan.snapshot_every = 1e-4;
    double spent = 0.0;
    plan.sink.take = [&](std::size_t, dem::Snapshot&&) {
        const double begin = dem::thread_seconds();
        while (dem::thread_seconds() < begin + 0.2) {
        }
        spent += dem::thread_seconds() - begin;
    };
    plan.sink.forget = [](std::size_t) {};
    const PushResult r = Weak().pushed(plan, small_wall::quick());
    CHECK(spent > 0.5);
    CHECK(r.cost.seconds > 0.0);
    CHECK(r.cost.seconds < 0.2);
}

TEST_CASE("wall run: what a sink throws ends the push", "[dem][wall_run]")
{
    PushPlan plan = with_snapshots();
    plan.sink.take = [](std::size_t, dem::Snapshot&& shot) {
        if (shot.displacement > 1e-3) throw std::runtime_error("disk full");
    };
    plan.sink.forget = [](std::size_t) {};
    CHECK_THROWS_WITH(Weak().pushed(plan, small_wall::quick()), "disk full");
}

TEST_CASE("wall run: a ledger that closes with no step ends as energy astray",
          "[dem][wall_run]")
{
    SolverOptions o = small_wall::quick();
    o.energy_tolerance = 1e-15;
    const PushResult r = Weak().pushed(with_snapshots(), o);
    CHECK(r.outcome == Outcome::energy_astray);
    CHECK(dem::failed(r.outcome));
    CHECK(r.step_reductions == 6);
    CHECK(r.step_fraction == o.step_fraction / 64.0);
}

TEST_CASE("wall run: a wall that runs out of steps says so", "[dem][wall_run]")
{
    SolverOptions o = small_wall::quick();
    o.most_steps = 1000;
    const PushResult r = Weak().pushed(with_snapshots(), o);
    CHECK(r.outcome == Outcome::out_of_steps);
    CHECK(dem::failed(r.outcome));
    CHECK(r.cost.steps == 1000); // a multiple of the steps between looks
    CHECK(r.step_reductions == 0);
    CHECK(r.curve.size() > 2);
    CHECK(r.curve.size() < Weak().pushed(with_snapshots(), small_wall::quick()).curve.size());
}

TEST_CASE("wall run: contact updates are steps times contacts", "[dem][wall_run]")
{
    const Weak wall;
    const PushResult r = wall.pushed(with_snapshots(1e-4), small_wall::quick());
    const auto contacts =
        wall.model.dry.size() + wall.model.tied.size() + wall.model.cracks.size();
    CHECK(r.cost.steps > 0);
    CHECK(r.cost.contact_updates == r.cost.steps * static_cast<long long>(contacts));
}

TEST_CASE("wall run: ends where nothing more is to be learnt, the curve so far unchanged",
          "[dem][wall_run]")
{
    const Weak wall;
    PushPlan plan = with_snapshots();
    const PushResult full = wall.pushed(plan, small_wall::quick());
    std::size_t asked = 0;
    plan.decided = [&](std::span<const dem::CurvePoint> curve) {
        ++asked;
        CHECK(curve.size() == asked + 1); // once per point after the first
        return curve.back().displacement > 1e-3;
    };
    const PushResult r = wall.pushed(plan, small_wall::quick());
    CHECK(r.outcome == Outcome::decided);
    CHECK_FALSE(dem::failed(r.outcome));
    REQUIRE(r.curve.size() > 10);
    REQUIRE(r.curve.size() < full.curve.size());
    CHECK(r.curve.back().displacement > 1e-3);
    CHECK(r.curve[r.curve.size() - 2].displacement <= 1e-3);
    for (std::size_t i = 0; i < r.curve.size(); ++i) {
        CHECK(small_wall::same_forces(r.curve[i], full.curve[i]));
        CHECK(small_wall::same(r.curve[i].energy, full.curve[i].energy));
    }
    CHECK(r.cost.steps < full.cost.steps);
    CHECK(r.at_end.displacement < full.at_end.displacement);
}

TEST_CASE("wall run: what is never decided goes to its target", "[dem][wall_run]")
{
    const Weak wall;
    PushPlan plan = with_snapshots();
    const PushResult full = wall.pushed(plan, small_wall::quick());
    plan.decided = [](std::span<const dem::CurvePoint>) { return false; };
    CHECK(small_wall::same(wall.pushed(plan, small_wall::quick()), full));
}

TEST_CASE("wall run: snapshots nobody asked for are empty, and all else the same",
          "[dem][wall_run]")
{
    const Weak wall;
    PushPlan plan = with_snapshots();
    const PushResult full = wall.pushed(plan, small_wall::quick());
    plan.snapshot_at_peak = false;
    plan.snapshot_every = 0.0;
    PushResult r = wall.pushed(plan, small_wall::quick());
    CHECK(full.residual >= largest_residual(full));
    CHECK(r.at_peak.blocks.empty());
    CHECK(r.at_peak.faces.empty());
    CHECK(r.snapshots.empty());
    CHECK_FALSE(full.at_peak.blocks.empty());
    r.at_peak = full.at_peak;
    r.snapshots = full.snapshots;
    CHECK(small_wall::same(r, full));
}

TEST_CASE("wall run: snapshots are taken before the push, on the way and at the peak",
          "[dem][wall_run]")
{
    const PushResult r = Weak().pushed(with_snapshots(), small_wall::quick());
    REQUIRE(r.snapshots.size() == 7); // every 0.5 mm of 3 mm
    for (std::size_t i = 0; i < r.snapshots.size(); ++i) {
        const double at = 5e-4 * static_cast<double>(i);
        CHECK(r.snapshots[i].displacement >= at * (1.0 - 1e-9));
        CHECK(r.snapshots[i].displacement < at + 2e-4); // within a few points of the curve
    }
    CHECK(r.at_peak.force == scenes::peak_force(r));
    CHECK(r.faces_at_peak.force == scenes::peak_force(r));
    CHECK(r.faces_at_peak.faces.size() == r.at_peak.faces.size());
    CHECK(r.faces_at_peak.blocks.empty());
    CHECK(r.at_end.displacement == 0.003);
}

TEST_CASE("wall run: a wall pushed before it came to rest is marked", "[dem][wall_run]")
{
    const Weak wall;
    SolverOptions o = small_wall::quick();
    CHECK(wall.pushed(small_wall::to(1e-4), o).settled);
    SECTION("too few steps after a ramp")
    {
        o.preload = dem::Preload::ramped;
        CHECK(wall.pushed(small_wall::to(1e-4), o).settled);
        o.preload_steps = 100;
    }
    SECTION("more rest than the steps can bring")
    {
        o.preload_unbalance = 1e-9;
        o.preload_steps = 50;
    }
    CHECK_FALSE(wall.pushed(small_wall::to(1e-4), o).settled);
}
