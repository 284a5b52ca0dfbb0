#include "uq/reliability/simulation/multi_fidelity_plan.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <stdexcept>

using namespace uq;

namespace {

/// Variance of the estimate for unit variances and known coefficients (eq. 3.6).
double variance(const std::vector<double>& n, const std::vector<double>& rho)
{
    double v = 1.0 / n[0];
    for (std::size_t i = 1; i < n.size(); ++i)
        v -= (1.0 / n[i - 1] - 1.0 / n[i]) * rho[i - 1] * rho[i - 1];
    return v;
}

} // namespace

TEST_CASE("multi-fidelity plan: one cheap model, in closed form", "[uq][multi_fidelity_plan]")
{
    const double rho = 0.95, w = 0.01;
    const CheapQuality cheap[] = {{w, rho}};
    const EffortPlan p = plan_effort(1.0, cheap, 1000.0);
    REQUIRE(p.pays);
    CHECK(p.variance_ratio ==
          Approx(std::pow(std::sqrt(1 - rho * rho) + std::sqrt(w) * rho, 2)).epsilon(1e-13));
    const double r = std::sqrt(rho * rho / (w * (1 - rho * rho)));
    const double n0 = 1000.0 / (1.0 + w * r);
    CHECK(p.samples[0] == static_cast<std::size_t>(n0));
    CHECK(p.samples[1] == static_cast<std::size_t>(n0 * r));
    // The plan has the variance predicted, at the cost allowed.
    const std::vector<double> n{static_cast<double>(p.samples[0]),
                                static_cast<double>(p.samples[1])};
    CHECK(variance(n, {rho}) == Approx(p.variance_ratio / 1000.0).epsilon(2e-3));
    CHECK(n[0] + w * n[1] <= 1000.0);
}

TEST_CASE("multi-fidelity plan: no other split of the same effort has less variance",
          "[uq][multi_fidelity_plan]")
{
    const CheapQuality cheap[] = {{0.001, 0.7}, {0.05, 0.95}};
    const EffortPlan p = plan_effort(1.0, cheap, 10000.0);
    REQUIRE(p.use == std::vector<std::size_t>{1, 0});
    const std::vector<double> n(p.samples.begin(), p.samples.end());
    const double best = variance(n, {0.95, 0.7});
    CHECK(best == Approx(p.variance_ratio / 10000.0).epsilon(1e-3));
    for (const double a : {0.8, 0.95, 1.05, 1.2})
        for (const double b : {0.8, 0.95, 1.05, 1.2}) {
            const double n1 = a * n[1], n2 = b * n[2];
            const double n0 = 10000.0 - 0.05 * n1 - 0.001 * n2;
            CHECK(variance({n0, n1, n2}, {0.95, 0.7}) > best);
        }
}

TEST_CASE("multi-fidelity plan: a model that is both dearer and worse is left out",
          "[uq][multi_fidelity_plan]")
{
    const CheapQuality cheap[] = {{0.02, 0.6}, {0.01, 0.9}};
    const EffortPlan p = plan_effort(1.0, cheap, 1000.0);
    CHECK(p.use == std::vector<std::size_t>{1});
    const CheapQuality alone[] = {{0.01, 0.9}};
    CHECK(p.variance_ratio == plan_effort(1.0, alone, 1000.0).variance_ratio);
}

TEST_CASE("multi-fidelity plan: what does not pay is not used", "[uq][multi_fidelity_plan]")
{
    const auto pays = [](double cost, double rho) {
        const CheapQuality cheap[] = {{cost, rho}};
        const EffortPlan p = plan_effort(1.0, cheap, 500.0);
        CHECK(p.pays != p.use.empty());
        if (!p.pays) {
            CHECK(p.samples == std::vector<std::size_t>{500});
            CHECK(p.variance_ratio == 1.0);
        }
        return p.pays;
    };
    CHECK_FALSE(pays(0.01, 0.0));
    CHECK_FALSE(pays(0.5, 0.8)); // ratio 1.36
    CHECK_FALSE(pays(1.0, 0.99));
    CHECK(pays(0.01, 0.5));
    CHECK(pays(0.01, -0.9));
    CHECK_FALSE(plan_effort(2.0, {}, 500.0).pays);
    CHECK(plan_effort(2.0, {}, 500.0).samples == std::vector<std::size_t>{250});
}

TEST_CASE(
    "multi-fidelity plan: expensive samples that there are in any case leave the rest to the "
    "cheap",
    "[uq][multi_fidelity_plan]")
{
    const CheapQuality cheap[] = {{0.01, 0.999}};
    const EffortPlan p = plan_effort(1.0, cheap, 100.0, 50);
    CHECK(p.samples[0] == 50);
    CHECK(p.samples[1] == 5000);
}

TEST_CASE("multi-fidelity plan: input out of range is refused", "[uq][multi_fidelity_plan]")
{
    const CheapQuality free[] = {{0.0, 0.9}}, wrong[] = {{0.1, 1.1}}, good[] = {{0.1, 1.0}};
    CHECK_THROWS_AS(plan_effort(1.0, free, 10.0), std::invalid_argument);
    CHECK_THROWS_AS(plan_effort(1.0, wrong, 10.0), std::invalid_argument);
    CHECK_THROWS_AS(plan_effort(0.0, good, 10.0), std::invalid_argument);
    CHECK_THROWS_AS(plan_effort(1.0, good, 10.0, 11), std::invalid_argument);
    CHECK_THROWS_AS(plan_effort(1.0, good, 10.0, 0), std::invalid_argument);
    CHECK_NOTHROW(plan_effort(1.0, good, 10.0));
}
