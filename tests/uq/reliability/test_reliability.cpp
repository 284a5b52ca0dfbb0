#include "uq/reliability/reliability.hpp"

#include "tests/uq/reliability/reliability_problems.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

/// FORM of g(u) in two variables, whose answers scatter by some share of 1.
uq::ReliabilityProblem form_of(const std::function<double(double, double)>& g, double scatter)
{
    uq::ReliabilityProblem p;
    p.event.dimension = 2;
    p.event.model = [g, scatter](const uq::Samples& s) {
        uq::Responses r{Eigen::MatrixXd(s.x.rows(), 1),
                        std::vector<std::string>(static_cast<std::size_t>(s.x.rows()))};
        for (Eigen::Index i = 0; i < s.x.rows(); ++i) // a model without chance, yet rough
            r.y(i, 0) = g(s.x(i, 0), s.x(i, 1)) +
                        scatter * std::sin(1e5 * (s.x(i, 0) + 2.0 * s.x(i, 1)));
        return r;
    };
    p.inputs = p.normal = {"a", "b"};
    p.method = uq::ReliabilityMethod::form;
    p.rough = scatter > 0.0;
    return p;
}

} // namespace

TEST_CASE(
    "reliability: FORM of a model that scatters finds its design point within the scatter",
    "[uq][reliability]")
{
    // a plane at beta = 3; the scatter is 1 % of a standard deviation of the response
    const uq::ReliabilityProblem p =
        form_of([](double a, double b) { return 3.0 - 0.8 * a - 0.6 * b; }, 0.01);
    const uq::ReliabilityAnswer a = reliability(p);
    REQUIRE(a.methods.front().probability);
    CHECK(*a.methods.front().probability == Approx(1.349898e-3).epsilon(0.15));
    REQUIRE_FALSE(a.points.empty());
    CHECK(a.points.front().beta == Approx(3.0).epsilon(0.01));
    CHECK(a.sensitivities.front().shares[0].value == Approx(0.64).margin(0.08));
    CHECK(
        a.methods.front().outcome ==
        "two searches found the same point; 100 checks in other directions (at 1.2 beta) found "
        "no other failure region");
    CHECK(a.warnings.empty());
}

TEST_CASE("reliability: FORM says that the four-branch function has further design points",
          "[uq][reliability]")
{
    const auto four = [](double a, double b) {
        const double bend = 3.0 + 0.1 * (a - b) * (a - b), sum = (a + b) / std::sqrt(2.0);
        const double cut = 7.0 / std::sqrt(2.0);
        return std::min({bend - sum, bend + sum, a - b + cut, b - a + cut});
    };
    const uq::ReliabilityAnswer a = reliability(form_of(four, 0.0));
    const auto told = [](const std::string& w) {
        return w.find("occurs elsewhere") != std::string::npos ||
               w.find("design points and gives the probability of the nearest") !=
                   std::string::npos;
    };
    CHECK(std::any_of(a.warnings.begin(), a.warnings.end(), told));
    CHECK(a.methods.front().outcome.find("same point") == std::string::npos);
}

namespace {

uq::ReliabilityProblem by(uq::ReliabilityMethod method, const uq::LimitState& event)
{
    uq::ReliabilityProblem p;
    p.event = event;
    for (Eigen::Index i = 0; i < event.dimension; ++i)
        p.normal.push_back("u" + std::to_string(i + 1));
    p.inputs = p.normal;
    p.method = method;
    return p;
}

} // namespace

TEST_CASE("reliability: every method has R - S within its doubt, and shows all its evaluations",
          "[uq][reliability]")
{
    const problems::Problem exact = problems::difference_4_2();
    const auto method =
        GENERATE(uq::ReliabilityMethod::monte_carlo, uq::ReliabilityMethod::form,
                 uq::ReliabilityMethod::importance, uq::ReliabilityMethod::subset,
                 uq::ReliabilityMethod::multi_fidelity, uq::ReliabilityMethod::sobol,
                 uq::ReliabilityMethod::active);
    uq::ReliabilityProblem p = by(method, exact.limit);
    p.cheap = {{.model = exact.limit.model, .cost = 0.01, .threshold = exact.limit.threshold}};
    std::size_t seen = 0;
    const uq::ReliabilityAnswer a =
        uq::reliability(p, [&](std::span<const uq::Evaluated> batch) { seen += batch.size(); });
    REQUIRE(a.methods.front().probability);
    const double error = std::abs(*a.methods.front().probability - exact.exact);
    CHECK(error <= 4.0 * a.methods.front().std_error.value_or(1e-7));
    CHECK(seen == a.evaluations);
    CHECK(a.evaluations <= 1000);
}

TEST_CASE("reliability: what is missing or too small is refused by name", "[uq][reliability]")
{
    using uq::ReliabilityMethod;
    const uq::LimitState event = problems::difference_4_2().limit;
    uq::ReliabilityProblem p = by(ReliabilityMethod::subset, event);
    p.budget = 49;
    CHECK_THROWS_WITH(uq::reliability(p), Catch::Contains("must be at least 50"));
    CHECK(uq::budget_too_small(ReliabilityMethod::subset, 50, 2).empty());
    p = by(ReliabilityMethod::active, event);
    p.budget = 47;
    CHECK_THROWS_WITH(uq::reliability(p), Catch::Contains("must be at least 48"));
    p = by(ReliabilityMethod::multi_fidelity, event);
    CHECK_THROWS_WITH(uq::reliability(p), Catch::Contains("cheap model"));
    p = by(ReliabilityMethod::form, event);
    p.normal.pop_back();
    CHECK_THROWS_WITH(uq::reliability(p), Catch::Contains("each of the 2 coordinates"));
    p = by(ReliabilityMethod::form, event);
    p.inputs.push_back("one too many");
    CHECK_THROWS_WITH(uq::reliability(p), Catch::Contains("each of the 2 inputs"));
    p = by(ReliabilityMethod::form, {});
    CHECK_THROWS_AS(uq::reliability(p), std::invalid_argument);
}

TEST_CASE("reliability: subset simulation spends its budget, or says what would not fit",
          "[uq][reliability]")
{
    uq::ReliabilityProblem p = by(uq::ReliabilityMethod::subset, problems::rp22().limit);
    p.budget = 2000;
    p.target_cov = 0.01;
    const uq::ReliabilityAnswer a =
        uq::reliability(p); // 4e-3: three levels of 400, 1120 in all
    CHECK(a.evaluations == 1120);
    CHECK(a.methods.front().outcome ==
          "target coefficient of variation not reached: another run "
          "would not fit into the budget of 2000");
    p.budget = 1000;                            // two levels of 200, or three: two runs
    p.event = problems::difference_4_2().limit; // 8e-2: two levels
    const uq::ReliabilityAnswer b = uq::reliability(p);
    CHECK(b.evaluations > 1000 - 380);
    CHECK(b.evaluations <= 1000);
    p.budget = 50; // five levels of ten do not reach 1e-7
    p.event = problems::steel_section().limit;
    for (const uq::MethodAnswer& m : uq::reliability(p).methods)
        CHECK(m.outcome.find("another run") == std::string::npos);
}

TEST_CASE("reliability: Sobol' indices are shares, and a first one above its total is said",
          "[uq][reliability]")
{
    // a sum: first and total are equal, so that their errors cross; the third input does
    // nothing
    uq::ReliabilityProblem p =
        by(uq::ReliabilityMethod::sobol, problems::limit_state(3, [](const Eigen::VectorXd& x) {
               return 4.0 - 3.0 * x(0) - x(1);
           }));
    int crossed = 0;
    for (p.seed = 1; p.seed <= 20; ++p.seed) {
        p.budget = 50;
        const uq::ReliabilityAnswer a = uq::reliability(p);
        REQUIRE(a.sensitivities.size() == 2);
        for (const uq::Sensitivity& s : a.sensitivities)
            for (const uq::InputShare& i : s.shares) {
                CHECK(i.value >= 0.0);
                CHECK(i.value <= 1.0);
                CHECK(*i.lower >= 0.0);
                CHECK(*i.upper <= 1.0);
            }
        std::string said;
        for (const std::string& w : a.warnings)
            if (w.find("not told apart") != std::string::npos) said = w;
        for (std::size_t i = 0; i < 3; ++i) {
            const bool above = a.sensitivities[0].shares[i].value >
                               a.sensitivities[1].shares[i].value; // clipping keeps the order
            if (above) CHECK(said.find("u" + std::to_string(i + 1)) != std::string::npos);
            crossed += above ? 1 : 0;
        }
    }
    CHECK(crossed > 5);
}

TEST_CASE("reliability: FORM shares an event among correlated inputs whatever their order",
          "[uq][reliability]")
{
    const problems::Problem log_ratio = problems::log_ratio(0.4);
    const uq::ReliabilityAnswer a =
        uq::reliability(by(uq::ReliabilityMethod::form, log_ratio.limit));
    REQUIRE(a.sensitivities.size() == 1);
    CHECK(a.sensitivities[0].measure == "gamma^2 of FORM");
    for (const uq::InputShare& i : a.sensitivities[0].shares)
        CHECK(i.value == Approx(0.5).margin(1e-4));
}
