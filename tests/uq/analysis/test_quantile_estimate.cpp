#include "uq/estimates/quantile_estimate.hpp"

#include "core/interval.hpp"
#include "uq/designs/stream.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

using namespace uq;

namespace {

const double kNan = std::numeric_limits<double>::quiet_NaN();

auto near(double value, double tolerance)
{
    return Approx(value).epsilon(tolerance).margin(0.0);
}

std::vector<double> one_to(int n)
{
    std::vector<double> y;
    for (int i = n; i >= 1; --i) y.push_back(i);
    return y;
}

} // namespace

TEST_CASE("quantile: definition 8 of Hyndman and Fan", "[uq][quantile]")
{
    // R quantile(1:10, p, type = 8): place (n + 1/3) p + 1/3
    CHECK(estimate_quantile(one_to(10), 0.5).value == near(5.5, 1e-14));
    CHECK(estimate_quantile(one_to(10), 0.25).value ==
          near(10.0 / 3.0 * 0.775 + 1.0 / 3.0, 1e-14));
    CHECK(estimate_quantile(one_to(10), 0.9).value == near(9.3 + 1.0 / 3.0, 1e-14));
    CHECK(estimate_quantile(one_to(10), 0.001).value == 1.0);
    CHECK(estimate_quantile(one_to(10), 0.999).value == 10.0);
}

TEST_CASE("quantile: the interval is two values of the sample, from the binomial",
          "[uq][quantile]")
{
    // n = 20, median: P(B <= 5) = .0207, P(B <= 14) = .9793 -> 6th and 15th value
    const Estimate e = estimate_quantile(one_to(20), 0.5);
    CHECK(e.interval.lower == 6.0);
    CHECK(e.interval.upper == 15.0);
    // 95 % quantile of 20: no value is surely above
    CHECK(estimate_quantile(one_to(20), 0.95).interval.upper ==
          std::numeric_limits<double>::infinity());
    // two-sided 95 %: the largest of 72 has P(B = 72) = .95^72 = .0249
    CHECK(std::isinf(estimate_quantile(one_to(71), 0.95).interval.upper));
    CHECK(estimate_quantile(one_to(72), 0.95).interval.upper == 72.0);
}

TEST_CASE("quantile: failed samples are lowest for the lower limit and highest for the upper",
          "[uq][quantile]")
{
    std::vector<double> y = one_to(17);
    y.insert(y.end(), 3, kNan);
    const Estimate e = estimate_quantile(y, 0.5);
    CHECK(e.n == 17);
    CHECK(e.failed == 3);
    CHECK(e.value == near(9.0, 1e-14));
    CHECK(e.interval.lower == 3.0);  // 6th of 20 with three below all
    CHECK(e.interval.upper == 15.0); // 15th of 20 with three above all
    y.insert(y.end(), 17, kNan);
    CHECK(std::isinf(estimate_quantile(y, 0.5).interval.lower));
    CHECK(std::isinf(estimate_quantile(y, 0.5).interval.upper));
}

TEST_CASE("quantile: the interval holds the quantile at least as often as it says, of any law",
          "[uq][quantile][repeats]")
{
    const double p = GENERATE(0.05, 0.5, 0.8);
    const double truth = -std::log1p(-p);
    int held = 0;
    const int studies = 1500;
    for (int k = 0; k < studies; ++k) {
        Stream s(4, static_cast<std::uint64_t>(k), Purpose::monte_carlo);
        std::vector<double> y;
        for (int i = 0; i < 80; ++i) y.push_back(-std::log(s.uniform()));
        const core::Interval in = estimate_quantile(y, p).interval;
        held += in.lower <= truth && truth <= in.upper;
    }
    CHECK(held / double(studies) > 0.95 - 3.0 * std::sqrt(0.95 * 0.05 / studies));
    CHECK(held / double(studies) < 0.99);
}

TEST_CASE("quantile: the standard error is that of many samples", "[uq][quantile]")
{
    double squares = 0.0, variance = 0.0;
    for (int k = 0; k < 3000; ++k) {
        Stream s(5, static_cast<std::uint64_t>(k), Purpose::monte_carlo);
        std::vector<double> y;
        for (int i = 0; i < 50; ++i) y.push_back(s.normal());
        const Estimate e = estimate_quantile(y, 0.5);
        squares += e.value * e.value;
        variance += e.std_error * e.std_error;
    }
    CHECK(std::sqrt(variance / squares) == Approx(1.0).epsilon(0.1));
}

TEST_CASE("quantile: what is out of range is refused", "[uq][quantile]")
{
    CHECK_THROWS_AS(estimate_quantile(one_to(5), 0.0), std::invalid_argument);
    CHECK_THROWS_AS(estimate_quantile(one_to(5), 1.0), std::invalid_argument);
    CHECK_THROWS_AS(estimate_quantile(one_to(1), 0.5), std::invalid_argument);
}
