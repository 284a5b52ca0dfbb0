#include "uq/reliability/active/active_quantile.hpp"
#include "uq/reliability/active/quantile_checks.hpp"

#include "tests/uq/reliability/reliability_problems.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

namespace {

using Eigen::VectorXd;

/// A normal variable and a chi-squared one: the quantile of 5 % is by
/// quadrature.
double bent(const VectorXd& u) { return 5.0 + u(0) + 0.3 * u(1) * u(1); }
constexpr double kBent = 3.558436008;

/// Log-normal: its quantile of 5 % is exp(-1.6449 s) with s^2 = sum (0.1 k)^2.
double product(const VectorXd& u)
{
    double sum = 0.0;
    for (Eigen::Index k = 0; k < u.size(); ++k) sum += 0.1 * static_cast<double>(k + 1) * u(k);
    return std::exp(sum);
}
const double kProduct = std::exp(-1.6448536269514722 * std::sqrt(0.91));

uq::ActiveQuantileResult found(const uq::LimitState& s, std::uint64_t seed,
                               uq::ActiveQuantileOptions o = {})
{
    o.active.seed = seed;
    return uq::active_quantile(s, o);
}

bool holds(const uq::ActiveQuantileResult& r, double exact)
{
    return r.interval.lower <= exact && exact <= r.interval.upper;
}

} // namespace

TEST_CASE("active quantile: 5 % in two and six dimensions within its interval, from few calls",
          "[uq][active_quantile][repeats][slow]")
{
    struct Case {
        Eigen::Index dimension;
        problems::G response;
        double exact, density; ///< of the response at its quantile
        int runs;
        double most_calls;
    };
    const double s = std::sqrt(0.91);
    const Case c =
        GENERATE_COPY(Case{2, bent, kBent, 0.100, 40, 70.0},
                      Case{6, product, kProduct, 0.1031356 / (s * kProduct), 10, 200.0});
    int held = 0;
    double calls = 0.0, squares = 0.0;
    for (int run = 1; run <= c.runs; ++run) {
        const uq::ActiveQuantileResult r = found(problems::limit_state(c.dimension, c.response),
                                                 static_cast<std::uint64_t>(run));
        CHECK(r.outcome == uq::SamplingOutcome::target_reached);
        held += holds(r, c.exact);
        calls += static_cast<double>(r.ledger.evaluations) / c.runs;
        squares += std::pow(r.value - c.exact, 2) / c.runs;
        CHECK(r.learned + r.checks == r.ledger.evaluations);
    }
    CHECK(held >= 0.9 * c.runs);
    CHECK(calls < c.most_calls);
    const double plain = 0.05 * 0.95 / (c.density * c.density * squares); // same error
    CHECK(plain > 10.0 * calls);
}

TEST_CASE("active quantile: answers that are censored leave the interval open above",
          "[uq][active_quantile][repeats]")
{
    const auto cut = [](double end) {
        return problems::limit_state(
            2, [end](const VectorXd& u) { return std::min(end, bent(u)); });
    };
    uq::ActiveQuantileOptions o;
    o.known_below = 4.6; // above the quantile: nothing is lost
    const uq::ActiveQuantileResult above = found(cut(4.6), 1, o);
    CHECK(holds(above, kBent));
    CHECK(above.interval.upper < 4.6);
    o.known_below = 3.3; // below it, at its probability of 2.6 %
    o.active.max_evaluations = 96;
    int answered = 0;
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
        const uq::ActiveQuantileResult below = found(cut(3.3), seed, o);
        CAPTURE(seed, below.value, below.interval.lower, below.trouble);
        if (!below.trouble.empty()) continue; // all first answers were censored
        ++answered;
        CHECK(std::isnan(below.value));
        CHECK(std::isinf(below.interval.upper));
        CHECK(below.interval.lower > 2.0);
        CHECK(below.interval.lower < kBent);
        CHECK(below.outcome == uq::SamplingOutcome::none_passed);
    }
    CHECK(answered > 0);
}

TEST_CASE("active quantile: failed evaluations widen the interval on both sides",
          "[uq][active_quantile]")
{
    const uq::LimitState s = problems::limit_state(2, bent);
    const uq::ActiveQuantileResult sound = found(s, 2),
                                   some = found(problems::failing(s,
                                                                  [](const VectorXd&u) {
                                                                      return u(0) < -1.0 &&
                                                                             u(1) > 0.3;
                                                                  }),
                                                2);
    REQUIRE(some.ledger.failed.size() > 3);
    CHECK(holds(some, kBent));
    CHECK(some.interval.upper - some.interval.lower >
          sound.interval.upper - sound.interval.lower);
    const uq::ActiveQuantileResult none =
        found(problems::failing(s, [](const VectorXd&) { return true; }), 2);
    CHECK(none.outcome == uq::SamplingOutcome::no_answer);
    CHECK(none.trouble == "fewer than three evaluations answered");
}

TEST_CASE(
    "active quantile: the same seed gives the same bits, the budget holds, bad options are "
    "refused",
    "[uq][active_quantile][repeats]")
{
    const uq::LimitState s = problems::limit_state(2, bent);
    uq::ActiveQuantileOptions o;
    o.active.target_cov = 0.05; // not reached by that many
    o.active.max_evaluations = 53;
    const uq::ActiveQuantileResult a = found(s, 3, o), b = found(s, 3, o);
    CHECK(a.value == b.value);
    CHECK(a.interval.lower == b.interval.lower);
    CHECK(a.ledger.evaluations == 53);
    CHECK(a.outcome == uq::SamplingOutcome::limit_reached);
    CHECK(a.value != found(s, 4, o).value);
    o.probability = 0.6;
    CHECK_THROWS_WITH(uq::active_quantile(s, o), Catch::Contains("(0, 1/2]"));
    o.probability = 0.05;
    o.active.max_evaluations = 47;
    CHECK_THROWS_WITH(uq::active_quantile(s, o), Catch::Contains("at least 48"));
}

TEST_CASE("active quantile: a process that is wrong leaves no bias",
          "[uq][active_quantile][repeats][slow]")
{
    // One point in five is lower by 2, as by the toss of a coin: no process expects such steps.
    const uq::LimitState s = problems::limit_state(2, [](const VectorXd& u) {
        const double toss = std::sin(1e6 * (u(0) + 2.0 * u(1)));
        return u(0) + (toss < std::cos(0.2 * M_PI) * -1.0 ? -2.0 : 0.0);
    });
    // 0.8 Phi(t) + 0.2 Phi(t + 2) = 0.05
    double low = -6.0, high = 0.0;
    const auto below = [](double z) { return 0.5 * std::erfc(-z / std::sqrt(2.0)); };
    for (int i = 0; i < 60; ++i) {
        const double t = 0.5 * (low + high);
        (0.8 * below(t) + 0.2 * below(t + 2.0) < 0.05 ? low : high) = t;
    }
    uq::ActiveQuantileOptions o;
    o.active.max_evaluations = 160;
    int held = 0;
    for (std::uint64_t run = 1; run <= 10; ++run) held += holds(found(s, run, o), low);
    CHECK(held >= 8);
}
