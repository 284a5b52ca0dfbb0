#include "uq/estimates/stopping.hpp"

#include "core/interval.hpp"
#include "uq/designs/stream.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

using namespace uq;

namespace {

/// Normal values about 10, sd 2, keyed: the same however they are asked for.
struct Source {
    std::uint64_t seed;
    std::vector<std::size_t> asked{};
    std::vector<double> operator()(std::size_t first, std::size_t count)
    {
        asked.push_back(count);
        std::vector<double> y;
        for (std::size_t i = first; i < first + count; ++i)
            y.push_back(10.0 + 2.0 * Stream(seed, i, Purpose::monte_carlo).normal());
        return y;
    }
};

struct StoppedSampling {
    StoppingDecision decision;
    std::vector<double> y;
};

/// Samples as a study does: to the next look, judged, until the rule stops.
template <class Source> StoppedSampling run(const StoppingRule& rule, Source&& source)
{
    StoppedSampling s{judge(rule, {}), {}};
    while (s.decision.reason == StopReason::not_yet) {
        const auto more = source(s.y.size(), s.decision.next_n - s.y.size());
        s.y.insert(s.y.end(), more.begin(), more.end());
        s.decision = judge(rule, s.y);
    }
    return s;
}

} // namespace

TEST_CASE("stopping: the interval of the mean is as narrow as asked, and was not before",
          "[uq][stopping]")
{
    Source source{1};
    const StoppingRule rule{.half_width = 0.02, .min_n = 20, .max_n = 10000};
    const StoppedSampling s = run(rule, source);
    REQUIRE(s.decision.reason == StopReason::precise_enough);
    CHECK(s.decision.half_width <= 0.02);
    CHECK(s.decision.next_n == 0);
    const Estimate e = estimate_mean(s.y);
    CHECK((e.interval.upper - e.value) / e.value ==
          Approx(s.decision.half_width).epsilon(1e-12));
    const auto before = static_cast<std::ptrdiff_t>(s.y.size() - source.asked.back());
    CHECK(judge(rule, std::span(s.y).first(static_cast<std::size_t>(before))).half_width >
          0.02);
}

TEST_CASE("stopping: batches grow by the factor asked for, up to the limit", "[uq][stopping]")
{
    Source source{1};
    const StoppedSampling s =
        run({.half_width = 1e-9, .min_n = 10, .max_n = 50, .growth = 2.0}, source);
    CHECK(source.asked == std::vector<std::size_t>{10, 10, 20, 10});
    CHECK(s.decision.reason == StopReason::sample_limit);
    CHECK(words(s.decision.reason) == "limit of samples reached");
    CHECK(s.decision.estimate.has_value());
    CHECK(s.y.size() == 50);
}

TEST_CASE("stopping: quantile, probability and absolute widths", "[uq][stopping]")
{
    Source source{2};
    const StoppingRule median{.target = StoppingTarget::quantile, .half_width = 0.03};
    const StoppingRule below{.target = StoppingTarget::probability_below,
                             .threshold = 8.0,
                             .half_width = 0.05,
                             .relative = false};
    const StoppingRule mean{.half_width = 0.5, .relative = false, .min_n = 2};
    const auto m = run(median, source), b = run(below, source), a = run(mean, source);
    CHECK(m.decision.reason == StopReason::precise_enough);
    CHECK(std::abs(m.decision.estimate->value - 10.0) < 0.5);
    CHECK(b.decision.reason == StopReason::precise_enough);
    CHECK(b.decision.estimate->value == Approx(0.158655).margin(0.06));
    CHECK(a.decision.half_width <= 0.5);
}

TEST_CASE("stopping: an interval without limit, or no event at all, does not stop it",
          "[uq][stopping]")
{
    Source source{3};
    const StoppedSampling tail =
        run({.target = StoppingTarget::quantile, .p = 0.9999, .max_n = 60}, source);
    CHECK(tail.decision.reason == StopReason::sample_limit);
    CHECK(std::isinf(tail.decision.half_width));
    const StoppedSampling never =
        run({.target = StoppingTarget::probability_below, .threshold = -100.0, .max_n = 60},
            source);
    CHECK(never.decision.reason == StopReason::sample_limit);
    CHECK(never.decision.estimate->interval.upper > 0.0);
}

TEST_CASE("stopping: failed samples count towards the limit and widen a probability",
          "[uq][stopping]")
{
    std::vector<double> y(100, std::numeric_limits<double>::quiet_NaN());
    const StoppedSampling s = run({.max_n = 60}, [&](std::size_t, std::size_t c) {
        return std::vector<double>(y.begin(), y.begin() + static_cast<std::ptrdiff_t>(c));
    });
    CHECK(s.decision.reason == StopReason::sample_limit);
    CHECK_FALSE(s.decision.estimate.has_value());
    StoppingRule rule{.target = StoppingTarget::probability_below, .threshold = 0.5};
    for (std::size_t i = 0; i < 90; ++i) y[i] = i % 2 == 0 ? 0.0 : 1.0;
    std::vector<double> sound(y.begin(), y.begin() + 90);
    CHECK(judge(rule, y).half_width > judge(rule, sound).half_width);
}

TEST_CASE("stopping: the last interval holds the mean nearly as often as it says",
          "[uq][stopping]")
{
    const int studies = 1500;
    int held = 0;
    for (int k = 0; k < studies; ++k) {
        Source source{static_cast<std::uint64_t>(100 + k)};
        const StoppedSampling s = run({.half_width = 0.03, .min_n = 30, .max_n = 2000}, source);
        const core::Interval i = s.decision.estimate->interval;
        held += i.lower <= 10.0 && 10.0 <= i.upper;
    }
    INFO("coverage " << held / double(studies));
    CHECK(held / double(studies) > 0.93);
}

TEST_CASE("stopping: rules out of range are refused", "[uq][stopping]")
{
    using T = StoppingTarget;
    const StoppingRule bad[] = {{.half_width = 0.0},
                                {.min_n = 1},
                                {.min_n = 50, .max_n = 49},
                                {.growth = 1.0},
                                {.target = T::quantile, .p = 1.0},
                                {.confidence = 1.0},
                                {.threshold = std::nan("")}};
    for (const StoppingRule& rule : bad) CHECK_THROWS_AS(check(rule), std::invalid_argument);
}
