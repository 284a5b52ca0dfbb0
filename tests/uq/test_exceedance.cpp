#include "uq/reliability/exceedance.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <stdexcept>

using namespace uq;

TEST_CASE("exceedance: intervals of shares are those of Clopper and Pearson",
          "[uq][exceedance]")
{
    const auto near = [](double v) { return Approx(v).epsilon(0.0).margin(5e-11); };
    const Interval a = binomial_interval(3, 50, 0.95);
    CHECK(a.lower == near(0.0125485878));
    CHECK(a.upper == near(0.1654819466));
    const Interval b = binomial_interval(13, 40, 0.95);
    CHECK(b.lower == near(0.1857289668));
    CHECK(b.upper == near(0.4912948755));
    CHECK(binomial_interval(0, 50, 0.95).lower == 0.0);
    CHECK(binomial_interval(0, 50, 0.95).upper == near(0.0711217365));
    CHECK(binomial_interval(50, 50, 0.95).upper == 1.0);
    CHECK(binomial_interval(50, 50, 0.95).lower == near(1.0 - 0.0711217365));
    CHECK_THROWS_AS(binomial_interval(2, 1, 0.95), std::invalid_argument);
    CHECK_THROWS_AS(binomial_interval(0, 0, 0.95), std::invalid_argument);
    CHECK_THROWS_AS(binomial_interval(0, 1, 1.0), std::invalid_argument);
}

TEST_CASE("exceedance: failed samples widen the bounds, all safe below, all passed above",
          "[uq][exceedance]")
{
    const Exceedance e = count_exceedance(10, 20, 100, 0.95);
    CHECK(e.lower == 0.10);
    CHECK(e.upper == 0.30);
    CHECK(e.estimate.value == 0.125);
    CHECK(e.estimate.n == 80);
    CHECK(e.estimate.failed == 20);
    CHECK(e.estimate.std_error == Approx(std::sqrt(0.125 * 0.875 / 80.0)).epsilon(1e-14));
    CHECK(e.estimate.interval.lower == binomial_interval(10, 100, 0.95).lower);
    CHECK(e.estimate.interval.upper == binomial_interval(30, 100, 0.95).upper);
}

TEST_CASE("exceedance: nothing known is the interval from 0 to 1", "[uq][exceedance]")
{
    const Exceedance e = count_exceedance(0, 5, 5, 0.95);
    CHECK(e.outcome == SamplingOutcome::no_answer);
    CHECK(e.lower == 0.0);
    CHECK(e.upper == 1.0);
    CHECK(e.estimate.interval.lower == 0.0);
    CHECK(e.estimate.interval.upper == 1.0);
    CHECK(std::isinf(coefficient_of_variation(e.estimate)));
}

TEST_CASE("exceedance: the interval of a logarithm is symmetric in ratio and cut at 1",
          "[uq][exceedance]")
{
    const Interval i = log_interval(1e-4, 2e-5, 0.95);
    CHECK(i.lower * i.upper == Approx(1e-8).epsilon(1e-13));
    CHECK(std::log(i.upper / 1e-4) ==
          Approx(1.959963984540054 * std::sqrt(std::log(1.04))).epsilon(1e-12));
    CHECK(log_interval(0.9, 0.3, 0.95).upper == 1.0);
}
