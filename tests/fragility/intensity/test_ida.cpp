#include "fragility/intensity/ida.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <vector>

using namespace fragility;

TEST_CASE("ida: the first crossing is interpolated, later ones do not count",
          "[fragility][ida]")
{
    const std::vector<IdaStep> steps = {
        {0.1, 0.2, false}, {0.2, 0.6, false}, {0.3, 0.1, false}, {0.4, 2.0, false}};
    const Observation o = ida_capacity(steps, 0.4);
    CHECK(o.lower == Approx(0.15));
    CHECK(o.lower == o.upper);
    CHECK(ida_capacity(steps, 0.1).lower == Approx(0.05)); // from rest
}

TEST_CASE("ida: a collapse is never interpolated, the end of the steps is a lower bound",
          "[fragility][ida]")
{
    const std::vector<IdaStep> steps = {{0.1, 0.2, false}, {0.2, 0.3, false}, {0.4, 0.0, true}};
    CHECK(ida_capacity(steps, 1.0).lower == 0.2);
    CHECK(ida_capacity(steps, 1.0).upper == 0.4);
    CHECK(ida_capacity(steps, HUGE_VAL).upper == 0.4);
    CHECK(censoring(ida_capacity(std::span(steps).first(2), 1.0), true) == Censoring::right);
    CHECK(ida_capacity(std::span(steps).first(2), 1.0).lower == 0.2);
    CHECK(censoring(ida_capacity(std::span(steps).last(1), 1.0), true) == Censoring::left);
    const std::vector<IdaStep> back = {{0.2, 0.2, false}, {0.1, 0.2, false}};
    CHECK_THROWS_AS(ida_capacity(back, 1.0), std::invalid_argument);
}

TEST_CASE("annual rate: under a power law it is k0 median^-k exp(k^2 beta^2 / 2)",
          "[fragility][ida]")
{
    const double k = 2.5, k0 = 1e-3, median = 0.5, beta = 0.4; // Cornell et al. 2002
    std::vector<HazardPoint> hazard;
    for (double x = 0.005; x < 60.0; x *= 1.7) hazard.push_back({x, k0 * std::pow(x, -k)});
    const AnnualRate r = annual_rate(hazard, median, beta);
    const double wanted = k0 * std::pow(median, -k) * std::exp(0.5 * k * k * beta * beta);
    CHECK(r.lower == Approx(wanted).epsilon(1e-5));
    CHECK(r.upper == Approx(wanted).epsilon(1e-4));
    // a curve that is cut off early says between which it lies
    const AnnualRate cut = annual_rate(std::span(hazard).first(9), median, beta);
    CHECK(cut.lower < wanted);
    CHECK(cut.upper > wanted);
    const std::vector<HazardPoint> rising = {{0.1, 1e-4}, {0.2, 1e-3}};
    CHECK_THROWS_AS(annual_rate(rising, 1.0, 0.4), std::invalid_argument);
}

TEST_CASE("annual rate: steep and nearly vertical hazard keeps its digits", "[fragility][ida]")
{
    const auto exact = [](const HazardPoint& a, const HazardPoint& b, double median,
                          double beta) { // midpoints of equal shares of the hazard
        constexpr int kParts = 200'000;
        const double k = std::log(a.rate / b.rate) / std::log(b.intensity / a.intensity);
        double sum = 0.0;
        for (int i = 0; i < kParts; ++i) {
            const double h = a.rate - (a.rate - b.rate) * (i + 0.5) / kParts;
            const double x = a.intensity * std::pow(a.rate / h, 1.0 / k);
            sum += 0.5 * std::erfc(-std::log(x / median) / beta / std::sqrt(2.0));
        }
        return sum * (a.rate - b.rate) / kParts;
    };
    struct Case {
        double lower, upper, fall, median, beta;
    };
    for (const Case& c : {Case{0.1, 1.0, 1e-2, 0.5, 0.4}, Case{0.1, 1.0, 1e-2, 0.02, 0.4},
                          Case{0.5, 0.6, 1e-4, 0.7, 0.5}, Case{1.0, 1.1, 1e-3, 0.6, 0.6},
                          Case{1.0, 1.0001, 1e-2, 0.9, 0.5}, Case{1.0, 1.0001, 1e-2, 5.0, 0.3},
                          Case{0.5, 1.0, 0.9, 2.0, 0.05}, Case{0.2, 3.0, 0.5, 1.0, 1.5}}) {
        INFO(c.lower << " " << c.upper << " " << c.median << " " << c.beta);
        const std::vector<HazardPoint> h = {{c.lower, 1e-3}, {c.upper, 1e-3 * c.fall}};
        CHECK(annual_rate(h, c.median, c.beta).lower ==
              Approx(exact(h[0], h[1], c.median, c.beta)).epsilon(1e-5).margin(1e-30));
    }
}
