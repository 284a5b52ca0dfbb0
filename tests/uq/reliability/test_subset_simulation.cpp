#include "uq/reliability/simulation/subset_simulation.hpp"

#include "core/binomial.hpp"
#include "core/critical.hpp"
#include "core/interval.hpp"
#include "tests/uq/reliability/reliability_problems.hpp"
#include "uq/designs/stream.hpp"

#include <catch2/catch.hpp>
#include <gsl/gsl_cdf.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

using namespace uq;
using Eigen::VectorXd;

namespace {

struct Repeated {
    double mean, sd, reported_cov; ///< of the value; mean of the reported ones
    int inside = 0;                ///< intervals that hold the exact value
    std::size_t evaluations = 0;   ///< of all
    double observed_cov() const { return sd / mean; }
};

Repeated repeat(const LimitState& s, double exact, int n, SubsetOptions o = {})
{
    double sum = 0.0, square = 0.0, cov = 0.0;
    Repeated r{};
    for (int k = 0; k < n; ++k) {
        o.seed = static_cast<std::uint64_t>(k);
        const Exceedance e = subset_simulation(s, o).exceedance;
        sum += e.estimate.value;
        square += e.estimate.value * e.estimate.value;
        cov += coefficient_of_variation(e.estimate);
        r.inside += e.estimate.interval.lower <= exact && exact <= e.estimate.interval.upper;
        r.evaluations += e.ledger.evaluations;
    }
    r.mean = sum / n;
    r.sd = std::sqrt((square - n * r.mean * r.mean) / (n - 1));
    r.reported_cov = cov / n;
    return r;
}

/// Degrees of freedom by which the interval of an estimate is wide.
double freedom(const Estimate& e)
{
    const double cov = e.std_error / e.value;
    const double wide = std::log(e.value / e.interval.lower) / std::sqrt(std::log1p(cov * cov));
    double least = 1.0, most = 1e6;
    for (int i = 0; i < 100; ++i) {
        const double middle = std::sqrt(least * most);
        (core::student_factor(0.95, middle) > wide ? least : most) = middle;
    }
    return least;
}

} // namespace

TEST_CASE("subset simulation: unbiased within two standard errors over 50 repeats",
          "[uq][subset_simulation]")
{
    for (const problems::Problem& p : problems::all()) {
        INFO(p.name);
        const Repeated r = repeat(p.limit, p.exact, 50);
        CHECK(std::abs(r.mean - p.exact) < 2.0 * r.sd / std::sqrt(50.0));
    }
}

TEST_CASE("subset simulation: the coefficient of variation it reports is that of repetition",
          "[uq][subset_simulation][repeats]")
{
    for (const problems::Problem& p : problems::all()) {
        INFO(p.name);
        const Repeated r = repeat(p.limit, p.exact, 300);
        CHECK(r.reported_cov == Approx(r.observed_cov()).epsilon(0.2));
        CHECK(r.inside >= 264); // of 300; 0.88 at least of the 0.95 asked for
    }
}

TEST_CASE("subset simulation: intervals from few large families of samples cover as they say",
          "[uq][subset_simulation][repeats]")
{
    // Answers that scatter part the chains of a level: fewer families are behind the result.
    const auto scatter = [](const VectorXd& x) {
        const double a = 43758.5453 * std::sin(12345.678 * x(0) + 54321.123 * x(1));
        return gsl_cdf_ugaussian_Pinv(std::clamp(a - std::floor(a), 1e-9, 1.0 - 1e-9));
    };
    const double share = GENERATE(0.0, 0.3), p = GENERATE(0.13, 1e-3, 1e-4); // of the scatter
    const double beta = gsl_cdf_ugaussian_Qinv(p), sd = std::hypot(1.0, share);
    const LimitState s = problems::limit_state(
        2, [&](const VectorXd& x) { return beta - (x(0) + share * scatter(x)) / sd; });
    SubsetOptions o{.samples = 300, .max_evaluations = 1500};
    o.target_cov = 0.05;
    INFO("P " << p << ", scatter " << share);
    const Repeated r = repeat(s, p, 400, o);
    CHECK(r.inside >= 368); // 0.92 of the 0.95 asked for; three standard deviations less
    CHECK(r.inside <= 394);
}

TEST_CASE("subset simulation: 1e-7 takes 7 levels, each at the acceptance aimed at",
          "[uq][subset_simulation]")
{
    const problems::Problem p = problems::steel_section();
    SubsetOptions o;
    o.samples = 5000;
    const SubsetResult r = subset_simulation(p.limit, o);
    CHECK(r.levels.size() == 7);
    CHECK(r.exceedance.outcome == SamplingOutcome::target_reached);
    CHECK(r.exceedance.ledger.evaluations == 5000 + 6 * 4500);
    CHECK(r.exceedance.estimate.interval.lower < p.exact);
    CHECK(r.exceedance.estimate.interval.upper > p.exact);
    double product = 1.0;
    for (std::size_t i = 0; i < r.levels.size(); ++i) {
        product *= r.levels[i].share;
        if (i > 0) {
            CHECK(r.levels[i].threshold < r.levels[i - 1].threshold);
            CHECK(r.levels[i].acceptance > 0.25);
            CHECK(r.levels[i].acceptance < 0.65);
            CHECK(r.levels[i].ancestors <= r.levels[i - 1].ancestors);
        }
    }
    CHECK(product == Approx(r.exceedance.estimate.value).epsilon(1e-12));
}

TEST_CASE("subset simulation: holds in 100 dimensions", "[uq][subset_simulation]")
{
    const LimitState s =
        problems::limit_state(100, [](const VectorXd& x) { return 3.5 - x.sum() / 10.0; });
    const double exact = gsl_cdf_ugaussian_Q(3.5);
    const Repeated r = repeat(s, exact, 50);
    CHECK(std::abs(r.mean - exact) < 2.0 * r.sd / std::sqrt(50.0));
    CHECK(r.reported_cov == Approx(r.observed_cov()).epsilon(0.25));
}

TEST_CASE("subset simulation: certain and impossible events end at once",
          "[uq][subset_simulation]")
{
    const auto constant = [](double g) {
        return subset_simulation(problems::limit_state(2, [=](const VectorXd&) { return g; }));
    };
    const SubsetResult always = constant(-1.0);
    CHECK(always.exceedance.outcome == SamplingOutcome::all_passed);
    CHECK(always.exceedance.estimate.value == 1.0);
    CHECK(always.exceedance.estimate.std_error == 0.0);
    CHECK(always.exceedance.estimate.interval.lower ==
          core::binomial_interval(core::BinomialInterval::clopper_pearson, 1000, 1000, 0.95)
              .lower);
    const SubsetResult never = constant(1.0);
    CHECK(never.exceedance.outcome == SamplingOutcome::none_passed);
    CHECK(never.exceedance.estimate.value == 0.0);
    CHECK(
        never.exceedance.estimate.interval.upper ==
        core::binomial_interval(core::BinomialInterval::clopper_pearson, 0, 1000, 0.95).upper);
    CHECK(never.exceedance.ledger.evaluations == 1000);
    CHECK(constant(0.0).exceedance.estimate.value == 1.0); // on the limit is passed
    CHECK_FALSE(never.exceedance.warnings.empty());
}

TEST_CASE("subset simulation: what is never reached is bounded by the last level",
          "[uq][subset_simulation]")
{
    // g falls to 1 and stays there: P = 0.
    const LimitState s =
        problems::limit_state(2, [](const VectorXd& x) { return std::max(1.0, 4.0 - x(0)); });
    const SubsetResult r = subset_simulation(s);
    CHECK(r.exceedance.outcome == SamplingOutcome::none_passed);
    CHECK(r.exceedance.estimate.value == 0.0);
    CHECK(r.exceedance.estimate.interval.upper > gsl_cdf_ugaussian_Q(3.0));
    CHECK(r.exceedance.estimate.interval.upper < 4.0 * gsl_cdf_ugaussian_Q(3.0));
    SubsetOptions o;
    o.max_levels = 2;
    const Exceedance few = subset_simulation(problems::steel_section().limit, o).exceedance;
    CHECK(few.outcome == SamplingOutcome::none_passed);
    // One level was passed, by 100 of 1000 independent samples: a lognormal interval.
    const double square = 0.9 / (0.1 * 999.0);               // cov^2
    const double factor = core::student_factor(0.95, 199.0); // 100 families of one: 2 x 100 - 1
    CHECK(few.estimate.interval.upper ==
          Approx(0.1 * std::exp(factor * std::sqrt(std::log1p(square)))).epsilon(1e-12));
}

TEST_CASE("subset simulation: a limit state in steps is not biased by its ties",
          "[uq][subset_simulation]")
{
    const LimitState s = problems::limit_state(
        2, [](const VectorXd& x) { return std::ceil(4.0 * (3.0 - x(0))) / 4.0; });
    const double exact = gsl_cdf_ugaussian_Q(3.0);
    const Repeated r = repeat(s, exact, 200);
    CHECK(std::abs(r.mean - exact) < 2.0 * r.sd / std::sqrt(200.0));
}

TEST_CASE("subset simulation: few chains still run, and say that little is known",
          "[uq][subset_simulation]")
{
    SubsetOptions o;
    o.samples = GENERATE(10, 20, 50);
    const problems::Problem p = problems::difference_7_2();
    const SubsetResult r = subset_simulation(p.limit, o);
    CHECK(std::isfinite(r.exceedance.estimate.value));
    CHECK(r.exceedance.estimate.interval.upper <= 1.0);
    CHECK_FALSE(r.exceedance.warnings.empty());
}

TEST_CASE("subset simulation: failed samples widen the bounds, each kind by its own run",
          "[uq][subset_simulation]")
{
    // Passes for u1 > 3, of which the part u1 > 3.5 fails.
    const LimitState s = problems::failing(
        problems::limit_state(2, [](const VectorXd& x) { return 3.0 - x(0); }),
        [](const VectorXd& x) { return x(0) > 3.5; });
    SubsetOptions o;
    o.samples = 10000;
    const Exceedance e = subset_simulation(s, o).exceedance;
    const double all = gsl_cdf_ugaussian_Q(3.0), failed = gsl_cdf_ugaussian_Q(3.5);
    CHECK(e.lower == Approx(all - failed).epsilon(0.3));
    CHECK(e.upper == Approx(all).epsilon(0.3));
    CHECK(e.estimate.interval.lower < all - failed);
    CHECK(e.estimate.interval.upper > all);
    CHECK(e.estimate.failed == e.ledger.failed.size());
    for (const FailedSample& f : e.ledger.failed) CHECK(f.x(0) > 3.5);

    const LimitState none = problems::failing(s, [](const VectorXd&) { return true; });
    const Exceedance nothing = subset_simulation(none).exceedance;
    CHECK(nothing.outcome == SamplingOutcome::no_answer);
    CHECK(nothing.estimate.interval.lower == 0.0);
    CHECK(nothing.estimate.interval.upper == 1.0);
}

TEST_CASE("subset simulation: one in fifty fails by chance, without bias",
          "[uq][subset_simulation]")
{
    const problems::Problem p = problems::rp22();
    const LimitState s = problems::failing(
        p.limit, [](const VectorXd& x) { return std::abs(std::fmod(x(1) * 1e5, 1.0)) > 0.98; });
    const Repeated r = repeat(s, p.exact, 100);
    CHECK(std::abs(r.mean - p.exact) < 2.0 * r.sd / std::sqrt(100.0));
    CHECK(r.inside >= 95); // wider than without failures
}

TEST_CASE("subset simulation: the same seed gives the same bits, in any batch",
          "[uq][subset_simulation]")
{
    const problems::Problem p = problems::rp8();
    LimitState split = p.limit;
    split.model = [&p](const Samples& s) { // two calls for each
        const Eigen::Index half = s.x.rows() / 2;
        Responses r = p.limit.model({s.x.topRows(half), {}});
        const Responses rest = p.limit.model({s.x.bottomRows(s.x.rows() - half), {}});
        r.y.conservativeResize(s.x.rows(), 1);
        r.y.bottomRows(rest.y.rows()) = rest.y;
        r.failure.resize(s.id.size());
        return r;
    };
    CHECK(subset_simulation(p.limit).exceedance.estimate.value ==
          subset_simulation(split).exceedance.estimate.value);
}

TEST_CASE(
    "subset simulation: evaluations allowed are not exceeded, and a missed target is said",
    "[uq][subset_simulation]")
{
    const LimitState s = problems::difference_7_2().limit; // 2e-4: four levels
    SubsetOptions o{.samples = 500};
    o.max_evaluations = 900; // the second level would need 450 more than the 500 of the first
    const Exceedance early = subset_simulation(s, o).exceedance;
    CHECK(early.ledger.evaluations == 500);
    CHECK(early.outcome == SamplingOutcome::none_passed);
    CHECK(early.estimate.interval.upper > 2.034760087225e-4);
    o.max_evaluations = 5000;
    CHECK(subset_simulation(s, o).exceedance.outcome == SamplingOutcome::target_reached);
    o.target_cov = 0.01;
    CHECK(subset_simulation(s, o).exceedance.outcome == SamplingOutcome::limit_reached);
}

TEST_CASE(
    "subset simulation: independent runs are added until the target or the budget is reached",
    "[uq][subset_simulation]")
{
    const problems::Problem p = problems::rp22(); // 4e-3: three levels
    SubsetOptions o{.samples = 400, .max_evaluations = 6000, .target_cov = 0.15};
    const SubsetResult r = subset_simulation(p.limit, o);
    CHECK(r.arrived);
    CHECK(r.runs > 1);
    CHECK(r.exceedance.outcome == SamplingOutcome::target_reached);
    CHECK(coefficient_of_variation(r.exceedance.estimate) <= 0.15);
    o.target_cov = 0.01;
    const SubsetResult all = subset_simulation(p.limit, o);
    CHECK(all.exceedance.outcome == SamplingOutcome::limit_reached);
    CHECK(all.exceedance.ledger.evaluations <= 6000);
    CHECK(all.exceedance.ledger.evaluations >
          6000 - (400 + 3 * 360)); // none left for another run
    // two runs are the mean of two
    o.max_evaluations = 2400;
    const SubsetResult two = subset_simulation(p.limit, o);
    REQUIRE(two.runs == 2);
    SubsetOptions one{.samples = 400, .seed = o.seed};
    const Estimate a = subset_simulation(p.limit, one).exceedance.estimate;
    one.seed = replicate_seed(o.seed, 2);
    const Estimate b = subset_simulation(p.limit, one).exceedance.estimate;
    CHECK(two.exceedance.estimate.value == Approx(0.5 * (a.value + b.value)).epsilon(1e-14));
    CHECK(two.exceedance.estimate.std_error ==
          Approx(0.5 * std::hypot(a.std_error, b.std_error)).epsilon(1e-14));
    const auto square = [](const Estimate& e) { return e.std_error * e.std_error; };
    const double all_squares = square(a) + square(b); // Welch (1947)
    CHECK(freedom(two.exceedance.estimate) ==
          Approx(all_squares * all_squares /
                 (square(a) * square(a) / freedom(a) + square(b) * square(b) / freedom(b)))
              .epsilon(1e-6));
}

TEST_CASE("subset simulation: runs added for a target keep value, error and coverage true",
          "[uq][subset_simulation][repeats]")
{
    const SubsetOptions one{.samples = 400};
    SubsetOptions o{.samples = 400, .max_evaluations = 4000};
    o.target_cov =
        GENERATE(0.2, 0.01); // reached by some runs; by none, so that the budget is spent
    for (const problems::Problem& p : problems::all()) {
        if (p.exact < 1e-4) continue; // one run fills the budget
        INFO(p.name);
        const Repeated single = repeat(p.limit, p.exact, 60, one),
                       r = repeat(p.limit, p.exact, 150, o);
        const double bias = // of one run, and of stopping on the result
            std::pow(single.observed_cov(), 2) + std::pow(o.target_cov, 2);
        CHECK(std::abs(r.mean - p.exact) < 3.0 * r.sd / std::sqrt(150.0) + bias * p.exact);
        CHECK(r.observed_cov() < single.observed_cov());
        CHECK(r.inside >= 132); // of 150; 0.88 at least of the 0.95 asked for
        CHECK(r.evaluations <= 150 * o.max_evaluations);
    }
}

TEST_CASE("subset simulation: a frequent event is a count of independent samples of all runs",
          "[uq][subset_simulation]")
{
    const LimitState s =
        problems::limit_state(1, [](const VectorXd& x) { return 0.5 - x(0); }); // P = 0.31
    SubsetOptions o{.samples = 100, .max_evaluations = 1000, .target_cov = 0.001};
    const SubsetResult r = subset_simulation(s, o);
    CHECK(r.runs == 10);
    CHECK(r.exceedance.ledger.evaluations == 1000);
    const auto hits = static_cast<std::size_t>(std::lround(1000 * r.exceedance.estimate.value));
    const core::Interval exact =
        core::binomial_interval(core::BinomialInterval::clopper_pearson, hits, 1000, 0.95);
    CHECK(r.exceedance.estimate.interval.lower == Approx(exact.lower).epsilon(1e-12));
    CHECK(r.exceedance.estimate.interval.upper == Approx(exact.upper).epsilon(1e-12));
}

TEST_CASE("subset simulation: options out of range are refused", "[uq][subset_simulation]")
{
    const LimitState s = problems::rp22().limit;
    CHECK_THROWS_AS(subset_simulation(s, {.samples = 5}), std::invalid_argument);
    CHECK_THROWS_AS(subset_simulation(s, {.samples = 1005}), std::invalid_argument);
    CHECK_THROWS_AS(subset_simulation(s, {.level_share = 0.3}), std::invalid_argument);
    CHECK_THROWS_AS(subset_simulation(s, {.level_share = 0.0}), std::invalid_argument);
    CHECK_THROWS_AS(subset_simulation(s, {.max_levels = 0}), std::invalid_argument);
}
