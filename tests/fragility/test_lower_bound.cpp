#include "fragility/binomial.hpp"
#include "fragility/lower_bound.hpp"

#include "tests/fragility/fit_data.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <stdexcept>

using namespace fragility;

namespace {

std::vector<Observation> stood(int n, double at)
{
    return std::vector<Observation>(static_cast<std::size_t>(n), right_censored(at));
}

} // namespace

TEST_CASE("lower bound: n walls that all stood bound the share that fails by 1 - 0.05^(1/n)",
          "[fragility][lower_bound]")
{
    const int n = GENERATE(1, 4, 5, 14, 50);
    const LowerBound b = lower_bound(stood(n, 0.028));
    CHECK(b.at == 0.028);
    CHECK(b.walls_at == n);
    CHECK(b.failed_at == 0.0);
    CHECK(b.probability_below == Approx(1.0 - std::pow(0.05, 1.0 / n)).epsilon(1e-12));
    CHECK(b.median_bounded == (n >= 5)); // 0.5^4 > 0.05 > 0.5^5
    CHECK(b.median_above == (n >= 5 ? 0.028 : 0.0));
}

TEST_CASE("lower bound: the highest stopping point with enough walls counts",
          "[fragility][lower_bound]")
{
    auto data = stood(5, 0.020);
    for (const Observation& o : stood(4, 0.030)) data.push_back(o);
    const LowerBound b = lower_bound(data);
    CHECK(b.median_above == 0.020); // nine walls tell there, four at 0.030
    CHECK(b.at == 0.030);
    CHECK(b.walls_at == 4.0);
}

TEST_CASE("lower bound: of observed values it is the sign test", "[fragility][lower_bound]")
{
    // P(X <= 3) = 0.018, P(X <= 4) = 0.059 for 15 tosses: above the fourth smallest value
    std::vector<double> values;
    for (int i = 1; i <= 15; ++i) values.push_back(i);
    const LowerBound b = lower_bound(fit_data::all_observed(values));
    CHECK(b.median_above == 4.0);
}

TEST_CASE("lower bound: a left-censored wall has failed, an interval tells at its ends only",
          "[fragility][lower_bound]")
{
    auto data = stood(9, 2.0);
    data.push_back(left_censored(1.0));
    const LowerBound b = lower_bound(data);
    CHECK(b.failed_at == 1.0);
    CHECK(b.walls_at == 10.0);
    CHECK(b.probability_below == Approx(binomial_upper_bound(1, 10)));
    data.back() = interval_censored(1.0, 3.0);
    CHECK(lower_bound(data).walls_at == 9.0);
}

TEST_CASE("lower bound: no data, no bound", "[fragility][lower_bound]")
{
    const LowerBound b = lower_bound({});
    CHECK_FALSE(b.median_bounded);
    CHECK(b.probability_below == 1.0);
    CHECK_THROWS_AS(lower_bound(stood(3, std::nan(""))), std::invalid_argument);
    CHECK_THROWS_AS(lower_bound(stood(3, 1.0), 0.0), std::invalid_argument);
}
