#include "uq/estimates/estimate.hpp"

#include "core/critical.hpp"
#include "core/interval.hpp"
#include "uq/designs/stream.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>
#include <stdexcept>

using namespace uq;

namespace {

const double kNan = std::numeric_limits<double>::quiet_NaN();

auto near(double value, double tolerance)
{
    return Approx(value).epsilon(tolerance).margin(0.0);
}

std::vector<double> normal_values(std::uint64_t sample, int n)
{
    Stream s(21, sample, Purpose::monte_carlo);
    std::vector<double> y;
    for (int i = 0; i < n; ++i) y.push_back(10.0 + 2.0 * s.normal());
    return y;
}

bool holds(const core::Interval& i, double truth)
{
    return i.lower <= truth && truth <= i.upper;
}

} // namespace

TEST_CASE("estimate: the interval of the mean is Student's", "[uq][estimate]")
{
    const Estimate e = estimate_mean(std::vector<double>{1.0, 2.0, 3.0, 4.0, 5.0});
    CHECK(e.value == 3.0);
    CHECK(e.std_error == near(std::sqrt(0.5), 1e-15));
    CHECK(e.n == 5);
    CHECK(e.interval.upper - 3.0 == near(2.7764451051977987 * std::sqrt(0.5), 1e-13));
    CHECK(3.0 - e.interval.lower == near(2.7764451051977987 * std::sqrt(0.5), 1e-13));
    CHECK(core::normal_factor(0.95) == near(1.959963984540054, 1e-14));
    CHECK(core::student_factor(0.99, 3.0) ==
          near(5.840909309733350, 1e-13)); // closed form exists
}

TEST_CASE("estimate: intervals hold the truth as often as they say", "[uq][estimate]")
{
    const int studies = 4000;
    int mean_held = 0;
    for (int k = 0; k < studies; ++k)
        mean_held += holds(
            estimate_mean(normal_values(static_cast<std::uint64_t>(k), 6)).interval, 10.0);
    const double error = std::sqrt(0.95 * 0.05 / studies); // 0.0034
    CHECK(std::abs(mean_held / double(studies) - 0.95) < 3.0 * error);
}

TEST_CASE("estimate: failed samples are counted and left out", "[uq][estimate]")
{
    const std::vector<double> y{1.0, kNan, 2.0, 3.0, kNan, 4.0, 5.0};
    const std::vector<double> sound{1.0, 2.0, 3.0, 4.0, 5.0};
    const Estimate e = estimate_mean(y), s = estimate_mean(sound);
    CHECK(e.failed == 2);
    CHECK(e.n == 5);
    CHECK(e.value == s.value);
    CHECK(e.interval.lower == s.interval.lower);
}

TEST_CASE(
    "estimate: with bounds of the answer, the interval holds whatever failed samples would "
    "have answered",
    "[uq][estimate]")
{
    const std::vector<double> y{1.0, kNan, 2.0, 3.0, 4.0, 5.0};
    const Estimate e = estimate_mean(y, 0.0, 30.0);
    const Estimate s = estimate_mean(std::vector<double>{1.0, 2.0, 3.0, 4.0, 5.0});
    CHECK(e.value == 3.0);
    CHECK(e.interval.lower == near(s.interval.lower * 5.0 / 6.0, 1e-14));
    CHECK(e.interval.upper == near((s.interval.upper * 5.0 + 30.0) / 6.0, 1e-14));
    CHECK_THROWS_AS(estimate_mean(y, 2.0, 30.0), std::invalid_argument);
}

TEST_CASE("estimate: Wilson and Clopper-Pearson intervals of 3/50, 13/40, 0/50",
          "[uq][estimate]")
{
    const auto both = [](std::size_t hits, std::size_t n, core::BinomialInterval kind) {
        return estimate_probability(hits, n, 0, 0.95, kind).interval;
    };
    const auto cp = core::BinomialInterval::clopper_pearson, w = core::BinomialInterval::wilson;
    CHECK(both(3, 50, cp).lower == near(.0125485878, 1e-8));
    CHECK(both(3, 50, cp).upper == near(.1654819466, 1e-9));
    CHECK(both(3, 50, w).lower == near(.0206149703, 1e-8));
    CHECK(both(3, 50, w).upper == near(.1621709169, 1e-9));
    CHECK(both(13, 40, cp).lower == near(.1857289668, 1e-9));
    CHECK(both(13, 40, cp).upper == near(.4912948755, 1e-9));
    CHECK(both(13, 40, w).lower == near(.2008450223, 1e-9));
    CHECK(both(13, 40, w).upper == near(.4798225381, 1e-9));
    CHECK(both(0, 50, cp).lower == 0.0);
    CHECK(both(0, 50, cp).upper == near(1.0 - std::pow(0.025, 0.02), 1e-13));
    CHECK(both(0, 50, w).lower == 0.0);
    CHECK(both(0, 50, w).upper == near(.0713475991, 1e-9));
    CHECK(both(50, 50, cp).upper == 1.0);
    CHECK(both(50, 50, w).upper == 1.0);
    CHECK(both(50, 50, w).lower == near(1.0 - both(0, 50, w).upper, 1e-14));
}

TEST_CASE("estimate: a failed sample could be either outcome", "[uq][estimate]")
{
    const auto kind =
        GENERATE(core::BinomialInterval::wilson, core::BinomialInterval::clopper_pearson);
    const Estimate e = estimate_probability(10, 90, 10, 0.95, kind);
    CHECK(e.value == near(10.0 / 90.0, 1e-15));
    CHECK(e.failed == 10);
    CHECK(e.interval.lower == estimate_probability(10, 100, 0, 0.95, kind).interval.lower);
    CHECK(e.interval.upper == estimate_probability(20, 100, 0, 0.95, kind).interval.upper);
    CHECK(e.std_error == near(std::sqrt(0.2 * 0.8 / 90.0), 1e-14));
    std::vector<double> y(100, 2.0);
    for (std::size_t i = 0; i < 10; ++i) y[i] = 1.0, y[99 - i] = kNan;
    const Estimate f = estimate_probability_below(y, 1.0, 0.95, kind);
    CHECK(f.value == e.value);
    CHECK(f.interval.upper == e.interval.upper);
}

TEST_CASE("estimate: what cannot be estimated is refused", "[uq][estimate]")
{
    CHECK_THROWS_AS(estimate_mean(std::vector<double>{1.0}), std::invalid_argument);
    CHECK_THROWS_AS(estimate_mean(std::vector<double>{1.0, kNan}), std::invalid_argument);
    CHECK_THROWS_AS(estimate_mean(std::vector<double>{1.0, INFINITY, 2.0}),
                    std::invalid_argument);
    CHECK_THROWS_AS(estimate_mean(std::vector<double>{1.0, 2.0}, 1.0), std::invalid_argument);
    CHECK_THROWS_AS(estimate_probability(0, 0), std::invalid_argument);
    CHECK_THROWS_AS(estimate_probability(3, 2), std::invalid_argument);
}
