#include "dem/block/model.hpp"
#include "dem/contact/pack.hpp"
#include "dem/solver/ensemble.hpp"
#include "tests/dem/small_wall.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <thread>
#include <utility>
#include <vector>

namespace {

using dem::Outcome;
using dem::PushResult;
using dem::WallMaterials;
using dem::Workers;

constexpr std::size_t kLanes = dem::lanes<dem::Pack>;
constexpr std::size_t kWalls = 3 * kLanes;

/// One model, its walls, each with its own stress, and what push() says of each.
struct Alone {
    dem::Model model = small_wall::model();
    dem::PushPlan plan = small_wall::to(0.003);
    dem::SolverOptions options = small_wall::quick();
    std::vector<WallMaterials> walls;
    std::vector<PushResult> results;
    Alone()
    {
        plan.snapshot_every = 1e-3;
        for (std::size_t i = 0; i < kWalls; ++i) {
            walls.push_back(scenes::table5_sample(small_wall::scene(), model, i));
            if (i % 3 > 0) walls.back().vertical_stress = i % 3 == 1 ? 0.15e6 : 1.25e6;
            for (dem::CrackMaterial& c : walls.back().cracks) {
                c.ft *= 0.5, c.cohesion *= 0.5; // cracks, so that a lane is not left as new
                c.tension_reduces_shear = i % 2 == 0;
            }
            results.push_back(dem::push(model, walls.back(), plan, options));
        }
    }
};
const Alone& alone()
{
    static const Alone once;
    return once;
}

Workers workers(int threads, bool scalar = false)
{
    return {.threads = threads, .scalar = scalar};
}

/// Results by number; a number that comes twice or never fails the test.
std::vector<PushResult> pushed(const std::vector<WallMaterials>& walls, const Workers& w,
                               const dem::SolverOptions& options = alone().options)
{
    const Alone& a = alone();
    std::vector<PushResult> results(walls.size());
    std::vector<int> times(walls.size(), 0);
    dem::Ensemble e;
    e.size = walls.size();
    e.wall = [&](std::size_t i) { return walls.at(i); };
    e.done = [&](std::size_t i, PushResult&& r) {
        ++times.at(i);
        results[i] = std::move(r);
    };
    dem::push_ensemble(a.model, e, a.plan, options, w);
    CHECK(std::count(times.begin(), times.end(), 1) == static_cast<int>(times.size()));
    return results;
}

/// The first n walls, pushed together, are those pushed alone.
void check_first(std::size_t n, const Workers& w)
{
    const Alone& a = alone();
    const auto together = pushed({a.walls.begin(), a.walls.begin() + n}, w);
    for (std::size_t i = 0; i < n; ++i) {
        INFO("wall " << i << " of " << n);
        CHECK(small_wall::same(together[i], a.results[i]));
    }
}

/// An ensemble of copies of one wall, which counts what was asked for and what came.
struct Counted {
    std::atomic<int> asked = 0;
    int came = 0;
    dem::Ensemble ensemble;
    explicit Counted(std::size_t size)
    {
        ensemble.size = size;
        ensemble.wall = [this](std::size_t) {
            ++asked;
            return alone().walls[0];
        };
        ensemble.done = [this](std::size_t, PushResult&&) { ++came; };
    }
    void run(int threads) const
    {
        dem::push_ensemble(alone().model, ensemble, small_wall::to(2e-4), alone().options,
                           workers(threads));
    }
};

} // namespace

TEST_CASE("ensemble: the walls of the test differ, and crack, slide and rock",
          "[dem][ensemble]")
{
    const auto& r = alone().results;
    for (std::size_t i = 1; i < r.size(); ++i) {
        CHECK(r[i].outcome == Outcome::reached_target);
        CHECK(r[i].cost.steps != r[i - 1].cost.steps); // lanes are handed on at different times
        CHECK_FALSE(small_wall::same_curve(r[i], r[i - 1]));
    }
    const auto some = [&](auto what) { return std::any_of(r.begin(), r.end(), what); };
    CHECK(some([](const PushResult& x) { return x.energy.fracture > 0.1; }));
    CHECK(some([](const PushResult& x) { return x.energy.friction > 1.0; }));
}

TEST_CASE("ensemble: a wall has the same bits alone and in any register, thread and size",
          "[dem][ensemble]")
{
    SECTION("scalar, 1 thread") { check_first(kWalls, workers(1, true)); }
    SECTION("scalar, 2 threads") { check_first(kLanes, workers(2, true)); }
    SECTION("packs, 1 thread") { check_first(kWalls, workers(1)); }
    SECTION("packs, 2 threads") { check_first(kWalls, workers(2)); }
    SECTION("packs, 3 threads") { check_first(kWalls, workers(3)); }
    SECTION("a thread per core") { check_first(kLanes, workers(0)); }
    SECTION("one wall") { check_first(1, workers(1)); }
    SECTION("one wall, 3 threads") { check_first(1, workers(3)); }
    SECTION("a lane free") { check_first(kLanes - 1, workers(1)); }
    SECTION("three more than lanes") { check_first(kLanes + 3, workers(1)); }
}

TEST_CASE("ensemble: the order of the walls moves no bit", "[dem][ensemble]")
{
    const Alone& a = alone();
    const auto back = pushed({a.walls.rbegin(), a.walls.rend()}, workers(1));
    for (std::size_t i = 0; i < kWalls; ++i)
        CHECK(small_wall::same(back[kWalls - 1 - i], a.results[i]));
}

TEST_CASE("ensemble: by a ramp, with local damping and the uncoupled law the bits are the same",
          "[dem][ensemble]")
{
    const Alone& a = alone();
    dem::SolverOptions o = a.options;
    o.preload = dem::Preload::ramped;
    o.preload_steps = 1000;
    o.damping = dem::Damping::local;
    o.law = dem::ContactLaw::uncoupled;
    o.unloading = GENERATE(dem::Unloading::secant, dem::Unloading::elastic);
    const std::vector<WallMaterials> walls(a.walls.begin(), a.walls.begin() + kLanes + 3);
    const auto together = pushed(walls, workers(1), o);
    for (std::size_t i = 0; i < walls.size(); ++i)
        CHECK(small_wall::same(together[i], dem::push(a.model, walls[i], a.plan, o)));
}

TEST_CASE(
    "ensemble: a wall that starts anew with half the step leaves its neighbours as they are",
    "[dem][ensemble]")
{
    const Alone& a = alone();
    std::vector<double> residuals;
    for (const PushResult& r : a.results) residuals.push_back(r.residual);
    std::nth_element(residuals.begin(), residuals.begin() + kWalls / 2, residuals.end());
    dem::SolverOptions o = a.options;
    o.energy_tolerance = residuals[kWalls / 2];
    const auto together = pushed(a.walls, workers(1), o);
    int anew = 0;
    for (std::size_t i = 0; i < kWalls; ++i) {
        INFO("wall " << i);
        anew += together[i].step_reductions > 0;
        if (a.results[i].slowdowns == 0) // else a push of which no residual is left came first
            CHECK((together[i].step_reductions > 0) ==
                  (a.results[i].residual > o.energy_tolerance));
        CHECK(small_wall::same(together[i], dem::push(a.model, a.walls[i], a.plan, o)));
    }
    CHECK(anew > 0);
}

TEST_CASE("ensemble: a sink takes the snapshots of each wall under its number, from any thread",
          "[dem][ensemble]")
{
    const Alone& a = alone();
    const auto [threads, scalar] =
        GENERATE(std::pair{1, false}, std::pair{3, false}, std::pair{3, true});
    std::vector<std::vector<dem::Snapshot>> taken(kWalls);
    dem::PushPlan plan = a.plan;
    plan.sink = {
        .take = [&](std::size_t wall,
                    dem::Snapshot&& shot) { taken.at(wall).push_back(std::move(shot)); },
        .forget = [&](std::size_t wall) { taken.at(wall).clear(); }};
    dem::Ensemble e;
    e.size = kWalls;
    e.wall = [&](std::size_t i) { return a.walls.at(i); };
    e.done = [&](std::size_t i, PushResult&& r) {
        CHECK(r.snapshots.empty());
        r.snapshots = taken.at(i);
        CHECK(small_wall::same(r, a.results[i]));
    };
    dem::push_ensemble(a.model, e, plan, a.options, workers(threads, scalar));
    for (const auto& shots : taken) CHECK(shots.size() == 4); // every 1 mm of 3 mm
}

TEST_CASE("ensemble: a wall's own vertical stress is that of a model with this stress",
          "[dem][ensemble]")
{
    for (const double stress : {0.15e6, 1.25e6, 0.0}) {
        WallMaterials w = alone().walls[0];
        w.vertical_stress = stress;
        const PushResult with_own = pushed({alone().walls[0], w}, workers(1)).back();
        scenes::Scene s = small_wall::scene();
        s.loads.vertical_stress = stress;
        w.vertical_stress.reset();
        const PushResult of_model =
            dem::push(small_wall::model(s), w, alone().plan, alone().options);
        CHECK(small_wall::same(with_own, of_model));
    }
}

TEST_CASE("ensemble: a wall that fails says so and changes no bit of its neighbours",
          "[dem][ensemble]")
{
    const Alone& a = alone();
    const double infinite = std::numeric_limits<double>::infinity();
    std::vector<WallMaterials> walls = a.walls;
    const std::vector<std::size_t> broken{0, 2, 5};
    walls[0].stone.young_modulus = infinite;
    walls[2].cracks[2].ks = infinite;
    walls[5].stone.density = infinite;
    for (const int threads : {1, 2}) {
        const auto together = pushed(walls, workers(threads));
        for (std::size_t i = 0; i < walls.size(); ++i) {
            INFO("wall " << i);
            if (std::find(broken.begin(), broken.end(), i) == broken.end())
                CHECK(small_wall::same(together[i], a.results[i]));
            else
                CHECK(dem::failed(together[i].outcome));
        }
    }
}

TEST_CASE("ensemble: what wall() or done() throw reaches the caller and stops the run",
          "[dem][ensemble]")
{
    const int threads = GENERATE(1, 2);
    const int most = threads * static_cast<int>(kLanes);
    const std::size_t many = 100 * kLanes;
    SECTION("wall()")
    {
        Counted c(many);
        c.ensemble.wall = [&](std::size_t i) {
            ++c.asked;
            if (i == 5) throw std::runtime_error("no wall 5");
            return alone().walls[0];
        };
        CHECK_THROWS_WITH(c.run(threads), "no wall 5");
        CHECK(c.asked < static_cast<int>(many)); // other threads go on until they hear of it
    }
    SECTION("done()")
    {
        const int enough = 5 * most + 1; // all threads are at work
        Counted c(many);
        c.ensemble.done = [&](std::size_t, PushResult&&) {
            if (++c.came == enough) throw std::runtime_error("full");
        };
        CHECK_THROWS_WITH(c.run(threads), "full");
        CHECK(c.came == enough); // nothing is delivered after it
        CHECK(c.asked <= enough + 2 * most);
    }
}

TEST_CASE(
    "ensemble: nothing is delivered after done() threw, though results wait for their turn",
    "[dem][ensemble]")
{
    for (int repeat = 0; repeat < 20; ++repeat) {
        Counted c(100);
        c.ensemble.done = [&](std::size_t, PushResult&&) {
            ++c.came;
            std::this_thread::sleep_for(std::chrono::milliseconds(5)); // others queue meanwhile
            throw std::runtime_error("full");
        };
        CHECK_THROWS_WITH(c.run(8), "full");
        CHECK(c.came == 1);
    }
}

TEST_CASE("ensemble: materials that fit no wall are refused", "[dem][ensemble]")
{
    Counted c(3 * kLanes);
    c.ensemble.wall = [&](std::size_t i) {
        WallMaterials w = alone().walls[0];
        if (i == kLanes) w.joints[3].ks = -1.0;
        return w;
    };
    CHECK_THROWS_AS(c.run(1), std::invalid_argument);
    CHECK_THROWS_AS(c.run(2), std::invalid_argument);
}

TEST_CASE("ensemble: a plan that cannot be is refused before any wall is asked for",
          "[dem][ensemble]")
{
    Counted c(4);
    dem::PushPlan plan;
    plan.record_every = 0.0;
    CHECK_THROWS_AS(dem::push_ensemble(alone().model, c.ensemble, plan), std::invalid_argument);
    CHECK(c.asked == 0);
}

TEST_CASE("ensemble: of no walls it asks for none and returns", "[dem][ensemble]")
{
    Counted c(0);
    c.run(GENERATE(1, 3));
    CHECK(c.asked == 0);
    CHECK(c.came == 0);
}
