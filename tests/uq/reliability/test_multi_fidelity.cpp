#include "uq/reliability/simulation/multi_fidelity.hpp"

#include "core/binomial.hpp"
#include "tests/uq/reliability/reliability_problems.hpp"
#include "uq/reliability/limit_state/evaluate.hpp"
#include "uq/reliability/simulation/crude_monte_carlo.hpp"

#include <catch2/catch.hpp>
#include <gsl/gsl_cdf.h>

#include <chrono>
#include <cmath>
#include <stdexcept>
#include <thread>

using namespace uq;
using Eigen::VectorXd;

namespace {

CheapModel cheap(problems::G g, double cost, double threshold = 0.0)
{
    return {problems::limit_state(2, std::move(g)).model, cost, 0, threshold};
}

/// y = exp(0.4 u1) + 0.1 u2: mean exp(0.08), variance e^0.16 (e^0.16 - 1) + 0.01.
const LimitState curved = problems::limit_state(
    2, [](const VectorXd& x) { return std::exp(0.4 * x(0)) + 0.1 * x(1); });
const double kMean = std::exp(0.08);
const double kVariance = std::exp(0.16) * (std::exp(0.16) - 1.0) + 0.01;

/// Its tangent, with part of u2: correlation 0.4 e^0.08 / sd.
const CheapModel tangent = cheap([](const VectorXd& x) { return x(0); }, 0.01);
const CheapModel noise = cheap([](const VectorXd& x) { return std::sin(50.0 * x(1)); }, 0.01);

struct Repeated {
    double mean = 0.0, variance = 0.0, reported = 0.0, coverage = 0.0, predicted = 0.0,
           spent = 0.0;
};

Repeated repeat(const LimitState& s, const std::vector<CheapModel>& c, MultiFidelityOptions o,
                double exact, int times)
{
    Repeated r;
    double square = 0.0;
    for (int k = 0; k < times; ++k) {
        o.seed = static_cast<std::uint64_t>(k);
        const MultiFidelityResult m = multi_fidelity(s, c, o);
        const Estimate& e = m.estimate;
        r.mean += e.value / times;
        square += e.value * e.value;
        r.reported += e.std_error * e.std_error / times;
        r.coverage +=
            (e.interval.lower <= exact && exact <= e.interval.upper ? 1.0 : 0.0) / times;
        r.predicted += m.plan.variance_ratio / times;
        r.spent += m.spent / times;
    }
    r.variance = (square - times * r.mean * r.mean) / (times - 1);
    return r;
}

} // namespace

TEST_CASE(
    "multi-fidelity: a mean at the variance predicted, below that of the expensive model alone",
    "[uq][multi_fidelity]")
{
    MultiFidelityOptions o;
    o.budget = 100.0;
    const Repeated r = repeat(curved, {tangent}, o, kMean, 500);
    const double rho2 = 0.16 * std::exp(0.16) / kVariance;
    const double ratio = std::pow(std::sqrt(1.0 - rho2) + 0.1 * std::sqrt(rho2), 2);
    CHECK(r.predicted == Approx(ratio).epsilon(0.1));
    CHECK(r.variance == Approx(ratio * kVariance / 100.0).epsilon(0.25));
    CHECK(r.variance < 0.3 * kVariance / 100.0);
    CHECK(r.reported == Approx(r.variance).epsilon(0.2));
    CHECK(std::abs(r.mean - kMean) < 2.5 * std::sqrt(r.variance / 500.0));
    CHECK(r.coverage > 0.92);
    CHECK(r.spent <= 100.0);
    CHECK(r.spent > 95.0);
}

TEST_CASE("multi-fidelity: a probability, from two cheap limit states",
          "[uq][multi_fidelity][repeats]")
{
    // P(u1 + 0.2 u2 <= -1.2) by u1 + 0.1 u2 and u1.
    const double exact = gsl_cdf_ugaussian_P(-1.2 / std::sqrt(1.04));
    LimitState s =
        problems::limit_state(2, [](const VectorXd& x) { return x(0) + 0.2 * x(1); });
    s.threshold = -1.2;
    const std::vector<CheapModel> two{
        cheap([](const VectorXd& x) { return x(0); }, 0.001, -1.2),
        cheap([](const VectorXd& x) { return x(0) + 0.1 * x(1); }, 0.02, -1.2)};
    MultiFidelityOptions o;
    o.quantity = Quantity::probability;
    o.budget = 300.0;
    o.pilot = 50;
    const Repeated r = repeat(s, two, o, exact, 500);
    CHECK(r.variance < 0.6 * exact * (1.0 - exact) / 300.0);
    CHECK(r.reported == Approx(r.variance).epsilon(0.2));
    CHECK(std::abs(r.mean - exact) < 2.5 * std::sqrt(r.variance / 500.0));
    CHECK(r.coverage > 0.92);
}

TEST_CASE("multi-fidelity: a cheap model that does not pay leaves plain Monte Carlo",
          "[uq][multi_fidelity]")
{
    MultiFidelityOptions o;
    o.budget = 200.0;
    const MultiFidelityResult r = multi_fidelity(curved, {noise}, o);
    CHECK_FALSE(r.plan.pays);
    CHECK(r.reason == "correlations are too low for their costs");
    // 20 samples of the cheap model were paid for.
    REQUIRE(r.expensive.evaluations == 199);
    Ledger ledger;
    const VectorXd y = limit_values(curved, normal_rows(o.seed, 0, 199, 2), ledger);
    CHECK(r.estimate.value == Approx(y.mean()).epsilon(1e-13));
    CHECK(r.estimate.std_error == Approx(r.plain_std_error).epsilon(1e-11));
    CHECK(multi_fidelity(curved, {}, o).reason == "there is no cheap model");

    o.quantity = Quantity::probability; // never passed: no correlation is known
    const MultiFidelityResult never =
        multi_fidelity(problems::steel_section().limit,
                       {cheap([](const VectorXd& x) { return x(0); }, 0.01)}, o);
    CHECK(never.reason.find("no correlation in the pilot") == 0);
    CHECK(never.estimate.value == 0.0);
    CHECK(never.estimate.interval.upper ==
          core::binomial_interval(core::BinomialInterval::clopper_pearson, 0, 199, 0.95).upper);
}

TEST_CASE(
    "multi-fidelity: failed samples of the expensive model widen the bounds of a probability",
    "[uq][multi_fidelity]")
{
    LimitState s =
        problems::limit_state(2, [](const VectorXd& x) { return x(0) + 0.1 * x(1); });
    s.threshold = -1.0;
    s = problems::failing(s, [](const VectorXd& x) { return x(0) < -1.6; });
    MultiFidelityOptions o;
    o.quantity = Quantity::probability;
    o.budget = 1000.0;
    o.pilot = 100;
    const MultiFidelityResult r =
        multi_fidelity(s, {cheap([](const VectorXd& x) { return x(0); }, 0.01, -1.0)}, o);
    CHECK(r.plan.pays);
    CHECK(r.estimate.failed == r.expensive.failed.size());
    const double all = gsl_cdf_ugaussian_P(-1.0 / std::sqrt(1.01));
    const double failed = gsl_cdf_ugaussian_P(-1.6);
    CHECK(r.upper == Approx(all).epsilon(0.1));
    CHECK(r.upper - r.lower == Approx(failed).epsilon(0.3));
    CHECK(r.estimate.interval.lower < r.lower);
    CHECK(r.estimate.interval.upper > r.upper);
}

TEST_CASE("multi-fidelity: failed samples of a cheap model do not bias", "[uq][multi_fidelity]")
{
    CheapModel flawed = tangent;
    flawed.model =
        problems::failing(problems::limit_state(2, [](const VectorXd& x) { return x(0); }),
                          [](const VectorXd& x) { return x(0) > 1.3; })
            .model;
    MultiFidelityOptions o;
    o.budget = 100.0;
    const Repeated r = repeat(curved, {flawed}, o, kMean, 300);
    CHECK(std::abs(r.mean - kMean) < 2.5 * std::sqrt(r.variance / 300.0));
    CHECK(r.coverage > 0.91);
    CHECK(multi_fidelity(curved, {flawed}, o).cheap_failed.at(0) > 0);
}

TEST_CASE("multi-fidelity: costs that are not given are measured", "[uq][multi_fidelity]")
{
    double clock = 100.0; // [s], moved on by the models alone
    const auto busy = [&clock](double seconds) {
        return [&clock, seconds](const VectorXd& x) {
            clock += seconds;
            return x(0);
        };
    };
    MultiFidelityOptions o;
    o.expensive_cost = 0.0;
    o.budget = 0.2; // [s]
    o.now = [&clock] { return clock; };
    const MultiFidelityResult r =
        multi_fidelity(problems::limit_state(2, busy(1e-3)), {cheap(busy(1e-6), 0.0)}, o);
    CHECK(r.cost(0) == Approx(1e-3));
    CHECK(r.cost(1) == Approx(1e-6));
    CHECK(r.plan.pays);
    CHECK(r.spent == Approx(clock - 100.0));
    CHECK(r.spent < 0.21);
}

TEST_CASE("multi-fidelity: a steady clock measures where no other is given",
          "[uq][multi_fidelity]")
{
    const auto sleepy = [](const VectorXd& x) {
        std::this_thread::sleep_for(std::chrono::milliseconds(1)); // at least
        return x(0);
    };
    MultiFidelityOptions o;
    o.expensive_cost = 0.0;
    o.pilot = 10;
    o.budget = 9e-3; // [s], of at least 10e-3
    CHECK_THROWS_WITH(multi_fidelity(problems::limit_state(2, sleepy), {}, o),
                      Catch::Contains("does not reach for the pilot"));
}

TEST_CASE("multi-fidelity: the same seed gives the same bits", "[uq][multi_fidelity]")
{
    MultiFidelityOptions o;
    o.budget = 60.0;
    CHECK(multi_fidelity(curved, {tangent}, o).estimate.value ==
          multi_fidelity(curved, {tangent}, o).estimate.value);
}

TEST_CASE("multi-fidelity: what cannot be run is refused", "[uq][multi_fidelity]")
{
    MultiFidelityOptions o;
    CHECK_THROWS_AS(multi_fidelity(curved, {tangent}, o), std::invalid_argument); // no budget
    o.budget = 20.0;
    CHECK_THROWS_AS(multi_fidelity(curved, {tangent}, o), std::invalid_argument); // pilot: 20.2
    o.budget = 100.0;
    o.pilot = 9;
    CHECK_THROWS_AS(multi_fidelity(curved, {tangent}, o), std::invalid_argument);
    o.pilot = 20;
    CHECK_THROWS_AS(multi_fidelity(curved, {CheapModel{}}, o), std::invalid_argument);
    CheapModel unknown = tangent;
    unknown.cost = 0.0;
    CHECK_THROWS_AS(multi_fidelity(curved, {unknown}, o), std::invalid_argument);
    const LimitState none = problems::failing(curved, [](const VectorXd&) { return true; });
    CHECK_THROWS_AS(multi_fidelity(none, {tangent}, o), std::runtime_error);
}
