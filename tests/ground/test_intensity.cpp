#include "ground/intensity.hpp"
#include "ground/motion_facts.hpp"
#include "ground/pulse.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>

namespace {

constexpr double kG = 9.80665, kPi = std::numbers::pi;

ground::GroundMotion sine(double cycles)
{
    return ground::pulse("sine(peak 1 m/s2, period 1 s, step 0.0005 s, cycles " +
                         std::to_string(cycles) + ")");
}

} // namespace

TEST_CASE("intensity: Arias, CAV and duration of a sine have closed forms",
          "[ground][intensity]")
{
    const auto m = sine(10.0);
    CHECK(ground::arias_intensity(m) == Approx(kPi / (2.0 * kG) * 0.5 * 10.0).epsilon(1e-6));
    CHECK(ground::cumulative_absolute_velocity(m) == Approx(10.0 * 2.0 / kPi).epsilon(1e-6));
    CHECK(ground::significant_duration(m, 0.05, 0.95) == Approx(9.0).epsilon(1e-6));
    CHECK(ground::significant_duration(ground::scaled(m, 7.0), 0.05, 0.95) ==
          Approx(ground::significant_duration(m, 0.05, 0.95)).epsilon(1e-9));
}

TEST_CASE("intensity: resonance without damping grows by pi for each cycle, with damping to 1 "
          "/ (2 zeta)",
          "[ground][intensity]")
{
    // from rest at resonance: u = (sin w t - w t cos w t) / (2 w^2), whose extremes after n
    // cycles are n pi / w^2
    CHECK(ground::spectral_acceleration(sine(5.0), 1.0, 0.0) ==
          Approx(5.0 * kPi).epsilon(1e-4));
    CHECK(ground::spectral_acceleration(sine(60.0), 1.0, 0.05) == Approx(10.0).epsilon(2e-3));
    // a stiff one follows the ground
    CHECK(ground::spectral_acceleration(sine(5.0), 0.01, 0.05) == Approx(1.0).epsilon(1e-3));
}

TEST_CASE("intensity: coarse samples give the spectrum of the line through them",
          "[ground][intensity]")
{
    const ground::GroundMotion coarse{"", 0.1, {0.0, 1.0, -2.0, 0.5, 0.0, 0.0, 0.0}};
    ground::GroundMotion fine{"", 0.001, {}};
    for (int i = 0; i <= 600; ++i) {
        const int k = std::min(i / 100, 5);
        const double share = 0.01 * (i - 100 * k);
        fine.acceleration.push_back(coarse.acceleration[k] * (1.0 - share) +
                                    coarse.acceleration[k + 1] * share);
    }
    for (const double period : {0.1, 0.3, 1.0})
        CHECK(ground::spectral_acceleration(coarse, period) ==
              Approx(ground::spectral_acceleration(fine, period)).epsilon(3e-3));
}

TEST_CASE("intensity: the average spectrum is the geometric mean of ten", "[ground][intensity]")
{
    const auto m = sine(3.0);
    double product = 1.0;
    for (int i = 0; i < 10; ++i)
        product *= ground::spectral_acceleration(m, 0.5 * (0.2 + 1.3 * i / 9.0));
    CHECK(ground::average_spectral_acceleration(m, 0.5) ==
          Approx(std::pow(product, 0.1)).epsilon(1e-12));
}

TEST_CASE("intensity: FIV3 sums three increments of velocity, and takes the larger side",
          "[ground][intensity]")
{
    // Slow against the filter: of a half sine of 8 s the largest increment over 0.7 s is 0.7 s
    // times its peak, the only maximum.
    const auto hump = ground::pulse("half_sine(peak 1 m/s2, duration 8 s)");
    const double one = 8.0 / kPi * 2.0 * std::sin(kPi * 0.35 / 8.0);
    CHECK(ground::filtered_incremental_velocity(hump, 1.0) == Approx(one).epsilon(2e-3));
    CHECK(ground::filtered_incremental_velocity(ground::scaled(hump, -2.0), 1.0) ==
          Approx(2.0 * one).epsilon(2e-3));
    // The three largest of many equal humps count.
    const auto many = ground::pulse("sine(peak 1 m/s2, period 16 s, cycles 6)");
    CHECK(ground::filtered_incremental_velocity(many, 1.0) == Approx(3.0 * one).epsilon(2e-3));
}

TEST_CASE("intensity: rocking measures are 1 where a block starts to rock",
          "[ground][intensity]")
{
    const ground::RockingBlock block{0.25, 1.0};
    const auto m = ground::pulse("half_sine(peak 0.25 g, duration 1 s)");
    CHECK(ground::rocking_pga(m, block) == Approx(1.0).epsilon(1e-12));
    CHECK(ground::intensity(m, ground::parse_measure("rocking_pga(0.25 m, 1 m)")) ==
          ground::rocking_pga(m, block));
    CHECK(ground::intensity(m, ground::parse_measure("rocking_pgv(0.25 m, 1 m)")) ==
          ground::rocking_pgv(m, block));
    const double p = std::sqrt(0.75 * kG / std::hypot(0.25, 1.0));
    CHECK(ground::rocking_pgv(m, block) ==
          Approx(motion_facts(m).pgv * p / (0.25 * kG)).epsilon(1e-12));
}

TEST_CASE("intensity: measures are read by name and written back", "[ground][intensity]")
{
    using Catch::Matchers::Contains;
    for (const char* const text :
         {"pga", "pgv", "pgd", "sa(0.3 s)", "avg_sa(1.5 s)", "fiv3(0.25 s)", "cav", "arias",
          "d5_95", "rocking_pga(0.5 m, 1.1 m)", "rocking_pgv(0.25 m, 2 m)"})
        CHECK(ground::measure_text(ground::parse_measure(text)) == text);
    CHECK(ground::parse_measure("sa( period 300 ms )") ==
          ground::Measure{.kind = ground::MeasureKind::sa, .period = 0.3});
    CHECK(ground::parse_measure("rocking_pgv(half_width 50 cm, half_height 1.1 m)") ==
          ground::Measure{.kind = ground::MeasureKind::rocking_pgv, .block = {0.5, 1.1}});
    CHECK_THROWS_WITH(ground::parse_measure("rocking_pga"),
                      Contains("rocking_pga(0.5 m, 0.6 m)"));
    CHECK_THROWS_WITH(ground::parse_measure("rocking_pga(0.5 m)"), Contains("half the height"));
    CHECK_THROWS_WITH(ground::parse_measure("rocking_pga(0.5 m, 0 m)"),
                      Contains("[0.01, 100] m"));
    CHECK_THROWS_WITH(ground::parse_measure("rocking_pga(0.5 s, 1 m)"),
                      Contains("m or cm or mm"));
    CHECK_THROWS_WITH(ground::parse_measure("sa"), Contains("sa(0.3 s)"));
    CHECK_THROWS_WITH(ground::parse_measure("sa(0)"), Contains("write s or ms"));
    CHECK_THROWS_WITH(ground::parse_measure("sa(99 s)"), Contains("needs a period"));
    CHECK_THROWS_WITH(ground::parse_measure("pga(1 s)"), Contains("takes no period"));
    CHECK_THROWS_WITH(ground::parse_measure("pda"), Contains("is no measure"));
}
