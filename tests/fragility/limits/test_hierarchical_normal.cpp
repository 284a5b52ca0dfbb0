#include "core/interval.hpp"
#include "fragility/laws/standard_law.hpp"
#include "fragility/limits/hierarchical_normal.hpp"

#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

using namespace fragility;

namespace {

/// Eight schools (Rubin 1981): one value for each level, its error known.
std::vector<LevelledValue> eight_schools()
{
    constexpr std::array<double, 8> kEffect = {28, 8, -3, 7, -1, 1, 18, 12};
    constexpr std::array<double, 8> kError = {15, 10, 16, 11, 9, 11, 10, 18};
    std::vector<LevelledValue> data;
    for (std::size_t i = 0; i < 8; ++i) data.push_back({i, kEffect[i], false, kError[i]});
    return data;
}

const std::vector<LevelledValue> kRepeats = {{0, 0.3},   {0, 0.35},  {1, -0.12}, {1, 0.03},
                                             {2, -0.17}, {2, -0.22}, {3, -0.02}};
constexpr ScalePrior kPrior{0.25};

} // namespace

TEST_CASE("hierarchical normal: eight schools have their known posterior",
          "[fragility][hierarchical_normal]")
{
    const auto p = hierarchical_posterior(eight_schools(), {}); // flat on mu and tau
    CHECK(p.tau ==
          Approx(6.575483).epsilon(1e-6)); // by adaptive quadrature, independent of this
    CHECK(p.tau_error == Approx(5.650379).epsilon(1e-6));
    CHECK(p.mu == Approx(7.932375).epsilon(1e-6));
    CHECK(p.mu_error == Approx(5.178395).epsilon(1e-6));
    constexpr std::array<double, 8> kEffects = {11.40026, 7.89455, 6.13075,  7.64468,
                                                5.12642,  6.13854, 10.66698, 8.45682};
    for (std::size_t i = 0; i < 8; ++i)
        CHECK(p.level_means[i] == Approx(kEffects[i]).epsilon(1e-6));
    CHECK(scatter_quantile(p, 0.05) == Approx(0.48562).epsilon(2e-3));
    CHECK(scatter_quantile(p, 0.50) == Approx(5.23851).epsilon(2e-4));
    CHECK(scatter_quantile(p, 0.95) == Approx(17.17603).epsilon(2e-4));
}

TEST_CASE("hierarchical normal: shifting all values shifts mu, scaling them scales all",
          "[fragility][hierarchical_normal]")
{
    const auto p = hierarchical_posterior(kRepeats, kPrior);
    std::vector<LevelledValue> other = kRepeats;
    for (LevelledValue& v : other) v.value = 2.0 * v.value + 1.0;
    const auto q = hierarchical_posterior(other, {0.5});
    CHECK(q.mu == Approx(2.0 * p.mu + 1.0).epsilon(1e-9));
    CHECK(q.mu_error == Approx(2.0 * p.mu_error).epsilon(1e-9));
    CHECK(q.scatter == Approx(2.0 * p.scatter).epsilon(1e-9));
    const core::Interval a = predictive_interval(p, 0.9), b = predictive_interval(q, 0.9);
    CHECK(b.lower == Approx(2.0 * a.lower + 1.0).epsilon(1e-9));
    CHECK(b.upper == Approx(2.0 * a.upper + 1.0).epsilon(1e-9));
}

TEST_CASE("hierarchical normal: ends of intervals are those of a fine grid",
          "[fragility][hierarchical_normal]")
{
    // 1500 x 1500 points of tau and s, mu normal given both
    struct Known {
        std::vector<LevelledValue> data;
        std::array<double, 3> scatter, mu; // 5, 50 and 95 %
    };
    const std::vector<Known> all = {
        {kRepeats, {0.1555, 0.2556, 0.4877}, {-0.2110, 0.0176, 0.2453}},
        {{{0, 0.5}, {1, 0.1}, {2, -0.6}}, {0.2999, 0.4976, 0.9358}, {-0.5337, 0.0, 0.5337}},
        {{{0, 0.0}, {0, 0.01}, {0, -0.01}}, {0.0303, 0.1958, 0.6980}, {-0.4973, 0.0, 0.4973}},
    };
    constexpr std::array kLevels = {0.05, 0.50, 0.95};
    for (const Known& known : all) {
        const auto p = hierarchical_posterior(known.data, kPrior);
        for (std::size_t i = 0; i < kLevels.size(); ++i) {
            CHECK(scatter_quantile(p, kLevels[i]) == Approx(known.scatter[i]).epsilon(5e-3));
            CHECK(mu_quantile(p, kLevels[i]) == Approx(known.mu[i]).margin(3e-4));
        }
    }
}

TEST_CASE("hierarchical normal: values far from zero that nearly agree lose no digits",
          "[fragility][hierarchical_normal]")
{
    const auto posterior = [](double shift) {
        std::vector<LevelledValue> data;
        for (const double y : {0.0, 0.002, 0.001, 0.0005})
            data.push_back({data.size() / 2, shift + y});
        return hierarchical_posterior(data, kPrior);
    };
    const auto near = posterior(0.0), far = posterior(10.0);
    CHECK(far.scatter == Approx(near.scatter).epsilon(1e-6));
    CHECK(mu_quantile(far, 0.95) == Approx(10.0 + mu_quantile(near, 0.95)).epsilon(1e-6));
}

TEST_CASE("hierarchical normal: repeats that agree say nothing about other levels",
          "[fragility][hierarchical_normal]")
{
    // levels apart, repeats together: the scatter is that of the levels, and many repeats of
    // one level do not fix mu
    std::vector<LevelledValue> data;
    for (const double level : {-0.3, 0.0, 0.3})
        for (const double repeat : {-0.01, 0.0, 0.01})
            data.push_back(
                {static_cast<std::size_t>(std::lround((level + 0.3) / 0.3)), level + repeat});
    const auto p = hierarchical_posterior(data, kPrior);
    CHECK(p.tau > 0.2);
    CHECK(p.mu_error > 0.1); // nine independent values would have 0.08
    CHECK(p.level_means[2] == Approx(0.3).margin(0.01));
    CHECK(p.level_means[0] == Approx(-0.3).margin(0.01));
}

TEST_CASE(
    "hierarchical normal: a bound far below says nothing, one far above moves the mean up",
    "[fragility][hierarchical_normal]")
{
    const auto with = [](double bound) {
        std::vector<LevelledValue> data = kRepeats;
        data.push_back({3, bound, true});
        return hierarchical_posterior(data, kPrior);
    };
    const auto without = hierarchical_posterior(kRepeats, kPrior);
    CHECK(with(-40.0).mu == Approx(without.mu).epsilon(1e-6));
    CHECK(with(-40.0).scatter == Approx(without.scatter).epsilon(1e-6));
    CHECK(with(0.6).mu > without.mu + 0.02);
    CHECK(with(0.6).level_means[3] > without.level_means[3] + 0.05);
    CHECK(with(0.9).mu > with(0.6).mu);
}

TEST_CASE("hierarchical normal: a bound counts as the probability above it",
          "[fragility][hierarchical_normal]")
{
    // many values of one level at known scatter, so that the level is known: its weight is a
    // normal tail
    std::vector<LevelledValue> data;
    for (std::size_t level = 0; level < 3; ++level)
        for (int i = 0; i < 2; ++i) data.push_back({level, 0.1 * i, false, 0.2});
    const auto before = hierarchical_posterior(data, {0.1});
    data.push_back({0, 0.3, true, 0.2});
    const auto after = hierarchical_posterior(data, {0.1});
    // posterior mean of mu under an added bound, by summing the points of the posterior without
    // it: that of mu + d_0 given mu is normal
    double weight = 0.0, mean = 0.0;
    for (const auto& p : before.points) {
        const double precision = 2.0 / 0.04, t2 = p.tau * p.tau;
        const double centre = (p.mu + t2 * precision * 0.05) / (1.0 + t2 * precision);
        const double variance = t2 / (1.0 + t2 * precision);
        const double tail =
            StandardNormal::survival((0.3 - centre) / std::sqrt(0.04 + variance));
        weight += p.weight * tail;
        mean += p.weight * tail * p.mu;
    }
    CHECK(after.mu == Approx(mean / weight).epsilon(1e-6));
}

TEST_CASE("hierarchical normal: what has no posterior is refused",
          "[fragility][hierarchical_normal]")
{
    const auto refused = [](const std::vector<LevelledValue>& data, ScalePrior prior) {
        CHECK_THROWS_AS(static_cast<void>(hierarchical_posterior(data, prior)),
                        std::invalid_argument);
    };
    refused({}, kPrior);
    refused({{0, 0.1}, {1, 0.2}, {1, 0.3, true}}, kPrior);
    refused({{0, 0.1}, {1, 0.2}, {3, 0.3}}, kPrior); // no level 2
    refused({{0, 0.1}, {1, 0.2}, {2, std::nan("")}}, kPrior);
    refused({{0, 0.1}, {1, 0.2}, {2, 0.3, false, 0.1}}, kPrior);
    refused({{0, 0.1}, {1, 0.2}, {2, 0.3, false, -0.1}}, kPrior);
    refused(kRepeats, {}); // improper
    CHECK_THROWS_AS(
        static_cast<void>(predictive_interval(hierarchical_posterior(kRepeats, kPrior), 1.0)),
        std::invalid_argument);
}

TEST_CASE("hierarchical normal: repeats of one level, however close, leave tau its prior",
          "[fragility][hierarchical_normal]")
{
    // mu is flat, so that one level says nothing of tau: moments of the half-t prior
    for (const double apart : {0.1, 0.01, 0.003, 0.0003}) {
        CAPTURE(apart);
        const std::vector<LevelledValue> data = {
            {0, -0.1 - apart}, {0, -0.1}, {0, -0.1 + apart}};
        const auto p = hierarchical_posterior(data, kPrior);
        CHECK(p.tau == Approx(kPrior.half_t).epsilon(1e-3));
        CHECK(p.tau_error == Approx(kPrior.half_t).epsilon(5e-3));
        if (apart > 0.005) continue; // s counts
        CHECK(scatter_quantile(p, 0.95) == Approx(2.776445 * kPrior.half_t).epsilon(2e-3));
    }
}
