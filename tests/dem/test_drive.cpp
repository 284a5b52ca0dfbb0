#include "dem/block/model.hpp"
#include "dem/solver/drive.hpp"
#include "dem/solver/drive_speed.hpp"
#include "dem/solver/push.hpp"
#include "scenes/paper_wall.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace {

using dem::Drive;

/// [m/step]
double full_speed(const dem::SolverOptions& o) { return 1e-3 / o.steps_per_mm; }

dem::SolverOptions options(long long steps = 4000)
{
    dem::SolverOptions o;
    o.steps_per_mm = static_cast<double>(steps) / 30.0; // on a way of 30 mm
    o.preload = dem::Preload::ramped;
    o.preload_steps = 400; // ramp of 100
    return o;
}

/// Past the vertical load at the first look after its ramp.
Drive settled(const std::vector<double>& targets, const dem::SolverOptions& o)
{
    Drive d(targets, o);
    while (d.settling()) {
        (void)d.advance();
        d.settle([] { return 0.0; });
    }
    return d;
}

double path_of(const std::vector<double>& targets)
{
    double path = 0.0, from = 0.0;
    for (const double to : targets) {
        path += std::abs(to - from);
        from = to;
    }
    return path;
}

/// Steps of the load line to the end of the way, in balance.
std::vector<double> steps_of(Drive& d)
{
    std::vector<double> steps;
    while (!d.finished()) {
        steps.push_back(d.advance());
        d.feel(0.0);
    }
    return steps;
}

const std::vector<double> kCycle = {0.003, -0.005, 0.008, 0.008, 1e-7 / 3, 0.0, 0.0113};

} // namespace

TEST_CASE("drive: the vertical load grows from 0 to 1 without a jerk, and stays",
          "[dem][drive]")
{
    Drive d({0.01}, options());
    std::vector<double> factor{0.0}; // before the first step
    for (int i = 0; i < 300; ++i) {
        factor.push_back(d.load_factor());
        (void)d.advance();
        d.settle([] { return 1.0; });
    }
    for (std::size_t i = 1; i < factor.size(); ++i) CHECK(factor[i] >= factor[i - 1]);
    CHECK(factor[1] > 0.0);
    CHECK(factor[99] < 1.0);
    CHECK(factor[100] == 1.0); // a quarter of the steps allowed
    CHECK(factor.back() == 1.0);
    for (std::size_t i = 1; i < factor.size(); ++i)
        CHECK(factor[i] - factor[i - 1] < 1.51 / 100);
    CHECK(factor[1] < 0.1 / 100); // flat at both ends
    CHECK(1.0 - factor[99] < 0.1 / 100);
    CHECK(settled({0.01}, options()).load_factor() == 1.0);
}

TEST_CASE("drive: the load line rests until the vertical load is carried", "[dem][drive]")
{
    Drive d({0.01}, options());
    int asked = 0, steps = 0;
    double unbalance = 1.0;
    while (d.settling()) {
        CHECK(d.advance() == 0.0);
        CHECK(d.position() == 0.0);
        CHECK_FALSE(d.finished());
        d.settle([&] {
            ++asked;
            return unbalance;
        });
        if (++steps == 210) unbalance = 0.99 * options().preload_unbalance;
    }
    CHECK(steps == 250); // looks every 50 steps, after the ramp
    CHECK(asked == 3);
    CHECK(d.advance() > 0.0);
}

TEST_CASE("drive: a wall that never comes to rest is pushed after the steps allowed",
          "[dem][drive]")
{
    Drive d({0.01}, options());
    long long steps = 0;
    while (d.settling() && steps < 1000) {
        (void)d.advance();
        ++steps;
        d.settle([] { return 1.0; });
    }
    CHECK(steps == options().preload_steps);
}

TEST_CASE("drive: visits the targets in order and exactly", "[dem][drive]")
{
    Drive d = settled(kCycle, options());
    std::size_t visited = 0;
    double position = 0.0;
    while (!d.finished()) {
        const double step = d.advance();
        CHECK(d.position() == Approx(position + step).margin(1e-18));
        const double from = visited > 0 ? kCycle[visited - 1] : 0.0;
        CHECK(d.position() >= std::min(from, kCycle[visited]));
        CHECK(d.position() <= std::max(from, kCycle[visited]));
        position = d.position();
        while (visited < kCycle.size() && position == kCycle[visited]) ++visited;
    }
    CHECK(visited == kCycle.size());
    CHECK(d.position() == kCycle.back());
}

TEST_CASE("drive: is never faster than full speed", "[dem][drive]")
{
    const auto targets = GENERATE(std::vector<double>{0.03}, std::vector<double>{-0.02});
    Drive d = settled(targets, options());
    const double full = full_speed(options());
    double fastest = 0.0;
    for (const double step : steps_of(d)) fastest = std::max(fastest, std::abs(step));
    CHECK(fastest <= full * (1 + 1e-10)); // positions of 1e-2 round steps of 1e-6
    CHECK(fastest == Approx(full).epsilon(1e-10));
}

TEST_CASE(
    "drive: goes faster where it has been before, slowly again before a turn and new ground",
    "[dem][drive]")
{
    const std::vector<double> at = {0.0, 0.02, -0.03, 0.015, 0.0};
    Drive d = settled({at.begin() + 1, at.end()}, options(30000));
    const double full = full_speed(options(30000));
    double fastest = 0.0, right = 0.0, left = 0.0;
    std::size_t way = 0;
    while (!d.finished()) {
        const double before = d.position(), step = std::abs(d.advance());
        const double to_turn = std::abs(before - at[way + 1]);
        CHECK(step <= full * (1 + 2.0 * to_turn / 6e-3) * (1 + 1e-10));
        if (before >= right || before <= left) CHECK(step <= full * (1 + 1e-10)); // new ground
        right = std::max(right, before);
        left = std::min(left, before);
        way += d.turned() ? 1 : 0;
        fastest = std::max(fastest, step);
    }
    CHECK(fastest == Approx(3.0 * full).epsilon(1e-6));
}

TEST_CASE("drive: tells where it turns and how far it is to the next turn", "[dem][drive]")
{
    Drive d = settled({0.01, 0.02, 0.02, -0.01, -0.02, 0.0}, options());
    CHECK(d.left() == Approx(0.02));
    std::vector<double> turns;
    while (!d.finished()) {
        const double before = d.left();
        const double step = std::abs(d.advance());
        if (d.turned())
            turns.push_back(d.position());
        else
            CHECK(d.left() == Approx(before - step).margin(1e-12));
    }
    CHECK(turns == std::vector<double>{0.02, -0.02});
    CHECK(d.left() == Approx(0.0).margin(1e-12));
}

TEST_CASE("drive: brakes before each turn as softly as it starts, but not at the end of a push "
          "one way",
          "[dem][drive]")
{
    const dem::SolverOptions o = options(30000);
    const double full = full_speed(o);
    Drive d = settled({0.01, -0.01, 0.005}, o);
    double before = 0.0;
    int turns = 0;
    while (!d.finished()) {
        const double step = std::abs(d.advance());
        if (d.turned()) {
            ++turns;
            CHECK(step < 2.0 * full / 500);
            before = 0.0;
            continue;
        }
        CHECK(before - step <= 2.0 * full / 500 + 0.04 * before); // lands on zero
        before = step;
    }
    CHECK(turns == 2);
    Drive one_way = settled({0.01}, o);
    const std::vector<double> steps = steps_of(one_way);
    CHECK(steps[steps.size() - 2] == Approx(full).epsilon(1e-9));
}

TEST_CASE("drive: goes slowly on the short ways of small cycles", "[dem][drive]")
{
    const double a = GENERATE(0.1e-3, 1e-3, 2e-3, 4e-3), way = 2.0 * a;
    const dem::SolverOptions o = options(300000);
    Drive d = settled({a, -a, a, -a, 0.0}, o);
    double fastest = 0.0;
    bool between = false;
    while (!d.finished()) {
        const double step = std::abs(d.advance());
        between = between || d.turned();
        if (between) fastest = std::max(fastest, step);
    }
    const double slower = std::clamp(way / 6e-3, 0.1, 1.0);
    CHECK(fastest <= full_speed(o) * slower * (1 + 2.0 * way / 6e-3) * (1 + 1e-6));
    CHECK(fastest > 0.8 * full_speed(o) * slower);
}

TEST_CASE("drive: a push that turns back steps on zero, and no step there is short",
          "[dem][drive]")
{
    Drive d = settled({0.0101, -0.00703, 0.013, -0.002}, options(GENERATE(4000, 30001)));
    double before = 0.0;
    int passed = 0;
    while (!d.finished()) {
        const double at = d.position(), step = d.advance();
        CHECK(at * d.position() >= 0.0);
        CHECK(d.passed_zero() == (at != 0.0 && d.position() == 0.0));
        if (d.passed_zero()) {
            ++passed;
            CHECK(step == Approx(before).epsilon(0.02));
        }
        CHECK(d.left_to_mark() <= d.left());
        before = step;
    }
    CHECK(passed == 3);
}

TEST_CASE("drive: starts softly, and again after each turn", "[dem][drive]")
{
    const std::vector<double> targets = {0.01, -0.01};
    Drive d = settled(targets, options());
    const double full = full_speed(options());
    double before = 0.0;
    int starts = 0;
    for (const double step : steps_of(d)) {
        if (before * step <= 0.0) { // first step, or turned
            before = 0.0;
            ++starts;
        }
        CHECK(std::abs(step) - std::abs(before) <= full / 500 * (1 + 1e-6));
        before = step;
    }
    CHECK(starts == 2);
}

TEST_CASE("drive: takes the steps asked for, and those of its starts", "[dem][drive]")
{
    const long long steps = GENERATE(2000, 20000);
    Drive d = settled({0.03}, options(steps));
    CHECK(std::abs(static_cast<double>(steps_of(d).size()) - (steps + 249.5)) <=
          1.0); // half of 500 to full speed
}

TEST_CASE("drive: its progress is the share of the way, back and forth", "[dem][drive]")
{
    Drive d = settled(kCycle, options());
    double way = 0.0, last = 0.0;
    CHECK(d.done() == 0.0);
    while (!d.finished()) {
        way += std::abs(d.advance());
        CHECK(d.done() >= last);
        CHECK(d.done() == Approx(way / path_of(kCycle)).epsilon(1e-9));
        last = d.done();
    }
    CHECK(d.done() == Approx(1.0).epsilon(1e-12));
}

TEST_CASE("drive: slows to limit / unbalance, never below its slowest speed", "[dem][drive]")
{
    dem::SolverOptions o = options();
    o.unbalance_limit = 0.004;
    o.min_speed = 0.05;
    const auto [unbalance, share] = GENERATE(table<double, double>(
        {{0.0, 1.0}, {0.0039, 1.0}, {0.008, 0.5}, {0.04, 0.1}, {0.4, 0.05}, {1e6, 0.05}}));
    Drive d = settled({0.03}, o);
    const double full = full_speed(o);
    double step = 0.0;
    for (int i = 0; i < 2500; ++i) { // past the start, and the smoothing over 50 steps
        step = d.advance();
        d.feel(unbalance);
    }
    REQUIRE_FALSE(d.finished());
    CHECK(step == Approx(share * full).epsilon(1e-9));
}

TEST_CASE(
    "drive: after the drop it goes so many times as fast and bears so many times the unbalance",
    "[dem][drive]")
{
    dem::SolverOptions o = options();
    o.steps_per_mm = 1000;
    o.haste_after_drop = 2.0;
    o.unbalance_limit = 0.004;
    o.min_speed = 0.05;
    const auto [unbalance, share] = GENERATE(table<double, double>(
        {{0.0, 2.0}, {0.0079, 2.0}, {0.016, 1.0}, {0.08, 0.2}, {8.0, 0.1}}));
    Drive d = settled({0.03}, o);
    d.after_drop(true);
    double step = 0.0;
    for (int i = 0; i < 2500; ++i) {
        step = d.advance();
        d.feel(unbalance);
    }
    REQUIRE_FALSE(d.finished());
    CHECK(step == Approx(share * full_speed(o)).epsilon(1e-9));
    CHECK(d.waits() == (unbalance > 1.0));
    d.after_drop(false); // the wall carries more again
    CHECK(d.advance() <= full_speed(o) * (1.0 + 1e-9));
}

TEST_CASE("drive: gets its speed back once the wall is in balance", "[dem][drive]")
{
    Drive d = settled({0.03}, options());
    for (int i = 0; i < 600; ++i) {
        (void)d.advance();
        d.feel(i < 550 ? 0.0 : 0.1);
    }
    CHECK(d.advance() < 0.5 * full_speed(options()));
    double step = 0.0;
    for (int i = 0; i < 1200; ++i) {
        step = d.advance();
        d.feel(0.0);
    }
    CHECK(step == Approx(full_speed(options())).epsilon(1e-9));
}

TEST_CASE("drive: with a limit of zero it never slows", "[dem][drive]")
{
    dem::SolverOptions o = options();
    o.unbalance_limit = 0.0;
    Drive d = settled({0.03}, o);
    for (int i = 0; i < 600; ++i) {
        (void)d.advance();
        d.feel(1.0);
    }
    CHECK(d.advance() == Approx(full_speed(o)).epsilon(1e-9));
}

TEST_CASE("drive: what it feels under vertical load does not slow the push", "[dem][drive]")
{
    Drive d({0.03}, options());
    while (d.settling()) {
        (void)d.advance();
        d.feel(1.0);
        d.settle([] { return 0.0; });
    }
    for (int i = 0; i < 600; ++i) (void)d.advance();
    CHECK(d.advance() == Approx(full_speed(options())).epsilon(1e-9));
}

TEST_CASE("drive: without a way to go it is done once the vertical load is carried",
          "[dem][drive]")
{
    const auto targets = GENERATE(std::vector<double>{}, std::vector<double>{0.0},
                                  std::vector<double>{0.0, 0.0});
    Drive d = settled(targets, options());
    CHECK(d.finished());
    CHECK(d.advance() == 0.0);
    CHECK(d.position() == 0.0);
    CHECK(d.done() == 1.0);
}

TEST_CASE("drive: the walls of the paper are pushed as fast as asked for, a stiff and slender "
          "one no faster "
          "than it can follow",
          "[dem][drive]")
{
    const dem::SolverOptions o;
    for (const double stress : {0.15, 0.50, 0.75, 1.00, 1.25}) {
        const scenes::Scene s = scenes::paper_wall(stress);
        const dem::Model m = scenes::model_of(s);
        CHECK(dem::steps_per_mm_of(m, scenes::uniform(s, m), o) == o.steps_per_mm);
    }
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
    CHECK(dem::steps_per_mm_of(m, scenes::uniform(s, m), o) > 2.0 * o.steps_per_mm);
    dem::PushPlan plan;
    plan.targets = {2e-3};
    const dem::PushResult r = dem::push(m, scenes::uniform(s, m), plan, o);
    const double limit =
        dem::vertical_load(m, scenes::uniform(s, m)) * s.wall.length / (2.0 * s.loads.height);
    INFO(scenes::peak_force(r) / limit);
    CHECK(scenes::peak_force(r) < 1.01 * limit);
}
