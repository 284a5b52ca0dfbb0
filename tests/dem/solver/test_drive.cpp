#include "dem/solver/drive.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace {

using dem::Drive;

/// [m/step]
double full_speed(const dem::SolverOptions& o) { return 1e-3 / o.steps_per_mm; }

/// A constant speed, so that nothing need be felt.
dem::SolverOptions options(long long steps = 4000)
{
    dem::SolverOptions o;
    o.unbalance_limit = 0.0;
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
        d.settle([] { return true; });
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

/// Steps of the load line to the end of the way.
std::vector<double> steps_of(Drive& d)
{
    std::vector<double> steps;
    while (!d.finished()) steps.push_back(d.advance());
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
        d.settle([] { return false; });
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
    bool at_rest = false;
    while (d.settling()) {
        CHECK(d.advance() == 0.0);
        CHECK(d.position() == 0.0);
        CHECK_FALSE(d.finished());
        d.settle([&] {
            ++asked;
            return at_rest;
        });
        if (++steps == 210) at_rest = true;
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
        d.settle([] { return false; });
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

TEST_CASE("drive: takes the steps asked for where the speed is constant", "[dem][drive]")
{
    const long long steps = GENERATE(2000, 20000);
    Drive d = settled({0.03}, options(steps));
    CHECK(std::abs(static_cast<double>(steps_of(d).size()) - static_cast<double>(steps)) <=
          1.0);
}

TEST_CASE("drive: brakes softly before each turn, but not at the end of a push one way",
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
            CHECK(step < 0.1 * full);
            before = 0.0;
            continue;
        }
        CHECK(before - step <= 0.1 * full + 0.04 * before); // lands on zero
        before = step;
    }
    CHECK(turns == 2);
    CHECK(before < 0.1 * full); // the end of a push that turns back is one of its turns
    Drive one_way = settled({0.01}, o);
    const std::vector<double> steps = steps_of(one_way);
    CHECK(steps[steps.size() - 2] == Approx(full).epsilon(1e-9));
}

TEST_CASE("drive: starts softly, and again after each turn", "[dem][drive]")
{
    dem::SolverOptions o = options();
    o.unbalance_limit = 0.5;
    Drive d = settled({0.01, -0.01}, o);
    double before = 0.0;
    int starts = 0;
    for (const double step : steps_of(d)) {
        if (before * step <= 0.0) { // first step, or turned
            before = 0.0;
            ++starts;
        }
        CHECK(std::abs(step) - std::abs(before) <= 1e-3 * full_speed(o));
        before = step;
    }
    CHECK(starts == 2);
}

TEST_CASE("drive: is as fast at first as a wall that is set moving", "[dem][drive]")
{
    dem::SolverOptions o = options();
    o.unbalance_limit = 0.5;
    Drive d = settled({0.03}, o);
    const double speed = d.begin({20e6, 20e9, 50e3, 0.0}); // [N/m] [N step2/m] [N]
    CHECK(speed > 0.0);
    CHECK(d.advance() == Approx(speed).epsilon(0.05));
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
