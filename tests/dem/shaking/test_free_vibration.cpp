/// When the free vibration of a wall that was shaken is over.

#include "dem/shaking/free_vibration.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>
#include <utility>

namespace {

constexpr double kBorne = 1e-4; // [m]

struct Motion {
    const char* name;
    double swing;           ///< from side to side, over what is borne [-]
    double shift;           ///< of the middle in a window, over what is borne [-]
    int windows;            ///< until it is quiet; 0: it never is
    double frequency = 7.0; ///< [Hz]
};

dem::ShakingClock clock_with(double free_vibration)
{
    dem::ShakePlan plan;
    plan.step = 0.01;
    plan.horizontal.assign(101, 0.0);
    plan.free_vibration = free_vibration;
    return dem::shaking_clock(plan, 1e-3);
}

/// Windows until the wall is quiet, and the mean of the top in the last one [m].
std::pair<int, double> quiet_after(const Motion& motion, double borne, double longest = 5.0)
{
    dem::ShakingClock clock = clock_with(longest);
    dem::FreeVibration top(clock);
    const long long window = std::llround(1.0 / clock.dt);
    for (; clock.step < clock.last; ++clock.step) {
        const double time = clock.time() - 1.0; // since the record has ended [s]
        const double at =
            0.5 * motion.swing * std::sin(2.0 * std::numbers::pi * motion.frequency * time) +
            motion.shift * time;
        top.add(clock, kBorne * at);
        if (top.quiet(clock, borne))
            return {static_cast<int>((clock.step - clock.record) / window), top.mean()};
    }
    return {0, top.mean()};
}

} // namespace

TEST_CASE("free vibration: it is over where the top rests, or swings a little about one place",
          "[dem][shaking][free_vibration]")
{
    const auto m = GENERATE(values<Motion>({{"stands", 0.0, 0.0, 1},
                                            {"rests", 0.9, 0.0, 1},
                                            {"swings a little", 19.0, 0.0, 2},
                                            {"swings", 21.0, 0.0, 0},
                                            {"swings a little and creeps", 19.0, 0.29, 2},
                                            {"swings a little and moves", 19.0, 0.32, 0}}));
    INFO(m.name);
    const auto [windows, mean] = quiet_after(m, kBorne);
    CHECK(windows == m.windows);
    const double middle = (windows > 0 ? windows : 5) - 0.5; // of the last window [s]
    CHECK(mean == Approx(kBorne * m.shift * middle).margin(0.02 * kBorne));
    CHECK(quiet_after(m, 0.0).first == 0);
}

TEST_CASE("free vibration: it is looked at after the record alone",
          "[dem][shaking][free_vibration]")
{
    const dem::ShakingClock clock = clock_with(5.0);
    dem::FreeVibration top(clock);
    dem::ShakingClock early = clock;
    for (; early.step < clock.record; ++early.step) {
        top.add(early, 1.0);
        CHECK_FALSE(top.any());
        if (top.any()) break;
    }
    CHECK(early.time() == Approx(1.0));
    top.add(early, 2.0);
    CHECK(top.mean() == 2.0);
}

TEST_CASE("free vibration: its windows last a second, and a fifth of a short one",
          "[dem][shaking][free_vibration]")
{
    for (const auto& [most, window] :
         {std::pair{2.0, 0.4}, {5.0, 1.0}, {5.4, 1.08}, {30.0, 1.0}}) {
        INFO(most);
        dem::ShakingClock clock = clock_with(most);
        dem::FreeVibration top(clock);
        for (clock.step = clock.record; clock.step < clock.last; ++clock.step) {
            top.add(clock, 0.0);
            if (top.quiet(clock, kBorne)) break;
        }
        CHECK(clock.time() - 1.0 == Approx(window).margin(2e-3));
    }
}

TEST_CASE("free vibration: a longer look tells the place about which the top swings more",
          "[dem][shaking][free_vibration]")
{
    const auto m = GENERATE(values<Motion>({{"swings a little", 19.0, 0.0, 2},
                                            {"swings", 21.0, 0.0, 6},
                                            {"swings more", 99.0, 0.0, 6},
                                            {"swings much", 101.0, 0.0, 0},
                                            {"swings and creeps", 99.0, 0.09, 6},
                                            {"swings and moves", 99.0, 0.11, 0},
                                            {"swings slowly", 99.0, 0.0, 0, 0.6}}));
    INFO(m.name);
    const auto [windows, mean] = quiet_after(m, kBorne, 30.0);
    CHECK(windows == m.windows);
    const double middle = m.windows - (m.windows > 2 ? 1.5 : 0.5); // of the last windows [s]
    if (windows > 0) CHECK(mean == Approx(kBorne * m.shift * middle).margin(0.02 * kBorne));
}
