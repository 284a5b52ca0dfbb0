#include "fragility/fits/censored_fit.hpp"

#include "fragility/fits/fit_intervals.hpp"
#include "fragility/fits/gamma_likelihood.hpp"
#include "tests/fragility/fit_data.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>

using namespace fragility;

namespace {

auto near(double value, double tolerance = 1e-9)
{
    return Approx(value).epsilon(tolerance).margin(0.0);
}

/// Observations of every kind, under any of the laws.
std::vector<Observation> mixed_data()
{
    std::vector<Observation> data = fit_data::all_observed({3.1, 4.6, 5.0, 6.2, 7.7, 9.4});
    data.push_back(right_censored(8.0));
    data.push_back(right_censored(10.0));
    data.push_back(left_censored(3.5));
    data.push_back(Observation{4.0, 8.0});
    data.push_back({5.5, 5.500001, 2.0});
    data.push_back({0.0, 4.0, 1.0});
    return data;
}

const std::vector<Law> kLaws{Law::lognormal, Law::normal, Law::weibull, Law::gamma};

} // namespace

TEST_CASE("censored fit: locomotive controls, 61 % censored, as published",
          "[fragility][censored_fit]")
{
    const Fit f = fit(Law::lognormal, fit_data::locomotive_controls());
    REQUIRE(f.outcome == FitOutcome::converged);
    CHECK(f.law.location == near(5.11692471854, 1e-11));
    CHECK(f.law.dispersion == near(0.705494029284, 1e-11));
    CHECK(f.log_likelihood == near(-237.093545341, 1e-11));
    CHECK(f.location_error == near(0.1041572337));
    CHECK(f.dispersion_error == near(0.0931985726));
    CHECK(f.law.location == Approx(5.1169).margin(5e-5)); // as printed
    CHECK(f.law.dispersion == Approx(0.7055).margin(5e-5));
    CHECK(f.counts.observed == 37.0);
    CHECK(f.counts.right == 59.0);
    CHECK(f.aic == near(4.0 + 2.0 * 237.093545341));
    CHECK(f.bic == near(2.0 * std::log(96.0) + 2.0 * 237.093545341));
}

TEST_CASE("censored fit: without censoring the lognormal fit is the closed form",
          "[fragility][censored_fit]")
{
    const auto data = fit_data::all_observed(fit_data::lognormal350);
    const Fit f = fit(Law::lognormal, data);
    REQUIRE(f.outcome == FitOutcome::converged);
    CHECK(f.law.location == near(-4.43578971603651, 1e-14));
    CHECK(f.law.dispersion == near(0.475792062177776, 1e-13));
    CHECK(f.log_likelihood == near(1315.86894152, 1e-11));
    CHECK(f.location_error == near(0.0254321554859));
    CHECK(f.dispersion_error == near(0.0179832496043));
    CHECK(f.covariance(1, 1) == near(1.0 / 700.0, 1e-11));
}

TEST_CASE("censored fit: 71 of 350 right-censored, as survreg", "[fragility][censored_fit]")
{
    const Fit f = fit(Law::lognormal, fit_data::stopped_at(fit_data::lognormal350, 0.018));
    REQUIRE(f.outcome == FitOutcome::converged);
    CHECK(f.counts.right == 71.0);
    CHECK(f.law.location == near(-4.42957524999, 1e-11));
    CHECK(f.law.dispersion == near(0.486355636176, 1e-11));
    CHECK(f.log_likelihood == near(1016.96891818, 1e-11));
    CHECK(f.location_error == near(0.0268083180));
    CHECK(std::sqrt(f.covariance(1, 1)) == near(0.0444953795));
}

TEST_CASE("censored fit: five values and two below -1.5 under a normal law",
          "[fragility][censored_fit]")
{
    auto data = fit_data::all_observed({-1, 0, 1, 2, 3});
    data.push_back({-std::numeric_limits<double>::infinity(), -1.5, 2.0});
    const Fit f = fit(Law::normal, data);
    REQUIRE(f.outcome == FitOutcome::converged);
    CHECK(f.law.location == near(-0.0884168703679, 1e-11));
    CHECK(f.law.dispersion == near(2.1727959351765, 1e-11));
    CHECK(f.log_likelihood == near(-12.8711181124113, 1e-13)); // R, survreg
}

TEST_CASE("censored fit: derivatives of every law agree with differences",
          "[fragility][censored_fit]")
{
    const Law law = GENERATE(from_range(kLaws));
    const CensoredSample s = prepare(law, mixed_data());
    const Working theta = law == Law::normal ? Working(5.0, 0.9) : Working(1.8, -0.6);
    const Likelihood l = log_likelihood(s, theta);
    for (int k = 0; k < 2; ++k) {
        const auto at = [&](double step) {
            Working moved = theta;
            moved[k] += step;
            return log_likelihood(s, moved);
        };
        const double h = 1e-3;
        const auto slope = [&](auto of) {
            return (8.0 * (of(at(h)) - of(at(-h))) - (of(at(2 * h)) - of(at(-2 * h)))) /
                   (12 * h);
        };
        CHECK(l.gradient[k] == near(slope([](const auto& x) { return x.value; }), 1e-8));
        CHECK(l.hessian(0, k) ==
              near(slope([](const auto& x) { return x.gradient[0]; }), 1e-7));
        CHECK(l.hessian(1, k) ==
              near(slope([](const auto& x) { return x.gradient[1]; }), 1e-7));
    }
}

TEST_CASE("censored fit: the gradient vanishes at the fit of every law",
          "[fragility][censored_fit]")
{
    const Law law = GENERATE(from_range(kLaws));
    const auto data = mixed_data();
    const Fit f = fit(law, data);
    REQUIRE(f.outcome == FitOutcome::converged);
    const Likelihood l = log_likelihood(prepare(law, data), working(f.law));
    for (int k = 0; k < 2; ++k)
        CHECK(std::abs(l.gradient[k]) * std::sqrt(f.covariance(k, k)) < 1e-7);
    CHECK(f.iterations < 25);
}

TEST_CASE("censored fit: another unit scales the fit and nothing else",
          "[fragility][censored_fit]")
{
    const Law law = GENERATE(from_range(kLaws));
    const double unit = GENERATE(1e-6, 0.01, 1000.0);
    auto data = mixed_data();
    const Fit f = fit(law, data);
    for (Observation& o : data) {
        o.lower *= unit;
        o.upper *= unit;
    }
    const Fit g = fit(law, data);
    REQUIRE(g.outcome == FitOutcome::converged);
    CHECK(quantile(g.law, 0.5) == near(unit * quantile(f.law, 0.5), 1e-10));
    if (law == Law::normal) {
        CHECK(g.law.dispersion == near(unit * f.law.dispersion, 1e-10));
        CHECK(g.location_error == near(unit * f.location_error, 1e-9));
    } else {
        CHECK(g.law.dispersion == near(f.law.dispersion, 1e-9));
        CHECK(g.location_error == near(f.location_error, 1e-9));
    }
    CHECK(g.dispersion_error / g.law.dispersion ==
          near(f.dispersion_error / f.law.dispersion, 1e-9));
}

TEST_CASE("censored fit: a weight of three is the same as three walls",
          "[fragility][censored_fit]")
{
    const Law law = GENERATE(from_range(kLaws));
    auto heavy = mixed_data();
    auto many = heavy;
    for (Observation& o : heavy) o.weight *= 3.0;
    many.insert(many.end(), heavy.size(), {});
    for (std::size_t i = 0; i < heavy.size(); ++i) {
        many[heavy.size() + i] = many[i];
        many[heavy.size() + i].weight *= 2.0;
    }
    const Fit f = fit(law, heavy);
    const Fit g = fit(law, many);
    CHECK(f.law.location == near(g.law.location, 1e-11));
    CHECK(f.log_likelihood == near(g.log_likelihood, 1e-11));
    CHECK(f.counts.n == g.counts.n);
}

TEST_CASE("censored fit: an exponential law censored at one time is total time by failures",
          "[fragility][censored_fit]")
{
    // Weibull with shape free; its profile at shape 1: scale = sum of times / failures
    const std::vector<double> times{0.3, 0.5, 0.9, 1.4, 2.2, 3.0};
    auto data = fit_data::all_observed(times);
    for (int i = 0; i < 4; ++i) data.push_back(right_censored(3.5));
    const double scale = (8.3 + 4 * 3.5) / 6.0;
    const Working theta = working({Law::weibull, std::log(scale), 1.0});
    const Likelihood l = log_likelihood(prepare(Law::weibull, data), theta);
    CHECK(l.gradient[0] == Approx(0.0).margin(1e-12));
    CHECK(l.value == near(-6.0 * std::log(scale) - 6.0, 1e-13));
}

TEST_CASE("censored fit: a gamma fit has the mean of the data and the equation of its shape",
          "[fragility][censored_fit]")
{
    const auto data = fit_data::all_observed(fit_data::lognormal350);
    const Fit f = fit(Law::gamma, data);
    REQUIRE(f.outcome == FitOutcome::converged);
    double mean_x = 0.0;
    for (const double x : fit_data::lognormal350) mean_x += x / 350.0;
    CHECK(std::exp(f.law.location) == near(mean_x, 1e-10));
    // R: fitdistr(x, "gamma"), polished with optim: see check_survival.R for censored data
    CHECK(f.location_error == near(f.law.dispersion / std::sqrt(350.0), 1e-9));
}

TEST_CASE("censored fit: what cannot be fitted is named and gives no number",
          "[fragility][censored_fit]")
{
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    constexpr double inf = std::numeric_limits<double>::infinity();
    using D = std::vector<Observation>;
    const std::vector<std::pair<D, FitOutcome>> cases{
        {{}, FitOutcome::no_data},
        {{observed(1)}, FitOutcome::too_few},
        {{observed(1), observed(2)}, FitOutcome::too_few},
        {{observed(2), observed(2), observed(2)}, FitOutcome::no_spread},
        {{observed(2), observed(2), right_censored(1.0)}, FitOutcome::no_spread},
        {{observed(2), right_censored(3), right_censored(3)}, FitOutcome::too_few},
        {D(12, right_censored(3)), FitOutcome::all_censored},
        {D(12, left_censored(3)), FitOutcome::all_censored},
        {{Observation{1, 3}, Observation{2, 4}, Observation{1, 4}}, FitOutcome::no_spread},
        {{observed(1), observed(2), observed(0.0)}, FitOutcome::not_positive},
        {{observed(1), observed(2), observed(-1.0)}, FitOutcome::not_positive},
        {{observed(1), observed(2), observed(nan)}, FitOutcome::invalid_value},
        {{observed(1), observed(2), observed(inf)}, FitOutcome::invalid_value},
        {{observed(1), observed(2), {3, 2}}, FitOutcome::invalid_value},
        {{observed(1), observed(2), {0, inf}}, FitOutcome::invalid_value},
        {{observed(1), observed(2), {3, 3, 0.0}}, FitOutcome::invalid_value},
        {{observed(1), observed(2), {3, 3, nan}}, FitOutcome::invalid_value},
        // more fail below 1 than stand above 3: the slope of such data is negative
        {{right_censored(3), right_censored(3), right_censored(2), left_censored(1),
          left_censored(1), left_censored(1.5)},
         FitOutcome::no_finite_fit}};
    for (std::size_t i = 0; i < cases.size(); ++i) {
        INFO("case " << i);
        const Fit f = fit(Law::lognormal, cases[i].first);
        CHECK(f.outcome == cases[i].second);
        CHECK_FALSE(f.reason.empty());
        if (f.outcome == FitOutcome::no_spread) // a number here would have no unit
            CHECK(f.reason == "all 3 agree with one and the same value: no curve");
        CHECK(f.law.location == 0.0);
        CHECK(f.location_error == 0.0);
        CHECK(f.log_likelihood == 0.0);
    }
}

TEST_CASE("censored fit: the tail of a gamma law far beyond its mean is that of its asymptote",
          "[fragility][censored_fit]")
{
    // Gamma(a, x) = x^(a - 1) e^-x (1 + (a - 1) / x + ...): steps in s = ln x are far below its
    // rounding
    for (const double a : {0.01, 1.0, 50.0})
        for (const double s : {30.0, 36.0, 60.0, 100.0}) {
            const LogGammaMoments m =
                log_gamma_moments(a, s, std::numeric_limits<double>::infinity());
            CHECK(m.log_integral == near((a - 1.0) * s - std::exp(s)));
            CHECK(m.mean == near(s));
            CHECK(m.mean_exp == near(std::exp(s)));
        }
}

TEST_CASE("censored fit: two walls of 49 and the others stopped have an answer under every law",
          "[fragility][censored_fit]")
{
    std::vector<Observation> data(47, right_censored(2.73));
    data.push_back(observed(1.5));
    data.push_back(observed(2.5));
    const Fit f = fit(GENERATE(from_range(kLaws)), data);
    REQUIRE(f.outcome == FitOutcome::converged);
    CHECK(quantile(f.law, 0.5) > 2.73);
    CHECK(profile_interval(f, data, quantile_of(0.95)).lower > 2.73);
    CHECK(cdf(f.law, 2.73) == Approx(2.0 / 49.0).epsilon(0.1));
}

TEST_CASE("censored fit: heavy censoring and far starts converge", "[fragility][censored_fit]")
{
    const Law law = GENERATE(from_range(kLaws));
    // two failures early, 98 that stand twice as far
    std::vector<Observation> data{observed(1.0), observed(1.3)};
    for (int i = 0; i < 98; ++i) data.push_back(right_censored(2.0));
    const Fit f = fit(law, data);
    if (f.outcome == FitOutcome::converged) {
        CHECK(f.location_error > 0.0);
        const Distribution far{law, f.law.location + 5.0, 3.0 * f.law.dispersion};
        const Fit g = fit(prepare(law, data), &far);
        if (law != Law::gamma) {
            REQUIRE(g.outcome == FitOutcome::converged);
            CHECK(g.law.location == near(f.law.location, 1e-8));
        }
    } else {
        CHECK(law == Law::gamma);
    }
}

TEST_CASE("censored fit: no law is fitted to drift limits, whatever the others did",
          "[fragility][censored_fit]")
{
    std::vector<Observation> walls = {observed(1.0), observed(1.2), observed(0.9),
                                      right_censored(1.1)};
    for (const Law law : {Law::lognormal, Law::normal, Law::weibull, Law::gamma})
        CHECK(fit(law, walls).outcome == FitOutcome::converged);
    walls.push_back({1.3, 1.3, 1.0, true});
    for (const Law law : {Law::lognormal, Law::normal, Law::weibull, Law::gamma}) {
        const Fit f = fit(law, walls);
        CHECK(f.outcome == FitOutcome::capped);
        CHECK(f.counts.n == 5.0);
        CHECK(f.reason.find("1 of 5 walls") != std::string::npos);
    }
}
