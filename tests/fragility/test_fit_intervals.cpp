#include "fragility/bootstrap.hpp"
#include "fragility/fit_intervals.hpp"
#include "fragility/resampling.hpp"
#include "fragility/standard_law.hpp"

#include "tests/fragility/fit_data.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>

using namespace fragility;

namespace {

auto near(double value, double tolerance = 1e-9)
{
    return Approx(value).epsilon(tolerance).margin(0.0);
}
const std::vector<Law> kLaws{Law::lognormal, Law::normal, Law::weibull, Law::gamma};
constexpr double kZ = 1.959963984540054;
const RandomBits kBits = fit_data::bits;

std::vector<double> first(std::size_t n)
{
    return {fit_data::lognormal350.begin(),
            fit_data::lognormal350.begin() + static_cast<std::ptrdiff_t>(n)};
}

} // namespace

TEST_CASE("fit intervals: Wald intervals are the estimate times exp of 1.96 standard errors",
          "[fragility][fit_intervals]")
{
    const auto data = fit_data::stopped_at(fit_data::lognormal350, 0.018);
    const Fit f = fit(Law::lognormal, data);
    const Interval m = wald_interval(f, median());
    CHECK(m.lower == near(std::exp(f.law.location - kZ * f.location_error)));
    CHECK(m.upper == near(std::exp(f.law.location + kZ * f.location_error)));
    const Interval s = wald_interval(f, dispersion());
    CHECK(s.upper / f.law.dispersion == near(std::exp(kZ * 0.0444953795), 1e-8));
    const Uncertain u = uncertain(f, quantile_of(0.84134474606854293));
    const auto& c = f.covariance;
    const double b = f.law.dispersion;
    CHECK(u.axis_error == near(std::sqrt(c(0, 0) + 2 * b * c(0, 1) + b * b * c(1, 1))));
}

TEST_CASE("fit intervals: the profile of a complete lognormal sample is Student's in disguise",
          "[fragility][fit_intervals]")
{
    // 2 (l - l_mu) = n ln(1 + (mean - mu)^2 / s^2): the ends are closed-form
    const auto values = first(40);
    const auto data = fit_data::all_observed(values);
    const Fit f = fit(Law::lognormal, data);
    const double half = f.law.dispersion * std::sqrt(std::expm1(kZ * kZ / 40.0));
    const Interval i = profile_interval(f, data, median());
    CHECK(std::log(i.lower) == near(f.law.location - half, 1e-8));
    CHECK(std::log(i.upper) == near(f.law.location + half, 1e-8));
    // dispersion: n (s^2/t^2 - 1 - ln(s^2/t^2)) = z^2
    const Interval d = profile_interval(f, data, dispersion());
    for (const double end : {d.lower, d.upper}) {
        const double r = std::pow(f.law.dispersion / end, 2);
        CHECK(40.0 * (r - 1.0 - std::log(r)) == near(kZ * kZ, 1e-7));
    }
}

TEST_CASE("fit intervals: Wald and profile agree when there are many data",
          "[fragility][fit_intervals]")
{
    const Law law = GENERATE(from_range(kLaws));
    const Quantity q = GENERATE(location(), dispersion(), median(), quantile_of(0.05));
    auto data = fit_data::stopped_at(fit_data::lognormal350, 0.02);
    for (Observation& o : data) {
        o.lower *= 100.0;
        o.upper *= 100.0;
        o.weight = 1e4;
    }
    const Fit f = fit(law, data);
    REQUIRE(f.outcome == FitOutcome::converged);
    const Interval w = wald_interval(f, q);
    const Interval p = profile_interval(f, data, q);
    const double width = w.upper - w.lower;
    CHECK(p.lower == Approx(w.lower).margin(0.005 * width).epsilon(0));
    CHECK(p.upper == Approx(w.upper).margin(0.005 * width).epsilon(0));
}

TEST_CASE("fit intervals: intervals of medians scale with the unit",
          "[fragility][fit_intervals]")
{
    const Law law = GENERATE(from_range(kLaws));
    auto data = fit_data::stopped_at(first(60), 0.015);
    const Interval a = profile_interval(fit(law, data), data, median());
    for (Observation& o : data) {
        o.lower *= 250.0;
        o.upper *= 250.0;
    }
    const Interval b = profile_interval(fit(law, data), data, median());
    CHECK(b.lower == near(250.0 * a.lower, 1e-8));
    CHECK(b.upper == near(250.0 * a.upper, 1e-8));
}

TEST_CASE("fit intervals: a profile that does not close is said to be open",
          "[fragility][fit_intervals]")
{
    // four failures, the rest stands: the median is bounded from below only
    auto data = fit_data::all_observed({1.0, 1.8, 1.9, 2.0});
    for (int i = 0; i < 60; ++i) data.push_back(right_censored(2.0));
    const Fit f = fit(Law::lognormal, data);
    REQUIRE(f.outcome == FitOutcome::converged);
    const Interval i = profile_interval(f, data, median(), 0.999999);
    CHECK(i.lower > 1.5);
    CHECK(i.upper > 50.0);
    CHECK_FALSE(std::isnan(i.upper));
}

TEST_CASE("fit intervals: no fit, no interval", "[fragility][fit_intervals]")
{
    const Fit none = fit(Law::lognormal, {});
    CHECK_THROWS_AS(wald_interval(none, median()), std::invalid_argument);
    CHECK_THROWS_AS(profile_interval(none, {}, median()), std::invalid_argument);
    CHECK_THROWS_AS(bootstrap(none, {}, kBits), std::invalid_argument);
    const auto data = fit_data::all_observed({1, 2, 3, 4});
    CHECK_THROWS_AS(wald_interval(fit(Law::normal, data), median(), 1.0),
                    std::invalid_argument);
}

TEST_CASE("bootstrap: replicates do not depend on how many there are", "[fragility][bootstrap]")
{
    const auto data = fit_data::stopped_at(first(50), 0.015);
    const Fit f = fit(Law::lognormal, data);
    const Resampling how = GENERATE(Resampling::walls, Resampling::law);
    const Bootstrap few = bootstrap(f, data, kBits, {50, how});
    const Bootstrap many = bootstrap(f, data, kBits, {80, how});
    REQUIRE(few.laws.size() == 50);
    for (std::size_t r = 0; r < 50; ++r) CHECK(few.laws[r].location == many.laws[r].location);
}

TEST_CASE("bootstrap: its spread is the standard error", "[fragility][bootstrap]")
{
    const auto data = fit_data::stopped_at(fit_data::lognormal350, 0.018);
    const Fit f = fit(Law::lognormal, data);
    const Resampling how = GENERATE(Resampling::walls, Resampling::law);
    const Bootstrap b = bootstrap(f, data, kBits, {4000, how});
    CHECK(b.failed == 0);
    CHECK(b.without_one.size() == 280); // 279 different values and the limit
    double sum = 0.0;
    double squares = 0.0;
    for (const Distribution& d : b.laws) {
        sum += d.location;
        squares += std::pow(d.location - f.law.location, 2);
    }
    // sd of an sd of 4000 values: 1.1 %; a bias of the location of the order 1 / n
    CHECK(std::sqrt(squares / 4000.0) == Approx(f.location_error).epsilon(0.05));
    CHECK(sum / 4000.0 == Approx(f.law.location).margin(0.1 * f.location_error).epsilon(0));
    const Interval p = percentile_interval(b, median());
    const Interval a = bca_interval(b, median());
    const Interval w = wald_interval(f, median());
    const double width = w.upper - w.lower;
    CHECK(p.lower == Approx(w.lower).margin(0.06 * width).epsilon(0));
    CHECK(a.upper == Approx(w.upper).margin(0.06 * width).epsilon(0));
}

TEST_CASE("bootstrap: BCa corrects the dispersion upwards, percentiles do not",
          "[fragility][bootstrap]")
{
    // the ML dispersion is too small by 1 / (4 n) and more; its resamples once more
    const auto data = fit_data::all_observed(first(30));
    const Fit f = fit(Law::lognormal, data);
    const Bootstrap b = bootstrap(f, data, kBits, {2000, Resampling::walls});
    CHECK(bca_interval(b, dispersion()).upper > percentile_interval(b, dispersion()).upper);
    CHECK(bca_interval(b, dispersion()).lower > percentile_interval(b, dispersion()).lower);
}

TEST_CASE("bootstrap: BCa of a mean has the acceleration skewness / (6 sqrt n)",
          "[fragility][bootstrap]")
{
    const std::vector<double> x{0.1, 0.2, 0.4, 0.5, 0.7, 1.0, 1.4, 1.9, 2.8, 5.0, 9.0};
    const double n = 11.0;
    const double mean = 23.0 / n;
    double m2 = 0.0;
    double m3 = 0.0;
    for (const double v : x) {
        m2 += std::pow(v - mean, 2) / n;
        m3 += std::pow(v - mean, 3) / n;
    }
    const double a = m3 / std::pow(m2, 1.5) / (6.0 * std::sqrt(n));
    const auto data = fit_data::all_observed(x);
    const Bootstrap b = bootstrap(fit(Law::normal, data), data, kBits, {2000});
    std::vector<double> means;
    for (const Distribution& d : b.laws) means.push_back(d.location);
    std::sort(means.begin(), means.end());
    double below = 0.0;
    for (const double v : means) below += v < mean - 1e-9 ? 1.0 : v < mean + 1e-9 ? 0.5 : 0.0;
    const double size = static_cast<double>(means.size());
    const double z0 = StandardNormal::quantile(below / size);
    const auto end = [&](double z) {
        return sample_quantile(means,
                               StandardNormal::cdf(z0 + (z0 + z) / (1.0 - a * (z0 + z))));
    };
    const Interval i = bca_interval(b, location());
    CHECK(i.lower == near(end(-kZ), 1e-3)); // ties at the mean move z0 by a few of 2000
    CHECK(i.upper == near(end(kZ), 1e-3));
    CHECK(i.upper > percentile_interval(b, location()).upper);
}

TEST_CASE("bootstrap: stopping points beyond an observed value, from those of the others",
          "[fragility][bootstrap]")
{
    const std::vector<Observation> walls{observed(1), right_censored(2), observed(3),
                                         right_censored(4)};
    const StoppingPoints stops(walls);
    // Kaplan-Meier with the roles exchanged: 1/3 stop at 2, the others at 4
    CHECK(stops.draw(0, 0.33) == 2.0);
    CHECK(stops.draw(0, 0.34) == 4.0);
    CHECK(stops.draw(1, 0.9) == 2.0);
    CHECK(stops.draw(2, 0.01) == 4.0);
    CHECK(stops.draw(3, 0.01) == 4.0);
    CHECK(std::isinf(StoppingPoints(std::vector{observed(1), observed(2)}).draw(0, 0.99)));
}

TEST_CASE("bootstrap: resamples that cannot be fitted are counted", "[fragility][bootstrap]")
{
    auto data = fit_data::all_observed({1.0, 2.0, 3.0});
    for (int i = 0; i < 9; ++i) data.push_back(right_censored(3.5));
    const Fit f = fit(Law::lognormal, data);
    REQUIRE(f.outcome == FitOutcome::converged);
    const Bootstrap b = bootstrap(f, data, kBits, {1000, Resampling::walls});
    // fewer than two failures drawn: 0.75^12 + 12 / 4 0.75^11 = 0.158; or equal ones: some more
    CHECK(b.failed > 120);
    CHECK(b.failed < 260);
    CHECK(b.failed + b.laws.size() == 1000);
}

TEST_CASE("bootstrap: what it cannot do is refused", "[fragility][bootstrap]")
{
    auto data = fit_data::all_observed({1.0, 2.0, 3.0, 4.0});
    data[0].weight = 1.5;
    CHECK_THROWS_AS(bootstrap(fit(Law::normal, data), data, kBits), std::invalid_argument);
    data[0] = interval_censored(0.5, 1.5);
    CHECK_THROWS_AS(bootstrap(fit(Law::normal, data), data, kBits, {10, Resampling::law}),
                    std::invalid_argument);
    CHECK_THROWS_AS(bootstrap(fit(Law::normal, data), data, kBits, {0}), std::invalid_argument);
}

TEST_CASE("bootstrap: percentiles of sorted values are linear between them",
          "[fragility][bootstrap]")
{
    const std::vector<double> v{1, 2, 4, 8};
    CHECK(sample_quantile(v, 0.0) == 1.0);
    CHECK(sample_quantile(v, 0.5) == 3.0);
    CHECK(sample_quantile(v, 1.0) == 8.0);
}
