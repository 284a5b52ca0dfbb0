#include "uq/reliability/active/active_learning.hpp"

#include "tests/uq/reliability/reliability_problems.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

namespace {

using Eigen::VectorXd;

/// Waarts (2000) as Echard et al. (2011) use it: P = 4.4573e-3 by quadrature.
uq::LimitState four_branches()
{
    return problems::limit_state(2, [](const VectorXd& u) {
        const double off = u(0) - u(1), bend = 3.0 + 0.1 * off * off,
                     sum = (u(0) + u(1)) / std::sqrt(2.0), cut = 6.0 / std::sqrt(2.0);
        return std::min({bend - sum, bend + sum, off + cut, cut - off});
    });
}
constexpr double kFourBranches = 4.4573e-3;

uq::ActiveResult learned(const uq::LimitState& s, double target, std::uint64_t seed = 1,
                         std::size_t most = 1000)
{
    uq::ActiveOptions o;
    o.target_cov = target;
    o.seed = seed;
    o.max_evaluations = most;
    return uq::active_learning(s, o);
}

double error(const uq::ActiveResult& r, double exact)
{
    return r.exceedance.estimate.value / exact - 1.0;
}

} // namespace

TEST_CASE("active learning: the four branches within 130 evaluations",
          "[uq][active_learning][repeats]")
{
    const uq::ActiveResult r = learned(four_branches(), 0.06);
    CHECK(r.exceedance.outcome == uq::SamplingOutcome::target_reached);
    CHECK(r.exceedance.ledger.evaluations <= 130);
    CHECK(std::abs(error(r, kFourBranches)) < 0.05);
    CHECK(r.exceedance.estimate.interval.lower < kFourBranches);
    CHECK(r.exceedance.estimate.interval.upper > kFourBranches);
    CHECK(r.checks + r.learned == r.exceedance.ledger.evaluations);
}

TEST_CASE("active learning: 1e-7 in two dimensions, 1e-3 in ten",
          "[uq][active_learning][repeats]")
{
    const problems::Problem steel = problems::steel_section();
    const uq::ActiveResult rare = learned(steel.limit, 0.1);
    CHECK(std::abs(error(rare, steel.exact)) < 0.1);
    CHECK(rare.exceedance.ledger.evaluations <= 100);
    const uq::ActiveResult ten =
        learned(problems::limit_state(
                    10, [](const VectorXd& u) { return 3.0 - u.sum() / std::sqrt(10.0); }),
                0.1);
    CHECK(std::abs(error(ten, 1.349898e-3)) < 0.1);
    CHECK(ten.exceedance.ledger.evaluations <= 100);
}

TEST_CASE("active learning: a process that is wrong leaves no bias",
          "[uq][active_learning][slow]")
{
    // One of two planes, as by the toss of a coin: noise that is not normal. A process takes
    // it for normal, of standard deviation 2, and has P = 1 - Phi(2 / sqrt 5) = 0.186.
    const uq::LimitState coin = problems::limit_state(2, [](const VectorXd& u) {
        return 2.0 - u(0) + (std::sin(1e6 * (u(0) + 2.0 * u(1))) < 0.0 ? -2.0 : 2.0);
    });
    constexpr double kExact = 0.25 + 0.5 * 3.167124e-5;
    constexpr int kRuns = 4;
    double sum = 0.0;
    int held = 0;
    for (int run = 1; run <= kRuns; ++run) {
        const uq::ActiveResult r = learned(coin, 0.12, static_cast<std::uint64_t>(run), 136);
        sum += error(r, kExact);
        held += r.exceedance.estimate.interval.lower <= kExact &&
                kExact <= r.exceedance.estimate.interval.upper;
        CHECK(r.exceedance.estimate.std_error > 0.08 * r.exceedance.estimate.value);
    }
    CHECK(std::abs(sum) / kRuns < 0.15);
    CHECK(held >= kRuns - 1);
}

TEST_CASE("active learning: the same seed gives the same bits, another one other points",
          "[uq][active_learning]")
{
    const auto value = [](std::uint64_t seed) {
        return learned(four_branches(), 0.2, seed, 120).exceedance.estimate.value;
    };
    CHECK(value(1) == value(1));
    CHECK(value(1) != value(2));
}

TEST_CASE("active learning: failed evaluations widen the interval and are never points",
          "[uq][active_learning]")
{
    const uq::LimitState s = problems::failing(
        four_branches(), [](const VectorXd& u) { return u(0) > 2.0 && u(1) > 0.0; });
    const uq::ActiveResult r = learned(s, 0.1, 1, 120);
    REQUIRE(r.exceedance.ledger.failed.size() > 3);
    CHECK(r.exceedance.lower < r.exceedance.upper);
    CHECK(r.exceedance.estimate.interval.lower < kFourBranches);
    CHECK(r.exceedance.estimate.interval.upper > kFourBranches);
    const uq::ActiveResult none =
        learned(problems::failing(four_branches(), [](const VectorXd&) { return true; }), 0.1);
    CHECK(none.exceedance.outcome == uq::SamplingOutcome::no_answer);
    CHECK(none.exceedance.estimate.interval.upper == 1.0);
}

TEST_CASE("active learning: never more evaluations than allowed, and the reason of no process",
          "[uq][active_learning]")
{
    const uq::ActiveResult r = learned(four_branches(), 1e-3, 1, 53);
    CHECK(r.exceedance.ledger.evaluations == 53);
    CHECK(r.exceedance.outcome == uq::SamplingOutcome::limit_reached);
    const uq::ActiveResult same =
        learned(problems::limit_state(2, [](const VectorXd&) { return 1.0; }), 0.1);
    CHECK(same.trouble == "process: the response does not vary");
    CHECK(same.exceedance.outcome == uq::SamplingOutcome::no_answer);
    uq::ActiveOptions o;
    o.max_evaluations = 47;
    CHECK_THROWS_WITH(uq::active_learning(four_branches(), o),
                      Catch::Contains("max_evaluations must be at least 48"));
    o.max_evaluations = 100;
    o.target_cov = 0.0;
    CHECK_THROWS_WITH(uq::active_learning(four_branches(), o), Catch::Contains("target_cov"));
}
