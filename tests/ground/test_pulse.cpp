#include "ground/motion_facts.hpp"
#include "ground/pulse.hpp"

#include <catch2/catch.hpp>

#include <numbers>
#include <string>

namespace {
constexpr double kG = 9.80665, kPi = std::numbers::pi;
}

TEST_CASE("pulse: a half sine has its peak, its duration, and a last velocity of 2 A D / pi",
          "[ground][pulse]")
{
    const auto f = motion_facts(ground::pulse("half_sine(peak 0.5 g, duration 0.3 s)"));
    CHECK(f.pga == Approx(0.5 * kG).epsilon(1e-12));
    CHECK(f.duration == Approx(0.3).epsilon(1e-12));
    CHECK(f.final_velocity == Approx(2.0 * 0.5 * kG * 0.3 / kPi).epsilon(1e-5));
}

TEST_CASE("pulse: whole cycles of sine and cosine end at rest", "[ground][pulse]")
{
    const auto s = motion_facts(ground::pulse("sine(peak 2 m/s2, period 0.5 s, cycles 3)"));
    CHECK(s.duration == Approx(1.5));
    CHECK(s.pgv == Approx(2.0 * 2.0 * 0.5 / (2.0 * kPi)).epsilon(1e-4)); // A T / pi
    CHECK(std::abs(s.final_velocity) < 1e-12);
    const auto c = motion_facts(ground::pulse("cosine(peak 2 m/s2, period 0.5 s)"));
    CHECK(c.pgv == Approx(2.0 * 0.5 / (2.0 * kPi)).epsilon(1e-4));
    CHECK(std::abs(c.final_displacement) < 1e-4 * c.pgd);
}

TEST_CASE("pulse: a Ricker wavelet ends at rest where it began", "[ground][pulse]")
{
    const auto f = motion_facts(ground::pulse("ricker(peak 0.5 g, period 0.6 s)"));
    CHECK(f.pga == Approx(0.5 * kG).epsilon(1e-12));
    // v = A (t - t0) exp(-s^2), largest at s^2 = 1/2: A T / pi / sqrt(2 e)
    CHECK(f.pgv ==
          Approx(0.5 * kG * 0.6 / kPi / std::sqrt(2.0 * std::numbers::e)).epsilon(1e-4));
    CHECK(std::abs(f.final_velocity) < 1e-6 * f.pgv);
    CHECK(std::abs(f.final_displacement) < 1e-5 * f.pgd);
}

TEST_CASE("pulse: the velocity of Mavroeidis and Papageorgiou comes back by integration",
          "[ground][pulse]")
{
    const double phase = GENERATE(0.0, 90.0);
    const auto m = ground::pulse(
        "mavroeidis_papageorgiou(velocity 0.5 m/s, period 0.8 s, cycles 1.7, phase " +
        std::to_string(phase) + " deg)");
    const auto velocity = integrated(m).velocity;
    const double w = 2.0 * kPi / 0.8, c = 1.7;
    for (std::size_t i = 0; i < velocity.size(); i += 37) {
        const double t = m.step * static_cast<double>(i) - 0.5 * c * 0.8;
        const double wanted =
            0.25 * (1.0 + std::cos(w * t / c)) * std::cos(w * t + phase * kPi / 180.0);
        CHECK(velocity[i] == Approx(wanted).margin(1e-4));
    }
    CHECK(std::abs(velocity.back()) < 1e-4);
}

TEST_CASE("pulse: names, missing, double, unknown and impossible values are refused",
          "[ground][pulse]")
{
    using Catch::Matchers::Contains;
    CHECK(ground::is_pulse("ricker(peak 1 g, period 1 s)"));
    CHECK_FALSE(ground::is_pulse("ricker.txt"));
    CHECK_FALSE(ground::is_pulse("walls (2).at2"));
    CHECK_THROWS_WITH(ground::pulse("step(peak 1 g)"),
                      Contains("is no pulse; these are half_sine"));
    CHECK_THROWS_WITH(ground::pulse("half_sine(peak 1 g)"), Contains("missing duration"));
    CHECK_THROWS_WITH(ground::pulse("half_sine(peak 1 g, peak 1 g, duration 1 s)"),
                      Contains("unknown or given twice"));
    CHECK_THROWS_WITH(ground::pulse("half_sine(peak 1 g, duration 1 s, phase 1 deg)"),
                      Contains("unknown"));
    CHECK_THROWS_WITH(ground::pulse("half_sine(peak 1 g, duration 0 s)"),
                      Contains("out of range"));
    CHECK_THROWS_WITH(
        ground::pulse("sine(peak 1 g, period 1000 s, cycles 1000, step 0.001 ms)"),
        Contains("more than ten million samples"));
}
