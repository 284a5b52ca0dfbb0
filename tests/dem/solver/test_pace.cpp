#include "dem/solver/pace.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

namespace {

constexpr double kForce = 50e3;     // [N]
constexpr double kStiffness = 20e6; // [N/m]
constexpr double kMass = 20e9;      // [N step2/m], swings in some 200 steps

dem::SolverOptions with_accuracy(double accuracy)
{
    dem::SolverOptions o;
    o.accuracy = accuracy;
    return o;
}

double fastest(const dem::SolverOptions& o) { return 1e-3 / o.steps_per_mm; }

/// A wall that is pushed: what it does in a step is set from outside.
struct Wall {
    /// @param way of the whole push [m]
    explicit Wall(const dem::SolverOptions& options, double stiffness = kStiffness,
                  double way = 1.0)
        : pace(options)
    {
        speed = pace.begin({stiffness, stiffness > 0.0 ? kMass : 0.0, kForce, 0.0, way});
        felt.force = kForce;
    }

    void step()
    {
        speed = pace.next(speed);
        felt.way = speed;
        felt.damping += (drag + viscosity * speed) * speed;
        felt.fracture += fracture * speed;
        window.way += speed;
        ++window.steps;
        if (!pace.ends_window()) return pace.feel(felt, {});
        const double mean = window.way / window.steps, kinetic = 0.5 * mass * mean * mean;
        window = {};
        pace.feel(felt, {kinetic, kinetic});
    }

    void go(int steps)
    {
        for (int i = 0; i < steps; ++i) step();
    }

    dem::Pace pace;
    double speed = 0.0;
    double mass = kMass;
    double drag = 0.0;      ///< damping per displacement [N]
    double viscosity = 0.0; ///< of it, per speed [N step/m]
    double fracture = 0.0;  ///< energy per displacement [N]
    dem::Felt felt;
    struct {
        double way = 0.0;
        int steps = 0;
    } window; ///< of which the kinetic energy is the mean
};

} // namespace

TEST_CASE("pace: the inertia of a wall that gets faster is within the accuracy", "[dem][pace]")
{
    const double accuracy = GENERATE(0.001, 0.01, 0.1);
    const dem::SolverOptions o = with_accuracy(accuracy);
    Wall wall(o);
    wall.go(1000); // the force is known
    wall.speed = 0.0;
    double most = 0.0;
    for (int i = 0; i < 20000; ++i) {
        const double before = wall.speed;
        wall.step();
        most = std::max(most, (wall.speed - before) * kMass);
    }
    CHECK(wall.speed == Approx(fastest(o)));
    CHECK(most < accuracy * kForce);
    CHECK(most >
          0.05 * std::min(accuracy * kForce, fastest(o) * kMass)); // not for nothing slow
}

TEST_CASE("pace: more of a wall that moves gets faster as much more slowly", "[dem][pace]")
{
    const auto gained = [](double mass) {
        Wall wall(with_accuracy(0.001));
        wall.mass = mass;
        wall.go(1000);
        wall.speed = 0.0;
        wall.step();
        return wall.speed;
    };
    CHECK(gained(4.0 * kMass) == Approx(0.25 * gained(kMass)).epsilon(0.01));
    CHECK(gained(0.1 * kMass) == gained(kMass)); // at least as elastic as it was
}

TEST_CASE("pace: it brakes as softly as it starts, and stops where it is to", "[dem][pace]")
{
    const dem::SolverOptions o = with_accuracy(0.001);
    Wall wall(o);
    wall.go(5000);
    double left = 20e-3, speed = wall.speed, hardest = 0.0;
    const double gain = wall.pace.next(0.0);
    int steps = 0;
    while (left > 0.0 && ++steps < 1'000'000) {
        const double before = speed;
        speed = std::min(speed, wall.pace.stopping_within(left));
        hardest = std::max(hardest, before - speed);
        left -= speed;
    }
    CHECK(left <= 0.0);
    CHECK(speed <= 2.0 * gain);
    CHECK(hardest <= 2.0 * gain);
}

TEST_CASE("pace: it goes so fast that damping takes its share, and no faster than the fastest",
          "[dem][pace]")
{
    const auto speed_at = [](double accuracy, double viscosity) {
        Wall wall(with_accuracy(accuracy));
        wall.viscosity = viscosity;
        wall.go(20000);
        CHECK(viscosity * wall.speed < accuracy * kForce); // [N] that the drive takes more
        return wall.speed;
    };
    const double cap = fastest({});
    CHECK(speed_at(0.01, 0.0) == Approx(cap));
    CHECK(speed_at(0.01, 1e-3 * kForce / cap) == Approx(cap));
    const double slow = speed_at(0.01, 0.03 * kForce / cap);
    CHECK(slow > 0.05 * cap); // all of the accuracy would let it go at 0.33
    CHECK(speed_at(0.02, 0.03 * kForce / cap) == Approx(2.0 * slow).epsilon(0.01));
}

TEST_CASE(
    "pace: the slowest cruise gives the first 30 mm 4000 steps over the accuracy, and each "
    "e-fold of the way after them as many",
    "[dem][pace]")
{
    constexpr double kFirst = 0.03, kMost = 4000.0 / 0.05; // [m], [steps]
    Wall wall(with_accuracy(0.05), 0.0);                   // no stiffness: only the way counts
    wall.drag = kForce;
    double way = 0.0, steps = 0.0, start = 0.0, first = 0.0;
    while (way < 4.0 * kFirst && steps < 1e6) {
        wall.step();
        way += wall.speed;
        ++steps;
        if (way <= 0.1 * kFirst) start = steps; // by then it has got its speed
        if (way <= kFirst) first = steps;
    }
    CHECK(first - start == Approx(0.9 * kMost).epsilon(0.01));
    CHECK(steps - first == Approx(std::log(4.0) * kMost).epsilon(0.01));
}

TEST_CASE("pace: the slowest cruise gives a short push a quarter of the steps of a long one",
          "[dem][pace]")
{
    constexpr double kWay = 0.002, kMost = 4000.0 / 0.05; // [m], [steps]
    Wall wall(with_accuracy(0.05), 0.0, kWay);
    wall.drag = kForce;
    double way = 0.0, steps = 0.0, start = 0.0;
    while (way < kWay && steps < 1e6) {
        wall.step();
        way += wall.speed;
        ++steps;
        if (way <= 0.5 * kWay) start = steps;
    }
    CHECK(steps - start == Approx(0.5 * 0.25 * kMost).epsilon(0.01));
}

TEST_CASE("pace: it gets its speed back once damping takes less", "[dem][pace]")
{
    Wall wall(with_accuracy(0.01));
    wall.viscosity = 0.03 * kForce / fastest({});
    wall.go(20000);
    REQUIRE(wall.speed < 0.33 * fastest({}));
    wall.viscosity = 0.0;
    wall.go(20000);
    CHECK(wall.speed == Approx(fastest({})));
}

TEST_CASE("pace: what damping takes while something breaks does not slow it", "[dem][pace]")
{
    const auto speed = [](double fracture) {
        Wall wall(with_accuracy(0.01));
        wall.go(5000);
        wall.drag = 0.2 * kForce;
        wall.fracture = fracture;
        wall.go(1000);
        return wall.speed;
    };
    CHECK(speed(0.0) < 0.1 * fastest({}));
    CHECK(speed(0.001 * kForce) == speed(0.0)); // hardly anything breaks
    CHECK(speed(0.1 * kForce) == Approx(fastest({})));
}

TEST_CASE("pace: a force that changes much within a period of the wall slows it, the more the "
          "less error is borne",
          "[dem][pace]")
{
    const double period = 2.0 * std::acos(-1.0) * std::sqrt(kMass / kStiffness); // [steps]
    const double way = 2.0 * period * fastest({}); // on which it rises, or falls
    const auto mean_speed = [&](double accuracy, double swing) {
        Wall wall(with_accuracy(accuracy));
        double at = 0.0;
        const auto go = [&](int steps) {
            for (int i = 0; i < steps; ++i) {
                wall.step();
                at += wall.speed;
                const double ways = at / way;
                const double share = std::abs(ways - 2.0 * std::round(0.5 * ways)); // 0 to 1
                wall.felt.force = kForce * (1.0 - swing * share);
            }
            return at;
        };
        const double before = go(20000);
        return (go(20000) - before) / 20000;
    };
    CHECK(mean_speed(0.01, 0.02) == Approx(fastest({})));
    const double fine = mean_speed(0.01, 1.0), coarse = mean_speed(0.04, 1.0);
    CHECK(fine < 0.5 * fastest({}));
    CHECK(coarse > 1.5 * fine);
}

TEST_CASE("pace: so many times out of balance, so many times slower, never below its slowest",
          "[dem][pace]")
{
    dem::SolverOptions o = with_accuracy(0.02);
    o.unbalance_limit = 0.25;
    o.min_speed = 0.05;
    const double allowed = 0.25 * 0.02 * kForce;
    const auto [unbalance, share] = GENERATE(table<double, double>(
        {{0.0, 1.0}, {0.99, 1.0}, {2.0, 0.5}, {10.0, 0.1}, {100.0, 0.05}, {1e6, 0.05}}));
    Wall wall(o);
    wall.go(5000);
    wall.felt.unbalance = unbalance * allowed;
    wall.go(3000); // past its smoothing
    CHECK(wall.speed == Approx(share * fastest(o)).epsilon(1e-6));
    CHECK(wall.pace.waits() == (unbalance > 20.0));
    wall.felt.unbalance = 0.0;
    wall.go(5000);
    CHECK(wall.speed == Approx(fastest(o)));
    CHECK_FALSE(wall.pace.waits());
}

TEST_CASE("pace: with an unbalance limit of 0 the speed is constant", "[dem][pace]")
{
    dem::SolverOptions o = with_accuracy(0.001);
    o.unbalance_limit = 0.0;
    o.steps_per_mm = 700;
    Wall wall(o);
    CHECK(wall.speed == fastest(o));
    wall.drag = kForce;
    wall.felt.unbalance = kForce;
    for (int i = 0; i < 2000; ++i) {
        wall.felt.force += 1e-2 * kForce;
        wall.step();
        REQUIRE(wall.speed == fastest(o));
    }
    CHECK_FALSE(wall.pace.waits());
}

TEST_CASE("pace: a wall whose stiffness is not known starts from rest, and finds its speed",
          "[dem][pace]")
{
    const dem::SolverOptions o = with_accuracy(0.01);
    Wall wall(o, 0.0);
    CHECK(wall.speed == 0.0);
    wall.step();
    CHECK(wall.speed > 0.0);
    CHECK(wall.speed < 1e-2 * fastest(o));
    wall.go(100000);
    CHECK(wall.speed == Approx(fastest(o)));
}
