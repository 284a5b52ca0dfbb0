#include "uq/reliability/limit_state/exceedance.hpp"

#include "core/binomial.hpp"
#include "core/interval.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <stdexcept>

using namespace uq;

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
    CHECK(
        e.estimate.interval.lower ==
        core::binomial_interval(core::BinomialInterval::clopper_pearson, 10, 100, 0.95).lower);
    CHECK(
        e.estimate.interval.upper ==
        core::binomial_interval(core::BinomialInterval::clopper_pearson, 30, 100, 0.95).upper);
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
    const core::Interval i = log_interval(1e-4, 2e-5, 0.95);
    CHECK(i.lower * i.upper == Approx(1e-8).epsilon(1e-13));
    CHECK(std::log(i.upper / 1e-4) ==
          Approx(1.959963984540054 * std::sqrt(std::log(1.04))).epsilon(1e-12));
    CHECK(log_interval(0.9, 0.3, 0.95).upper == 1.0);
    const core::Interval few = log_interval(1e-4, 2e-5, 0.95, 4.0); // Student's 2.776
    CHECK(std::log(few.upper / few.lower) ==
          Approx(2.0 * 2.7764451051977987 * std::sqrt(std::log(1.04))).epsilon(1e-12));
}
