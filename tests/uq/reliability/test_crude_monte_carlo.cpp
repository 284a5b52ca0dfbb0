#include "uq/reliability/simulation/crude_monte_carlo.hpp"

#include "tests/uq/reliability/reliability_problems.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <stdexcept>

using namespace uq;
using Eigen::VectorXd;

TEST_CASE("crude monte carlo: published probabilities lie in its interval, at the error asked "
          "for",
          "[uq][crude_monte_carlo]")
{
    for (const problems::Problem& p : problems::all()) {
        if (p.exact < 1e-3) continue;
        INFO(p.name);
        MonteCarloOptions o;
        o.max_samples = 1000000;
        o.confidence = 0.99; // of seven intervals all shall hold
        const Exceedance e = crude_monte_carlo(p.limit, o);
        CHECK(e.outcome == SamplingOutcome::target_reached);
        CHECK(coefficient_of_variation(e.estimate) <= 0.05);
        CHECK(e.estimate.interval.lower < p.exact);
        CHECK(e.estimate.interval.upper > p.exact);
        // Not more samples than needed: (1 - p) / (p 0.05^2), and chance.
        CHECK(static_cast<double>(e.ledger.evaluations) < 1.5 * (1.0 / p.exact - 1.0) * 400.0);
        CHECK(e.ledger.batches * 1000 == e.ledger.evaluations);
    }
}

TEST_CASE("crude monte carlo: the interval holds the truth as often as it says",
          "[uq][crude_monte_carlo]")
{
    const problems::Problem p = problems::difference_4_2();
    int inside = 0;
    double sum = 0.0;
    for (std::uint64_t seed = 0; seed < 400; ++seed) {
        MonteCarloOptions o;
        o.max_samples = 400;
        o.target_cov = 1e-9;
        o.seed = seed;
        const Estimate e = crude_monte_carlo(p.limit, o).estimate;
        inside += e.interval.lower <= p.exact && p.exact <= e.interval.upper;
        sum += e.value;
    }
    CHECK(inside >= 372); // 0.95 of 400, less two standard deviations
    CHECK(sum / 400.0 ==
          Approx(p.exact).margin(2.5 * std::sqrt(p.exact * (1.0 - p.exact) / 160000.0)));
}

TEST_CASE("crude monte carlo: results do not depend on the batch", "[uq][crude_monte_carlo]")
{
    MonteCarloOptions o;
    o.max_samples = 5000;
    o.target_cov = 1e-9;
    o.batch = GENERATE(1, 7, 1000, 5000);
    const problems::Problem p = problems::axial_beam();
    MonteCarloOptions whole = o;
    whole.batch = 5000;
    CHECK(crude_monte_carlo(p.limit, o).estimate.value ==
          crude_monte_carlo(p.limit, whole).estimate.value);
}

TEST_CASE("crude monte carlo: never passed is an upper bound, always passed a lower one",
          "[uq][crude_monte_carlo]")
{
    MonteCarloOptions o;
    o.max_samples = 3000;
    const auto constant = [&](double g) {
        return crude_monte_carlo(problems::limit_state(1, [=](const VectorXd&) { return g; }),
                                 o);
    };
    const Exceedance never = constant(1.0);
    CHECK(never.outcome == SamplingOutcome::none_passed);
    CHECK(never.estimate.value == 0.0);
    CHECK(never.estimate.interval.upper == Approx(1.0 - std::pow(0.025, 1.0 / 3000.0)));
    const Exceedance always = constant(-1.0);
    CHECK(always.outcome == SamplingOutcome::all_passed);
    CHECK(always.estimate.value == 1.0);
    CHECK(always.estimate.interval.lower == Approx(std::pow(0.025, 1.0 / 3000.0)));
    CHECK(constant(0.0).estimate.value == 1.0); // on the limit is passed
}

TEST_CASE("crude monte carlo: failed samples are kept and widen the bounds",
          "[uq][crude_monte_carlo]")
{
    // One in ten fails, whatever else it does.
    const problems::Problem p = problems::difference_4_2();
    const LimitState s = problems::failing(
        p.limit, [](const VectorXd& x) { return std::fmod(x(1) * 1e4, 1.0) > 0.9; });
    MonteCarloOptions o;
    o.max_samples = 20000;
    const Exceedance e = crude_monte_carlo(s, o);
    CHECK(e.estimate.failed == e.ledger.failed.size());
    CHECK(e.estimate.failed + e.estimate.n == e.ledger.evaluations);
    const double all = static_cast<double>(e.ledger.evaluations);
    CHECK(e.upper - e.lower == Approx(static_cast<double>(e.estimate.failed) / all));
    CHECK(static_cast<double>(e.estimate.failed) / all == Approx(0.1).margin(0.02));
    CHECK(e.estimate.interval.lower < e.lower);
    CHECK(e.estimate.interval.upper > e.upper);
    CHECK(std::abs(e.estimate.value - p.exact) < 3.0 * e.estimate.std_error);
}

TEST_CASE("crude monte carlo: if all fail there is no answer", "[uq][crude_monte_carlo]")
{
    const LimitState s =
        problems::failing(problems::rp22().limit, [](const VectorXd&) { return true; });
    MonteCarloOptions o;
    o.max_samples = 100;
    const Exceedance e = crude_monte_carlo(s, o);
    CHECK(e.outcome == SamplingOutcome::no_answer);
    CHECK(e.upper == 1.0);
    CHECK(e.ledger.failed.size() == 100);
}

TEST_CASE("crude monte carlo: options out of range are refused", "[uq][crude_monte_carlo]")
{
    const LimitState s = problems::rp22().limit;
    CHECK_THROWS_AS(crude_monte_carlo(s, {.batch = 0}), std::invalid_argument);
    CHECK_THROWS_AS(crude_monte_carlo(s, {.max_samples = 0}), std::invalid_argument);
    CHECK_THROWS_AS(crude_monte_carlo(s, {.target_cov = 0.0}), std::invalid_argument);
    CHECK_THROWS_AS(crude_monte_carlo(s, {.confidence = 1.0}), std::invalid_argument);
}
