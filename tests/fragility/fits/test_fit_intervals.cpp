#include "core/interval.hpp"
#include "fragility/fits/fit_intervals.hpp"
#include "fragility/fits/resampling.hpp"
#include "fragility/laws/standard_law.hpp"

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

std::vector<double> first(std::size_t n)
{
    return {fit_data::lognormal350.begin(),
            fit_data::lognormal350.begin() + static_cast<std::ptrdiff_t>(n)};
}

} // namespace

TEST_CASE(
    "fit intervals: standard errors are those of the fit, of a quantile by the delta method",
    "[fragility][fit_intervals]")
{
    const auto data = fit_data::stopped_at(fit_data::lognormal350, 0.018);
    const Fit f = fit(Law::lognormal, data);
    const Uncertain m = uncertain(f, median());
    CHECK(m.value == near(std::exp(f.law.location)));
    CHECK(m.axis_error == near(f.location_error));
    CHECK(uncertain(f, dispersion()).axis_error == near(0.0444953795, 1e-8));
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
    const core::Interval i = profile_interval(f, data, median());
    CHECK(std::log(i.lower) == near(f.law.location - half, 1e-8));
    CHECK(std::log(i.upper) == near(f.law.location + half, 1e-8));
    // dispersion: n (s^2/t^2 - 1 - ln(s^2/t^2)) = z^2
    const core::Interval d = profile_interval(f, data, dispersion());
    for (const double end : {d.lower, d.upper}) {
        const double r = std::pow(f.law.dispersion / end, 2);
        CHECK(40.0 * (r - 1.0 - std::log(r)) == near(kZ * kZ, 1e-7));
    }
}

TEST_CASE("fit intervals: of many data the profile ends 1.96 standard errors away",
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
    const Uncertain u = uncertain(f, q);
    const core::Interval p = profile_interval(f, data, q);
    const auto end = [&](double half) {
        return u.logarithmic ? u.value * std::exp(half) : u.value + half;
    };
    const double low = end(-kZ * u.axis_error), high = end(kZ * u.axis_error);
    CHECK(p.lower == Approx(low).margin(0.005 * (high - low)).epsilon(0));
    CHECK(p.upper == Approx(high).margin(0.005 * (high - low)).epsilon(0));
}

TEST_CASE("fit intervals: intervals of medians scale with the unit",
          "[fragility][fit_intervals]")
{
    const Law law = GENERATE(from_range(kLaws));
    auto data = fit_data::stopped_at(first(60), 0.015);
    const core::Interval a = profile_interval(fit(law, data), data, median());
    for (Observation& o : data) {
        o.lower *= 250.0;
        o.upper *= 250.0;
    }
    const core::Interval b = profile_interval(fit(law, data), data, median());
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
    const core::Interval i = profile_interval(f, data, median(), 0.999999);
    CHECK(i.lower > 1.5);
    CHECK(i.upper > 50.0);
    CHECK_FALSE(std::isnan(i.upper));
}

TEST_CASE("fit intervals: no fit, no interval", "[fragility][fit_intervals]")
{
    const Fit none = fit(Law::lognormal, {});
    CHECK_THROWS_AS(profile_interval(none, {}, median()), std::invalid_argument);
    const auto data = fit_data::all_observed({1, 2, 3, 4});
    CHECK_THROWS_AS(profile_interval(fit(Law::normal, data), data, median(), 1.0),
                    std::invalid_argument);
}

TEST_CASE("resampling: stopping points beyond an observed value, from those of the others",
          "[fragility][resampling]")
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
