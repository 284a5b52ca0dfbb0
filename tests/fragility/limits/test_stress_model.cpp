#include "fragility/limits/stress_model.hpp"

#include "tests/fragility/fit_data.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <stdexcept>

using namespace fragility;

namespace {

auto near(double value, double tolerance = 1e-9)
{
    return Approx(value).epsilon(tolerance).margin(0.0);
}

/// Seventeen made-up walls at five stresses [MPa], drifts [%]; five stopped at 2.8 %.
std::vector<StressedObservation> walls()
{
    const double s[] = {.15, .15, .15, .5, .5, .5,   .5,   .75, .75,
                        .75, 1,   1,   1,  1,  1.25, 1.25, 1.25};
    const double x[] = {2.8, 2.1, 2.8, 2.3, 1.9, 2.8, 1.4, 1.7, 2.2,
                        2.8, 1.2, 1.6, 1.9, .8,  1.1, .7,  1.5};
    std::vector<StressedObservation> data;
    for (std::size_t i = 0; i < 17; ++i)
        data.push_back({s[i], x[i] < 2.8 ? observed(x[i]) : right_censored(2.8)});
    return data;
}

/// Many lognormal walls at five stresses: ln median 1 - s + 0.3 s^2, ln dispersion -1 + 0.4 s,
/// at evenly spaced probabilities.
std::vector<StressedObservation> many_walls()
{
    std::vector<StressedObservation> data;
    for (const double s : {0.15, 0.5, 0.75, 1.0, 1.25}) {
        const Distribution law{Law::lognormal, 1.0 - s + 0.3 * s * s, std::exp(-1.0 + 0.4 * s)};
        for (int i = 0; i < 400; ++i) {
            const double x = quantile(law, (i + 0.5) / 400.0);
            data.push_back({s, x < 2.5 ? observed(x) : right_censored(2.5)});
        }
    }
    return data;
}

} // namespace

TEST_CASE("stress model: a straight ln median with one dispersion as survreg (R)",
          "[fragility][stress_model]")
{
    const StressModel m = fit_stress_model(walls(), {1, 0});
    REQUIRE(m.outcome == FitOutcome::converged);
    const double slope = m.median_terms[1] / m.scale;
    CHECK(slope == near(-1.00538446495614, 1e-10));
    CHECK(m.median_terms[0] - slope * m.centre == near(1.34082468818089, 1e-10));
    CHECK(std::exp(m.dispersion_terms[0]) == near(0.34735421862239, 1e-10));
    CHECK(m.log_likelihood == near(-12.89531141802168, 1e-10));
    const AtStress at = at_stress(m, 0.6);
    CHECK(at.law.location == near(0.737594009207, 1e-9));
    CHECK(std::sqrt(at.covariance(0, 0)) == near(0.099850010181, 1e-7));
    CHECK_FALSE(at.extrapolated);
    CHECK(at_stress(m, 1.3).extrapolated);
}

TEST_CASE("stress model: with degrees 0 it is the pooled fit", "[fragility][stress_model]")
{
    const auto data = walls();
    std::vector<Observation> all;
    for (const auto& d : data) all.push_back(d.limit);
    all.push_back(left_censored(1.0));
    all.push_back(Observation{1.0, 2.0});
    auto stressed = data;
    stressed.push_back({0.5, all[17]});
    stressed.push_back({1.0, all[18]});
    const StressModel m = fit_stress_model(stressed, {0, 0});
    const Fit f = fit(Law::lognormal, all);
    CHECK(m.median_terms[0] == near(f.law.location, 1e-11));
    CHECK(std::exp(m.dispersion_terms[0]) == near(f.law.dispersion, 1e-11));
    CHECK(m.log_likelihood == near(f.log_likelihood, 1e-11));
    CHECK(m.covariance(0, 0) == near(f.covariance(0, 0), 1e-10));
    CHECK(m.covariance(0, 1) == near(f.covariance(0, 1), 1e-9));
    CHECK(m.covariance(1, 1) == near(f.covariance(1, 1), 1e-10));
}

TEST_CASE("stress model: with as many terms as levels it is a fit at each level",
          "[fragility][stress_model]")
{
    std::vector<StressedObservation> data;
    std::vector<Observation> low;
    for (const auto& d : many_walls()) {
        if (d.stress == 0.5 || d.stress == 1.0) data.push_back(d);
        if (d.stress == 0.5) low.push_back(d.limit);
    }
    const StressModel m = fit_stress_model(data, {1, 1});
    const Fit f = fit(Law::lognormal, low);
    const AtStress g = at_stress(m, 0.5);
    CHECK(g.law.location == near(f.law.location));
    CHECK(g.law.dispersion == near(f.law.dispersion));
    CHECK(g.covariance(0, 0) == near(f.covariance(0, 0), 1e-7));
    CHECK(g.covariance(1, 1) == near(f.covariance(1, 1), 1e-7));
    CHECK(g.covariance(0, 1) == near(f.covariance(0, 1), 1e-6));
}

TEST_CASE("stress model: AIC finds the degrees of the law behind the data",
          "[fragility][stress_model]")
{
    const StressModel m = fit_stress_model(many_walls());
    REQUIRE(m.outcome == FitOutcome::converged);
    CHECK(m.median_terms.size() == 3);
    CHECK(m.dispersion_terms.size() == 2);
    // a stress between the levels, within its error
    const AtStress at = at_stress(m, 0.3);
    CHECK(at.law.location ==
          Approx(1.0 - 0.3 + 0.027).margin(std::sqrt(at.covariance(0, 0))).epsilon(0));
    CHECK(std::log(at.law.dispersion) ==
          Approx(-1.0 + 0.12).margin(std::sqrt(at.covariance(1, 1))).epsilon(0));
}

TEST_CASE("stress model: units of drift and stress do not matter", "[fragility][stress_model]")
{
    auto data = walls();
    const StressModel m = fit_stress_model(data, {2, 1});
    for (auto& d : data) {
        d.stress *= 1e6;
        d.limit.lower *= 0.01;
        d.limit.upper *= 0.01;
    }
    const StressModel k = fit_stress_model(data, {2, 1});
    const StressPrediction a = predict(m, 0.6);
    const StressPrediction b = predict(k, 0.6e6);
    CHECK(b.median == near(0.01 * a.median, 1e-10));
    CHECK(b.confidence.lower == near(0.01 * a.confidence.lower, 1e-9));
    CHECK(b.prediction.upper == near(0.01 * a.prediction.upper, 1e-9));
    CHECK(a.prediction.lower < a.confidence.lower);
    const AtStress at = at_stress(m, 0.6);
    const double both = std::sqrt(at.law.dispersion * at.law.dispersion + at.covariance(0, 0));
    CHECK(std::log(a.prediction.upper / a.median) == near(1.959963984540054 * both));
}

TEST_CASE("stress model: what the levels do not carry is named", "[fragility][stress_model]")
{
    const auto data = walls();
    CHECK(fit_stress_model({}, {0, 0}).outcome == FitOutcome::no_data);
    CHECK(fit_stress_model(std::span(data).first(7), {2, 0}).outcome == FitOutcome::too_few);
    auto stood = data;
    for (auto& d : stood) d.limit = right_censored(2.8);
    CHECK(fit_stress_model(stood).outcome != FitOutcome::converged);
    auto bad = data;
    bad[3].stress = std::nan("");
    CHECK(fit_stress_model(bad, {1, 0}).outcome == FitOutcome::invalid_value);
    CHECK_THROWS_AS(fit_stress_model(data, {4, 0}), std::invalid_argument);
    CHECK_THROWS_AS(at_stress(fit_stress_model({}, {0, 0}), 1.0), std::invalid_argument);
}
