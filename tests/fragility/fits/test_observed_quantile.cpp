#include "fragility/fits/observed_quantile.hpp"

#include "core/binomial.hpp"
#include "fragility/laws/law.hpp"
#include "tests/fragility/fit_data.hpp"

#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <limits>
#include <vector>

using namespace fragility;

TEST_CASE("observed quantiles: without censoring the band of the share is that of Clopper and "
          "Pearson",
          "[fragility][observed_quantile]")
{
    std::vector<Observation> data;
    std::vector<double> values;
    for (int i = 1; i <= 25; ++i) data.push_back(observed(i));
    for (int i = 0; i < 25; ++i) values.push_back(i + 0.5);
    const auto found = observed_shares(data, values);
    for (std::size_t i = 0; i < values.size(); ++i) {
        const auto exact = share(static_cast<double>(i), 25.0, 0.0,
                                 core::BinomialInterval::clopper_pearson, 0.95);
        CHECK(found[i].share == Approx(static_cast<double>(i) / 25.0).margin(1e-12));
        CHECK(found[i].band.lower == Approx(exact.interval.lower).margin(1e-9));
        CHECK(found[i].band.upper == Approx(exact.interval.upper).margin(1e-9));
    }
}

TEST_CASE("observed quantiles: they are values that occurred, and bounds that the walls do not "
          "give are open",
          "[fragility][observed_quantile]")
{
    std::vector<Observation> data;
    for (int i = 0; i < 15; ++i) data.push_back(observed(0.76 + 0.002 * i));
    for (int i = 0; i < 10; ++i) data.push_back(right_censored(2.7));
    const std::array shares = {0.05, 0.5, 0.84};
    const auto q = observed_quantiles(data, shares);
    CHECK(*q[0].value == 0.762);       // 2 of 25 are the first 5 %
    CHECK(q[0].interval.lower == 0.0); // none of 25 may have failed below it
    CHECK(q[0].interval.upper < 0.78);
    CHECK(*q[1].value == 0.76 + 0.002 * 12);
    CHECK(q[1].interval.lower > 0.76);
    CHECK_FALSE(q[2].value.has_value());
    CHECK(q[2].interval.lower > 0.78);
    CHECK(std::isinf(q[2].interval.upper));
}

TEST_CASE("observed quantiles: a share that walls reach exactly is that of the wall that "
          "completes it",
          "[fragility][observed_quantile]")
{
    constexpr std::array percent = {5, 16, 50, 84, 95};
    const std::array shares = {0.05, 0.16, 0.50, 0.84, 0.95};
    for (int n = 8; n <= 100; ++n) {
        std::vector<Observation> data;
        for (int i = 1; i <= n; ++i) data.push_back(observed(i));
        const auto found = observed_quantiles(data, shares);
        for (std::size_t i = 0; i < shares.size(); ++i) {
            const int rank = (n * percent[i] + 99) / 100;
            INFO(n << " walls, " << percent[i] << " %");
            CHECK(*found[i].value == rank);
        }
    }
}

TEST_CASE("observed quantiles: of walls in two heaps, some stopped between them, intervals "
          "hold the truth in "
          "95 of 100 samples or more",
          "[fragility][observed_quantile]")
{
    // quarters of the distribution: 1 + u / 10 for 60 % of the walls, 3 + u for the others; a
    // run stops anywhere in 0.5 to 5
    const std::array shares = {0.16, 0.5};
    const std::array truth = {1.0 + 0.1 * 0.16 / 0.6, 1.0 + 0.1 * 0.5 / 0.6};
    std::array<int, 2> held{};
    constexpr int kStudies = 600;
    for (std::uint64_t s = 0; s < kStudies; ++s) {
        std::vector<Observation> data;
        for (std::uint64_t k = 0; k < 30; ++k) {
            const auto u = [&](std::uint64_t i) {
                return uniform(fit_data::bits(40'000 + s, 3 * k + i));
            };
            const double x = u(0) < 0.6 ? 1.0 + 0.1 * u(1) : 3.0 + u(1);
            const double stop = 0.5 + 4.5 * u(2);
            data.push_back(x < stop ? observed(x) : right_censored(stop));
        }
        const auto q = observed_quantiles(data, shares);
        for (std::size_t i = 0; i < 2; ++i)
            held[i] += q[i].interval.lower <= truth[i] && truth[i] <= q[i].interval.upper;
    }
    for (const int h : held) CHECK(h >= 0.94 * kStudies); // standard error 0.9 %
}

TEST_CASE("observed quantiles: what is no number or no right-censored value is refused",
          "[fragility][observed_quantile]")
{
    const std::array half = {0.5};
    const std::vector<Observation> left = {left_censored(1.0)};
    CHECK_THROWS_AS(observed_quantiles(left, half), std::invalid_argument);
    const std::vector<Observation> nan = {observed(std::numeric_limits<double>::quiet_NaN())};
    CHECK_THROWS_AS(observed_quantiles(nan, half), std::invalid_argument);
    CHECK_THROWS_AS(observed_quantiles({}, half, 1.0), std::invalid_argument);
    const auto none = observed_quantiles({}, half);
    CHECK_FALSE(none[0].value.has_value());
    CHECK(none[0].interval.lower == 0.0);
}
