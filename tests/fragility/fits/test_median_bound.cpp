#include "core/binomial.hpp"
#include "fragility/fits/bootstrap_random.hpp"
#include "fragility/fits/median_bound.hpp"
#include "fragility/laws/law.hpp"

#include "tests/fragility/fit_data.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>

using namespace fragility;

namespace {

std::vector<Observation> stood(int n, double at)
{
    return std::vector<Observation>(static_cast<std::size_t>(n), right_censored(at));
}

double all_stood(double n) { return 1.0 - std::pow(0.05, 1.0 / n); }

constexpr Distribution kTruth{Law::lognormal, 0.0, 0.5};

/// Walls of kTruth, stopped anywhere between 0.5 and 3 times its median.
std::vector<Observation> stopped_anywhere(std::uint64_t study, std::size_t n)
{
    std::vector<Observation> data;
    for (std::size_t k = 0; k < n; ++k) {
        const double x = quantile(kTruth, uniform(fit_data::bits(study, 2 * k)));
        const double end = 0.5 + 2.5 * uniform(fit_data::bits(study, 2 * k + 1));
        data.push_back(x < end ? observed(x) : right_censored(end));
    }
    return data;
}

} // namespace

TEST_CASE("median bound: n walls that all stood bound the share that fails by 1 - 0.05^(1/n)",
          "[fragility][median_bound]")
{
    const int n = GENERATE(1, 4, 5, 14, 50);
    const ReachedBound at = reached_at_most(stood(n, 0.028), 0.028);
    CHECK(at.walls == n);
    CHECK(at.failed == 0.0);
    CHECK(at.at_most == Approx(all_stood(n)).epsilon(1e-12));
    CHECK(reached_at_most(stood(n, 0.028), 0.0281).at_most == 1.0);
    const MedianBound b = median_bound(stood(n, 0.028));
    CHECK(b.median_bounded == (n >= 5)); // 0.5^4 > 0.05 > 0.5^5
    CHECK(b.median_above == (n >= 5 ? 0.028 : 0.0));
    CHECK(b.strictly == (n >= 5));
}

TEST_CASE(
    "median bound: where runs end apart, all walls that went on bound the share that fails",
    "[fragility][median_bound]")
{
    std::vector<Observation> data; // stopped at 1, 2, ... 50: 51 - x stood at x
    for (int i = 1; i <= 50; ++i) data.push_back(right_censored(i));
    for (const double x : {0.5, 1.0, 1.5, 20.0, 49.5, 50.0})
        CHECK(reached_at_most(data, x).at_most == Approx(all_stood(51.0 - std::ceil(x))));
    CHECK(reached_at_most(data, 50.5).at_most == 1.0);
    CHECK(median_bound(data).median_above == 46.0); // five stood there
    data.push_back(observed(30.0));
    CHECK(reached_at_most(data, 40.0).at_most == Approx(core::binomial_upper_bound(1, 12)));
}

TEST_CASE("median bound: no value beyond gives a better bound", "[fragility][median_bound]")
{
    for (std::uint64_t study = 0; study < 20; ++study) {
        auto data = stopped_anywhere(study, 20);
        data.push_back(left_censored(0.7));
        data.push_back(Observation{0.6, 1.6});
        double last = 0.0;
        for (double x = 0.05; x < 3.5; x += 0.05) {
            const double at_most = reached_at_most(data, x).at_most;
            CHECK(at_most >= last);
            last = at_most;
        }
    }
}

TEST_CASE("median bound: in 95 of 100 studies stopped anywhere it holds the truth",
          "[fragility][median_bound]")
{
    constexpr int kStudies = 4000;
    const double allowed = 0.05 + 3.0 * std::sqrt(0.05 * 0.95 / kStudies);
    for (const double share : {0.1, 0.3, 0.5, 0.8}) {
        const double x = quantile(kTruth, share);
        int missed = 0;
        for (std::uint64_t i = 0; i < kStudies; ++i)
            missed += reached_at_most(stopped_anywhere(i, 30), x).at_most < share;
        CHECK(missed <= allowed * kStudies);
        CHECK(missed > 0); // else it would say nothing
    }
    int missed = 0;
    for (std::uint64_t i = 0; i < kStudies; ++i)
        missed += median_bound(stopped_anywhere(i, 30)).median_above > 1.0;
    CHECK(missed <= allowed * kStudies);
    CHECK(missed > 0);
}

TEST_CASE("median bound: the highest stopping point with enough walls counts",
          "[fragility][median_bound]")
{
    auto data = stood(5, 0.020);
    for (const Observation& o : stood(4, 0.030)) data.push_back(o);
    CHECK(median_bound(data).median_above == 0.020); // nine walls tell there, four at 0.030
}

TEST_CASE(
    "median bound: of observed values it is the sign test, and the median may be the bound",
    "[fragility][median_bound]")
{
    // P(X <= 3) = 0.018, P(X <= 4) = 0.059 for 15 tosses: not below the fourth smallest value
    std::vector<double> values;
    for (int i = 1; i <= 15; ++i) values.push_back(i);
    const MedianBound b = median_bound(fit_data::all_observed(values));
    CHECK(b.median_above == 4.0);
    CHECK_FALSE(b.strictly);
}

TEST_CASE("median bound: the median is above a value only if enough walls stood at it",
          "[fragility][median_bound]")
{
    auto data = stood(5, 2.5);
    data.push_back(observed(2.5)); // 1 of 6: at most 0.58
    CHECK(median_bound(data).median_above == 2.5);
    CHECK_FALSE(median_bound(data).strictly);
    for (int i = 0; i < 3; ++i) data.push_back(right_censored(2.5)); // 1 of 9: at most 0.43
    CHECK(median_bound(data).strictly);
    CHECK_FALSE(median_bound(std::vector(9, observed(2.5))).strictly);
}

TEST_CASE("median bound: a left-censored wall has failed, an interval tells at its ends only",
          "[fragility][median_bound]")
{
    auto data = stood(9, 2.0);
    data.push_back(left_censored(1.0));
    CHECK(reached_at_most(data, 2.0).failed == 1.0);
    CHECK(reached_at_most(data, 2.0).walls == 10.0);
    CHECK(reached_at_most(data, 2.0).at_most == Approx(core::binomial_upper_bound(1, 10)));
    data.back() = Observation{1.0, 3.0};
    CHECK(reached_at_most(data, 2.0).walls == 9.0);
    CHECK(reached_at_most(data, 0.9).walls == 10.0);
}

TEST_CASE("median bound: no data, no bound", "[fragility][median_bound]")
{
    CHECK_FALSE(median_bound({}).median_bounded);
    CHECK(reached_at_most({}, 1.0).at_most == 1.0);
    CHECK_THROWS_AS(median_bound(stood(3, std::nan(""))), std::invalid_argument);
    CHECK_THROWS_AS(median_bound(stood(3, 1.0), 0.0), std::invalid_argument);
    CHECK_THROWS_AS(reached_at_most(stood(3, 1.0), 1.0, 1.0), std::invalid_argument);
}
