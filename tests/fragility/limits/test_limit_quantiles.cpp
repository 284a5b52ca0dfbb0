#include "fragility/limits/limit_quantiles.hpp"

#include "core/interval.hpp"
#include "fragility/fits/two_heaps.hpp"
#include "fragility/laws/small_sample.hpp"
#include "fragility/laws/standard_law.hpp"
#include "fragility/limits/possible_laws.hpp"
#include "tests/fragility/fit_data.hpp"

#include <catch2/catch.hpp>

#include <boost/math/distributions/students_t.hpp>

#include <cmath>
#include <numeric>
#include <vector>

using namespace fragility;

namespace {

/// 70 % of the walls fall around 1.5 %, 30 % around 9 %; runs end at `end`.
std::vector<ModeGroup> two_heaps(std::size_t walls, double end, std::uint64_t which)
{
    std::vector<ModeGroup> modes(2);
    for (std::size_t k = 0; k < walls; ++k) {
        const auto u = [&](std::uint64_t i) {
            return uniform(fit_data::bits(7'000'000 + which, 2 * k + i));
        };
        const std::size_t mode = u(0) < 0.7 ? 0 : 1;
        const Distribution law = mode == 0 ? Distribution{Law::lognormal, std::log(1.5), 0.45}
                                           : Distribution{Law::lognormal, std::log(9.0), 0.12};
        const double x = quantile(law, u(1));
        modes[mode].limits.push_back(x < end ? observed(x) : right_censored(end));
    }
    return modes;
}

std::vector<Observation> all_of(const std::vector<ModeGroup>& modes)
{
    std::vector<Observation> all;
    for (const ModeGroup& m : modes) all.insert(all.end(), m.limits.begin(), m.limits.end());
    return all;
}

LimitQuantiles limits_of(const std::vector<ModeGroup>& modes, bool described = true)
{
    return limit_quantiles({modes, described},
                           performance_limits(Law::lognormal, all_of(modes)));
}

} // namespace

TEST_CASE(
    "limit quantiles: walls are tested to the end of their pushes, without end where all fell",
    "[fragility][limit_quantiles]")
{
    using fragility::tested_to;
    std::vector<Observation> walls;
    CHECK(tested_to(walls) == 0.0);
    for (int i = 1; i <= 20; ++i) walls.push_back(observed(0.1 * i));
    CHECK(tested_to(walls) == core::kInfinity);
    auto stopped = walls;
    for (int i = 0; i < 10; ++i) stopped.push_back(right_censored(2.72));
    CHECK(tested_to(stopped) == 2.72);
    // one wall that ended early leaves those that went on; eleven for two do not
    auto one = walls;
    one.push_back(right_censored(0.05));
    CHECK(tested_to(one) == walls.back().lower);
    auto few = std::vector<Observation>(11, right_censored(1.0));
    few.push_back(observed(3.0));
    few.push_back(observed(4.0));
    CHECK(tested_to(few) == 1.0);
}

TEST_CASE("limit quantiles: of walls that all fell under one law they are the law's",
          "[fragility][limit_quantiles]")
{
    const auto walls = fit_data::all_observed(fit_data::lognormal350);
    const PerformanceLimits law = performance_limits(Law::lognormal, walls);
    const LimitQuantiles found = limit_quantiles({{{walls}}}, law);
    CHECK(found.source == QuantileSource::law);
    REQUIRE(found.at.size() == 5);
    for (std::size_t i = 0; i < 5; ++i) {
        CHECK(found.at[i].value == law.drifts[i].drift);
        CHECK(found.at[i].interval.upper == law.drifts[i].interval.upper);
        CHECK_FALSE(found.at[i].observed);
    }
    CHECK(limit_quantiles({{{walls}}, false}, law).source == QuantileSource::observed);
}

TEST_CASE("limit quantiles: of two modes that fall they are the mixture turned round",
          "[fragility][limit_quantiles]")
{
    const auto modes = two_heaps(60, core::kInfinity, 1);
    const LimitQuantiles found = limits_of(modes);
    CHECK(found.source == QuantileSource::mixture);
    REQUIRE(found.at.size() == 5);
    for (const LimitQuantile& q : found.at) {
        REQUIRE(q.value);
        const auto point = mixture_curve(modes, std::vector{*q.value}).points.front();
        CHECK(point.least == Approx(q.share).epsilon(1e-9));
        CHECK(q.interval.lower < *q.value);
        CHECK(q.interval.upper > *q.value);
        // by Student's quantile, the interval is a little wider than the band turned round
        const auto ends =
            mixture_curve(modes, std::vector{q.interval.lower, q.interval.upper}).points;
        CHECK(ends[0].band.upper == Approx(q.share).epsilon(0.1));
        CHECK(ends[1].band.lower == Approx(q.share).epsilon(0.1));
    }
}

TEST_CASE("limit quantiles: beyond the drift tested there is a lower bound and nothing else",
          "[fragility][limit_quantiles]")
{
    constexpr double kEnd = 2.73;
    const auto modes = two_heaps(60, kEnd, 2);
    const auto walls = all_of(modes);
    const std::vector<std::vector<ModeGroup>> told_or_not = {modes, {{walls}}};
    for (const auto& groups : told_or_not) {
        const LimitQuantiles found = limits_of(groups);
        CHECK(found.tested_to == kEnd);
        for (const std::size_t i : {3U, 4U}) {
            CHECK_FALSE(found.at[i].value);
            CHECK(found.at[i].interval.lower <= kEnd);
            CHECK(found.at[i].interval.lower > 1.0);
            CHECK(found.at[i].interval.upper == core::kInfinity);
        }
        CHECK(found.at[4].interval.lower == kEnd); // 30 % of the walls stand there
        for (const LimitQuantile& q : found.at)
            if (q.value) CHECK(*q.value <= kEnd);
    }
    // one law is read where it rests on walls that fell, the shares above that
    const LimitQuantiles one = limits_of({{walls}});
    CHECK(one.source == QuantileSource::law);
    CHECK_FALSE(one.at[0].observed);
    CHECK(one.at[2].observed);
}

TEST_CASE("limit quantiles: heaps that lie apart need nobody to tell the modes",
          "[fragility][limit_quantiles]")
{
    const auto modes = two_heaps(60, core::kInfinity, 1);
    auto mistaken = modes;
    std::swap(mistaken[0].limits.front(), mistaken[1].limits.front());
    mistaken[1].described = false; // as the tests find
    const LimitQuantiles told = limits_of(modes);
    for (const auto& said : {std::vector<ModeGroup>{{all_of(modes)}}, mistaken}) {
        const LimitQuantiles found = limits_of(said);
        CHECK(found.source == QuantileSource::heaps);
        for (std::size_t i = 0; i < found.at.size(); ++i)
            CHECK(*found.at[i].value == Approx(*told.at[i].value).epsilon(1e-9));
    }
    const auto one = fit_data::all_observed(fit_data::lognormal350);
    CHECK(limits_of({{one}}).source == QuantileSource::law);
    std::vector<Observation> three;
    for (int i = 0; i < 10; ++i)
        for (const double at : {1.0, 2.0, 4.0}) three.push_back(observed(at + 0.001 * i));
    CHECK(limits_of({{three}}).source != QuantileSource::heaps);
    auto stood = all_of(modes); // one that stood: no heap is whole
    stood.push_back(right_censored(12.0));
    CHECK(limits_of({{stood}}).source != QuantileSource::heaps);
}

TEST_CASE("limit quantiles: a few walls that may be a heap widen the intervals of one law",
          "[fragility][limit_quantiles]")
{
    std::vector<Observation> walls;
    const auto add = [&](int n, double median, double dispersion) {
        const Distribution law{Law::lognormal, std::log(median), dispersion};
        for (int k = 0; k < n; ++k) walls.push_back(observed(quantile(law, (k + 0.5) / n)));
    };
    add(47, 1.4, 0.6);
    add(3, 8.0, 0.12); // gain 6.2: no heap for sure
    const LimitQuantiles found = limits_of({{walls}});
    REQUIRE(found.source == QuantileSource::law);
    const PerformanceLimits law = performance_limits(Law::lognormal, walls);
    CHECK(*found.at[4].value == Approx(law.drifts[4].drift));
    CHECK(law.drifts[4].interval.upper < 7.5);
    CHECK(found.at[4].interval.upper > 8.0);
    CHECK(found.at[4].interval.lower <= law.drifts[4].interval.lower);
}

namespace {

/// Walls at the quantiles of a law.
std::vector<Observation> walls_of(const Distribution& law, int n, double end = core::kInfinity)
{
    std::vector<Observation> walls;
    for (int k = 0; k < n; ++k) {
        const double x = quantile(law, (k + 0.5) / n);
        walls.push_back(x < end ? observed(x) : right_censored(end));
    }
    return walls;
}

} // namespace

TEST_CASE("limit quantiles: intervals hold those of the laws that few walls do not tell apart",
          "[fragility][limit_quantiles]")
{
    const auto walls = walls_of({Law::weibull, std::log(1.8), 1.0 / 2.2}, 12);
    const LimitQuantiles found = limits_of({{walls}});
    REQUIRE(found.source == QuantileSource::law);
    REQUIRE(other_possible_laws(std::vector<ModeGroup>{{walls}}) ==
            std::vector{Law::weibull, Law::gamma});
    const auto own = performance_limits(Law::lognormal, walls);
    const auto weibull = performance_limits(Law::weibull, walls);
    const auto gamma = performance_limits(Law::gamma, walls);
    for (const std::size_t i : {0U, 1U, 2U}) {
        CHECK(found.at[i].value == own.drifts[i].drift);
        CHECK(found.at[i].interval.lower ==
              std::min({own.drifts[i].interval.lower, weibull.drifts[i].interval.lower,
                        gamma.drifts[i].interval.lower}));
        CHECK(found.at[i].interval.upper ==
              std::max({own.drifts[i].interval.upper, weibull.drifts[i].interval.upper,
                        gamma.drifts[i].interval.upper}));
    }
    CHECK(found.at[0].interval.lower < 0.8 * own.drifts[0].interval.lower);
}

TEST_CASE("limit quantiles: the laws of modes are not told apart either",
          "[fragility][limit_quantiles]")
{
    const auto modes = std::vector<ModeGroup>{
        {walls_of({Law::weibull, std::log(1.0), 1.0 / 3.0}, 12), Law::lognormal, true},
        {walls_of({Law::weibull, std::log(2.0), 1.0 / 3.0}, 12), Law::lognormal, true}};
    REQUIRE(other_possible_laws(modes) == std::vector{Law::weibull});
    const LimitQuantiles found = limits_of(modes);
    REQUIRE(found.source == QuantileSource::mixture);
    auto others = modes;
    for (ModeGroup& m : others) m.law = Law::weibull;
    const auto own = mixture_quantiles(modes, kLimitShares);
    const auto other = mixture_quantiles(others, kLimitShares);
    for (std::size_t i = 0; i < 3; ++i) {
        CHECK(found.at[i].value == own[i].value);
        REQUIRE(other[i].interval.upper > 1.01 * own[i].interval.upper);
        CHECK(found.at[i].interval.upper == other[i].interval.upper);
        CHECK(found.at[i].interval.lower ==
              std::min(own[i].interval.lower, other[i].interval.lower));
    }
    // the band by Weibull's law does not come up to 84 %: it says nothing there
    REQUIRE(other[3].interval.upper == core::kInfinity);
    CHECK(found.at[3].interval.upper == own[3].interval.upper);
}

TEST_CASE("possible laws: many walls tell them apart, and negative values allow none",
          "[fragility][limit_quantiles]")
{
    const auto others = [](std::vector<Observation> walls, Law law) {
        return other_possible_laws(std::vector<ModeGroup>{{std::move(walls), law, true}});
    };
    CHECK(others(walls_of({Law::lognormal, 0.0, 0.45}, 250), Law::lognormal).empty());
    const auto weibull = walls_of({Law::weibull, 0.0, 1.0 / 2.2}, 250);
    CHECK(others(weibull, Law::weibull).empty());
    CHECK(others(weibull, Law::lognormal) == std::vector{Law::weibull});
    CHECK(others(walls_of({Law::normal, 0.5, 0.5}, 20), Law::normal).empty());
    CHECK(others({observed(1.0), right_censored(2.0)}, Law::lognormal).size() == 2);
    CHECK(other_possible_laws({}).empty());
}

TEST_CASE("limit quantiles: modes that part what stood from what fell are no modes",
          "[fragility][limit_quantiles]")
{
    const auto all = all_of(two_heaps(60, 2.73, 3));
    std::vector<ModeGroup> modes(2);
    for (const Observation& o : all)
        modes[o.upper == core::kInfinity ? 1 : 0].limits.push_back(o);
    CHECK(limits_of(modes).source == QuantileSource::law);
    CHECK(limits_of(modes, false).source == QuantileSource::observed);
}

TEST_CASE("limit quantiles: walls that all stood give none", "[fragility][limit_quantiles]")
{
    const LimitQuantiles found =
        limits_of({{std::vector<Observation>(9, right_censored(2.5))}});
    CHECK(found.source == QuantileSource::none);
    CHECK(found.at.empty());
    CHECK(found.tested_to == 2.5);
}

TEST_CASE("limit quantiles: intervals hold the truth of two heaps where one law does not",
          "[fragility][limit_quantiles]")
{
    constexpr int kStudies = 100;
    // 0.7 F(x) = 0.5 and 0.84 of the walls: 1.935 and 8.3 %
    const double median = quantile({Law::lognormal, std::log(1.5), 0.45}, 0.5 / 0.7);
    constexpr double kHigh = 8.3;
    int held = 0, high = 0, by_law = 0;
    const auto holds = [](const core::Interval& i, double x) {
        return i.lower <= x && x <= i.upper;
    };
    for (int i = 0; i < kStudies; ++i) {
        const auto modes = two_heaps(50, 2.73, 100 + static_cast<std::uint64_t>(i));
        const LimitQuantiles found = limits_of(modes);
        held += holds(found.at[2].interval, median);
        high += holds(found.at[3].interval, kHigh);
        by_law +=
            holds(performance_limits(Law::lognormal, all_of(modes)).drifts[3].interval, kHigh);
    }
    CHECK(held >= 90);
    CHECK(high == kStudies);
    CHECK(by_law < 50);
}

TEST_CASE("small samples: the profile interval of a normal mean is Student's",
          "[fragility][limit_quantiles]")
{
    const std::vector<double> x = {1.2, 0.7, 1.9, 1.4, 2.3, 1.1};
    const double n = static_cast<double>(x.size());
    const double mean = std::accumulate(x.begin(), x.end(), 0.0) / n;
    double squares = 0.0;
    for (const double v : x) squares += (v - mean) * (v - mean);
    const double t = boost::math::quantile(boost::math::students_t(n - 1.0), 0.975);
    const double half = t * std::sqrt(squares / (n - 1.0) / n);
    const auto limits = performance_limits(Law::normal, fit_data::all_observed(x));
    CHECK(limits.drifts[2].interval.lower == Approx(mean - half).epsilon(1e-6));
    CHECK(limits.drifts[2].interval.upper == Approx(mean + half).epsilon(1e-6));
    CHECK(limits.drifts[2].interval.confidence == 0.95);
    CHECK(small_sample(0.95, 1e9) == Approx(0.95).epsilon(1e-6));
    CHECK(small_sample(0.95, 5.0) > 0.97);
    CHECK(std::isfinite(StandardNormal::quantile(0.5 + 0.5 * small_sample(0.95, 1.0))));
}

TEST_CASE("two heaps: the gain is that of the best parting, and none where a value is censored",
          "[fragility][limit_quantiles]")
{
    // 1, 2, 3 and 11, 12, 13: variances 2/3 of the parts and 77/3 of all, in two halves
    auto data = fit_data::all_observed({12.0, 1.0, 3.0, 2.0, 13.0, 11.0});
    const double gain = 6.0 * std::log(77.0 / 2.0) + 12.0 * std::log(0.5);
    CHECK(two_heaps(data, false) == Approx(gain).epsilon(1e-12));
    std::vector<Observation> powers;
    for (const Observation& o : data) powers.push_back(observed(std::exp(o.lower)));
    CHECK(two_heaps(powers, true) == Approx(gain).epsilon(1e-12));
    data.back() = right_censored(13.0);
    CHECK(two_heaps(data, false) == 0.0);
    CHECK(two_heaps(fit_data::all_observed({1.0, 2.0, 3.0, 11.0, 12.0}), false) == 0.0);
}

TEST_CASE("limit quantiles: walls that all fell have a median between two of them, whatever "
          "the band of their modes",
          "[fragility][limit_quantiles]")
{
    // a mode of one wall, and one that no law describes
    std::vector<ModeGroup> modes(3);
    for (const double x : {0.749, 0.741, 0.758}) modes[0].limits.push_back(observed(x));
    for (const double x : {0.764, 0.390, 0.751, 0.748, 0.387, 0.752})
        modes[1].limits.push_back(observed(x));
    modes[1].described = false;
    modes[2].limits.push_back(observed(0.759));
    const LimitQuantiles found = limits_of(modes);
    REQUIRE(found.source == QuantileSource::mixture);
    REQUIRE(found.at.size() == 5);
    const core::Interval median = found.at[2].interval;
    CHECK(median.lower >= 0.387);
    CHECK(median.upper <= 0.764);
    CHECK(median.lower < *found.at[2].value);
    CHECK(median.upper > *found.at[2].value);
    for (std::size_t i = 1; i < found.at.size(); ++i) {
        CHECK(found.at[i].interval.lower >= found.at[i - 1].interval.lower);
        CHECK(found.at[i].interval.upper >= found.at[i - 1].interval.upper);
    }
}

TEST_CASE("limit quantiles: a lower bound of one share is one of all larger shares",
          "[fragility][limit_quantiles]")
{
    // few walls, some of which stood: the band alone bounded 95 % and not 84 %
    std::vector<ModeGroup> modes(2);
    modes[0].limits.push_back(observed(0.793));
    for (const double x : {0.429, 0.865, 1.020}) modes[1].limits.push_back(observed(x));
    for (int i = 0; i < 2; ++i) modes[1].limits.push_back(right_censored(1.82));
    const LimitQuantiles found = limits_of(modes);
    REQUIRE(found.source == QuantileSource::mixture);
    for (std::size_t i = 1; i < found.at.size(); ++i)
        CHECK(found.at[i].interval.lower >= found.at[i - 1].interval.lower);
    CHECK(found.at[3].interval.lower > 0.0);
    CHECK(found.at[4].interval.lower == Approx(0.978).margin(2e-3));
    for (std::uint64_t which = 0; which < 300; ++which)
        for (const double end : {4.0, core::kInfinity}) {
            const auto at = limits_of(two_heaps(8, end, which)).at;
            for (std::size_t i = 1; i < at.size(); ++i) {
                CHECK(at[i].interval.lower >= at[i - 1].interval.lower);
                CHECK(at[i].interval.upper >= at[i - 1].interval.upper);
            }
        }
}
