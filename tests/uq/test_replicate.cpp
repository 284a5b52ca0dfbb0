#include "uq/estimates/replicate.hpp"

#include "tests/uq/latin_scene.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>
#include <set>
#include <stdexcept>

using namespace uq;

namespace {

/// Mean of the sum of 5 uniform variables by one Latin hypercube of 50: exact sd of the mean
/// sqrt(d / (12 n^3)) = 1.8257e-3, with n independent samples sqrt(d / (12 n)) = 9.1287e-2.
std::vector<double> sums(std::uint64_t seed)
{
    const Eigen::VectorXd y = scenes::latin_hypercube(50, 5, seed).rowwise().sum();
    return {y.begin(), y.end()};
}

double mean_of_sums(std::uint64_t seed) { return moments(sums(seed)).mean; }

} // namespace

TEST_CASE("replicate: one Latin hypercube cannot tell its error, replicated ones can",
          "[uq][replicate]")
{
    const double exact = std::sqrt(5.0 / (12.0 * 50.0 * 50.0 * 50.0));
    const Replicates r = replicate(400, 3, mean_of_sums);
    CHECK(r.estimate.std_error * 20.0 == Approx(exact).epsilon(4.0 / std::sqrt(800.0)));
    CHECK(std::abs(r.estimate.value - 2.5) < 4.0 * exact / 20.0);
    // s / sqrt(n) of a single design: fifty times too large
    CHECK(estimate_mean(sums(3)).std_error / exact > 40.0);
    CHECK(estimate_mean(sums(3)).std_error == Approx(9.128709292e-2).epsilon(0.3));
}

TEST_CASE("replicate: its interval holds the truth as often as it says", "[uq][replicate]")
{
    const int studies = 1000;
    int held = 0, naive_held = 0;
    for (int k = 0; k < studies; ++k) {
        const auto seed = static_cast<std::uint64_t>(1000 + k);
        const Interval i = replicate(8, seed, mean_of_sums).estimate.interval;
        held += i.lower <= 2.5 && 2.5 <= i.upper;
        const Interval naive = estimate_mean(sums(seed)).interval;
        naive_held += naive.lower <= 2.5 && 2.5 <= naive.upper;
    }
    CHECK(std::abs(held / double(studies) - 0.95) < 3.0 * std::sqrt(0.95 * 0.05 / studies));
    CHECK(naive_held == studies);
}

TEST_CASE("replicate: replicate 0 is the study itself, each has a seed of its own",
          "[uq][replicate]")
{
    std::set<std::uint64_t> seeds;
    std::uint64_t first = 0;
    const Replicates r = replicate(20, 77, [&](std::uint64_t seed) {
        if (seeds.empty()) first = seed;
        seeds.insert(seed);
        return mean_of_sums(seed);
    });
    CHECK(first == 77);
    CHECK(seeds.size() == 20);
    CHECK(r.each[0] == mean_of_sums(77));
    CHECK(r.estimate.n == 20);
}

TEST_CASE("replicate: a failed replicate is counted; fewer than two are no estimate",
          "[uq][replicate]")
{
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const Estimate e = combine_replicates(std::vector<double>{1.0, nan, 3.0});
    CHECK(e.value == 2.0);
    CHECK(e.n == 2);
    CHECK(e.failed == 1);
    CHECK_THROWS_AS(combine_replicates(std::vector<double>{1.0, nan}), std::invalid_argument);
}
