#include "ground/motion_facts.hpp"
#include "ground/record.hpp"
#include "ground/stochastic_motion.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <complex>
#include <numbers>
#include <string>
#include <vector>

namespace {

using Catch::Matchers::Contains;

/// Power of a motion at a frequency.
double power_at(const ground::GroundMotion& m, double frequency)
{
    std::complex<double> sum = 0.0;
    for (std::size_t i = 0; i < m.acceleration.size(); ++i)
        sum += m.acceleration[i] * std::polar(1.0, -2.0 * std::numbers::pi * frequency *
                                                       m.step * static_cast<double>(i));
    return std::norm(sum);
}

} // namespace

TEST_CASE(
    "stochastic motion: the same numbers give the same bits, another record another motion",
    "[ground][stochastic]")
{
    ground::KanaiTajimi k;
    k.duration = 5.0;
    k.rise = 0.5;
    k.strong = 2.0;
    const auto first = kanai_tajimi(k), again = kanai_tajimi(k);
    CHECK(first.acceleration == again.acceleration);
    k.record = 2;
    CHECK(kanai_tajimi(k).acceleration != first.acceleration);
    k.record = 1;
    k.seed = 2;
    CHECK(kanai_tajimi(k).acceleration != first.acceleration);
}

TEST_CASE("stochastic motion: it has the peak that was asked for, and ends at rest",
          "[ground][stochastic]")
{
    const auto all = ground::stochastic_motions("kanai_tajimi(peak 0.3 g, records 5)");
    REQUIRE(all.size() == 5);
    for (const ground::GroundMotion& m : all) {
        const ground::MotionFacts f = motion_facts(m);
        CHECK(f.pga == Approx(0.3 * ground::kGravity).epsilon(1e-12));
        CHECK(std::abs(f.final_velocity) < 0.01 * f.pgv);
        CHECK(f.final_displacement == Approx(0.0).margin(0.1 * f.pgd));
    }
}

TEST_CASE("stochastic motion: its name gives it alone", "[ground][stochastic]")
{
    const auto all = ground::stochastic_motions(
        "kanai_tajimi(peak 0.25 g, frequency 3 Hz, duration 6 s, seed 7, records 3)");
    const auto alone = ground::stochastic_motions(all[2].name);
    REQUIRE(alone.size() == 1);
    CHECK(alone[0].acceleration == all[2].acceleration);
}

TEST_CASE("stochastic motion: the power follows the filter of the soil", "[ground][stochastic]")
{
    // |H|^2 = (1 + (2 z r)^2) / ((1 - r^2)^2 + (2 z r)^2) at r = 1 and 3, times that of noise
    // that is linear between its samples, sinc^4.
    const double soil = 2.5, far = 7.5, z = 0.6, step = 0.01;
    const auto filter = [&](double f) {
        const double r = f / soil, c = 4.0 * z * z * r * r, x = std::numbers::pi * f * step;
        return (1.0 + c) / ((1.0 - r * r) * (1.0 - r * r) + c) * std::pow(std::sin(x) / x, 4);
    };
    double near_sum = 0.0, far_sum = 0.0;
    for (const auto& m : ground::stochastic_motions("kanai_tajimi(peak 1 g, records 60)"))
        for (int i = -4; i <= 4; ++i) { // twenty times as far apart as the record tells apart
            near_sum += power_at(m, soil + 0.05 * i) / filter(soil + 0.05 * i);
            far_sum += power_at(m, far + 0.05 * i) / filter(far + 0.05 * i);
        }
    CHECK(near_sum / far_sum == Approx(1.0).epsilon(0.15));
}

TEST_CASE("stochastic motion: bad texts are refused with a remedy", "[ground][stochastic]")
{
    struct Case {
        std::string text, says;
    };
    const auto c = GENERATE(values<Case>(
        {{"kanai_tajimi(duration 5 s)", "missing peak; write it as in"},
         {"kanai_tajimi(peak 0.3 g, record 1, records 5)", "not both"},
         {"kanai_tajimi(peak 0.3 g, seed 1.5)", "whole number"},
         {"kanai_tajimi(peak 0.3 g, rise 15 s, strong 10 s)", "shorter than the duration"},
         {"kanai_tajimi(peak 0.3 g, step 0.1 s)", "a tenth of the period"},
         {"kanai_tajimi(peak 0.3 g, colour 3)", "\"colour\" is unknown"}}));
    CHECK_THROWS_WITH(ground::stochastic_motions(c.text), Contains(c.says));
}
