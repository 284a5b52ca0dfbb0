#include "core/binomial.hpp"
#include "fragility/fits/bootstrap_random.hpp"
#include "fragility/limits/fragility_curve.hpp"
#include "fragility/limits/performance_limits.hpp"
#include "fragility/modes/mode_sensitivity.hpp"

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
const RandomBits kBits = fit_data::bits;

ModeGroup first(std::size_t n, double limit)
{
    auto data = fit_data::stopped_at(fit_data::lognormal350, limit);
    data.resize(n);
    return {data, Law::lognormal};
}

ModeGroup stood(std::size_t n, double limit)
{
    return {std::vector<Observation>(n, right_censored(limit)), Law::lognormal};
}

} // namespace

TEST_CASE("fragility curve: one half at the median, with the error of the median",
          "[fragility][fragility_curve]")
{
    const Law law = GENERATE(Law::lognormal, Law::weibull, Law::gamma);
    const auto data = fit_data::stopped_at(fit_data::lognormal350, 0.018);
    const Fit f = fit(law, data);
    const double x = value(f.law, median());
    const auto curve = fragility_curve(f, std::vector{0.0, 0.5 * x, x, 2.0 * x});
    CHECK(curve[0].probability == 0.0);
    CHECK(curve[0].band.upper == 0.0);
    CHECK(curve[2].probability == near(0.5));
    // dP = f(x) dx: the error of ln median times the density of ln x
    const double density = (cdf(f.law, x * (1 + 1e-5)) - cdf(f.law, x * (1 - 1e-5))) / 2e-5;
    CHECK(curve[2].std_error == near(density * uncertain(f, median()).axis_error, 1e-6));
    for (std::size_t i = 1; i < 4; ++i) {
        CHECK(curve[i].band.lower < curve[i].probability);
        CHECK(curve[i].band.upper > curve[i].probability);
        CHECK(curve[i].band.upper < 1.0);
        CHECK(curve[i].probability > curve[i - 1].probability);
    }
}

TEST_CASE("fragility curve: what was not fitted has no curve", "[fragility][fragility_curve]")
{
    const double drift[] = {0.01};
    CHECK_THROWS_AS(fragility_curve(fit(Law::lognormal, {}), drift), std::invalid_argument);
    const Fit f = fit(Law::lognormal, first(50, 1.0).limits);
    const double bad[] = {std::nan("")};
    CHECK_THROWS_AS(fragility_curve(f, bad), std::invalid_argument);
}

TEST_CASE("mixture: a single mode is its own curve", "[fragility][fragility_curve]")
{
    const std::vector<ModeGroup> modes{first(80, 0.018)};
    const std::vector<double> drifts{0.005, 0.012, 0.03};
    const Mixture m = mixture_curve(modes, drifts);
    const auto curve = fragility_curve(m.fits[0], drifts);
    for (std::size_t i = 0; i < 3; ++i) {
        CHECK(m.points[i].least == near(curve[i].probability));
        CHECK(m.points[i].most == near(curve[i].probability));
        CHECK(m.points[i].std_error == near(curve[i].std_error, 1e-7));
        CHECK(m.points[i].band.upper == near(curve[i].band.upper, 1e-9));
    }
}

TEST_CASE("mixture: walls that stood bound the curve from both sides",
          "[fragility][fragility_curve]")
{
    const std::vector<ModeGroup> modes{first(60, 1.0), stood(40, 0.028)};
    const std::vector<double> drifts{0.01, 0.028, 0.0281, 10.0};
    const Mixture m = mixture_curve(modes, drifts);
    CHECK(m.fits[1].outcome == FitOutcome::all_censored);
    CHECK(m.shares[0] == 0.6);
    const double bound = 1.0 - std::pow(0.05, 1.0 / 40.0);
    for (std::size_t i = 0; i < 4; ++i) {
        const double mine = cdf(m.fits[0].law, drifts[i]);
        CHECK(m.points[i].least == near(0.6 * mine));
        CHECK(m.points[i].most == near(0.6 * mine + 0.4 * (i < 2 ? bound : 1.0)));
        CHECK(m.points[i].band.lower <= m.points[i].least);
        CHECK(m.points[i].band.upper >= m.points[i].most - 1e-12);
    }
    // far out all of the first mode have failed: the error is that of the share
    CHECK(m.points[3].std_error == near(std::sqrt(0.24 / 100.0), 1e-6));
}

TEST_CASE("mixture: where runs end apart, `most` is bounded by the walls that went on",
          "[fragility][fragility_curve]")
{
    std::vector<ModeGroup> modes{first(60, 1.0), {{}, Law::lognormal}};
    for (int i = 1; i <= 40; ++i) modes[1].limits.push_back(right_censored(0.001 * i));
    const std::vector<double> drifts{0.0005, 0.0205, 0.0395, 0.041};
    const double stood[] = {40.0, 20.0, 1.0};
    const Mixture m = mixture_curve(modes, drifts);
    for (std::size_t i = 0; i < 4; ++i) {
        const double unknown = i < 3 ? 1.0 - std::pow(0.05, 1.0 / stood[i]) : 1.0;
        CHECK(m.points[i].most == near(m.points[i].least + 0.4 * unknown));
    }
}

TEST_CASE("mixture: if no mode has a fit, all walls together bound it",
          "[fragility][fragility_curve]")
{
    std::vector<ModeGroup> modes{stood(39, 2.7), stood(11, 2.7)};
    modes[1].limits[0] = observed(1.1);
    const std::vector<double> drifts{1.0, 2.7, 2.8};
    const Mixture m = mixture_curve(modes, drifts);
    for (std::size_t i = 0; i < 2; ++i) {
        CHECK(m.points[i].least == near(i == 0 ? 0.0 : 0.02));
        CHECK(m.points[i].most == near(core::binomial_upper_bound(i == 0 ? 0 : 1, 50)));
        CHECK(m.points[i].band.upper >= m.points[i].most);
    }
    CHECK(m.points[0].band.upper == near(m.points[0].most));
    CHECK(m.points[2].most == 1.0);
}

TEST_CASE("mixture: walls that failed count in a mode that has too few for a fit",
          "[fragility][fragility_curve]")
{
    std::vector<ModeGroup> modes{first(60, 1.0), stood(40, 0.028)};
    modes[1].limits[0] = observed(0.02);
    const std::vector<double> drifts{0.0199, 0.02, 10.0};
    const Mixture m = mixture_curve(modes, drifts);
    CHECK(m.fits[1].outcome == FitOutcome::too_few);
    for (std::size_t i = 0; i < 3; ++i) {
        const double mine = 0.6 * cdf(m.fits[0].law, drifts[i]);
        CHECK(m.points[i].least == near(mine + (i == 0 ? 0.0 : 0.4 / 40.0)));
    }
    CHECK(m.points[1].most ==
          near(0.6 * cdf(m.fits[0].law, 0.02) + 0.4 * core::binomial_upper_bound(1, 40)));
    // 61 of 100 walls have failed far out
    CHECK(m.points[2].std_error == near(std::sqrt(0.61 * 0.39 / 100.0), 1e-6));
}

TEST_CASE("mixture: neither the curve nor its band falls with the drift",
          "[fragility][fragility_curve]")
{
    std::vector<ModeGroup> modes(2);
    for (int i = 0; i < 30; ++i) { // far apart: the tails are deep
        const double spread = std::exp(0.1 * (i % 5 - 2));
        modes[static_cast<std::size_t>(i % 2)].limits.push_back(
            observed((i % 2 + 0.1) * spread));
    }
    std::vector<double> drifts;
    for (int i = 1; i <= 200; ++i) drifts.push_back(0.02 * i);
    const auto points = mixture_curve(modes, drifts).points;
    for (std::size_t i = 1; i < points.size(); ++i) {
        CHECK(points[i].least >= points[i - 1].least);
        CHECK(points[i].band.lower >= points[i - 1].band.lower);
        CHECK(points[i].band.upper >= points[i - 1].band.upper);
    }
    std::swap(drifts[3], drifts[5]);
    CHECK_THROWS_AS(mixture_curve(modes, drifts), std::invalid_argument);
}

TEST_CASE(
    "mixture: its band holds the truth in 93 of 100 studies whose runs end apart, or more",
    "[fragility][fragility_curve]")
{
    const Distribution laws[] = {{Law::lognormal, 0.79, 0.4}, {Law::lognormal, 0.26, 0.5}};
    const std::vector<double> drifts{0.65, 0.93, 1.64, 2.73};
    constexpr int kStudies = 1000;
    std::vector<int> held(drifts.size(), 0);
    for (std::uint64_t study = 0; study < kStudies; ++study) {
        std::vector<ModeGroup> modes(2);
        for (std::uint64_t k = 0; k < 50; ++k) {
            const auto u = [&](std::uint64_t i) { return uniform(kBits(study, 3 * k + i)); };
            const std::size_t mode = u(0) < 0.4 ? 0 : 1;
            const double x = quantile(laws[mode], u(1)), end = 1.0 + 1.75 * u(2);
            modes[mode].limits.push_back(x < end ? observed(x) : right_censored(end));
        }
        const Mixture m = mixture_curve(modes, drifts);
        for (std::size_t i = 0; i < drifts.size(); ++i) {
            const double truth = 0.4 * cdf(laws[0], drifts[i]) + 0.6 * cdf(laws[1], drifts[i]);
            held[i] += m.points[i].band.lower <= truth && truth <= m.points[i].band.upper;
        }
    }
    for (const int h : held) {
        CHECK(h >= 930);
        CHECK(h <= 985); // wider bands would say less than they could
    }
}

TEST_CASE("mixture: data that are no numbers are refused", "[fragility][fragility_curve]")
{
    const double drift[] = {0.01};
    CHECK_THROWS_AS(mixture_curve({}, drift), std::invalid_argument);
    const std::vector<ModeGroup> bad{{{observed(std::nan(""))}, Law::lognormal}};
    CHECK_THROWS_AS(mixture_curve(bad, drift), std::invalid_argument);
}

TEST_CASE("performance limits: a row of a lognormal fit", "[fragility][performance_limits]")
{
    const auto data = fit_data::stopped_at(fit_data::lognormal350, 0.018);
    const PerformanceLimits r = performance_limits(Law::lognormal, data);
    REQUIRE(r.fitted);
    CHECK(r.n == 350.0);
    CHECK(r.censored_share == near(71.0 / 350.0));
    CHECK(r.dispersion == near(0.486355636176, 1e-11));
    CHECK(r.drifts[2].drift == near(std::exp(-4.42957524999), 1e-11));
    CHECK(r.drifts[0].drift ==
          near(std::exp(-4.42957524999 - 1.6448536269514722 * r.dispersion)));
    CHECK(r.median_error == near(0.0268083180, 1e-8));
    CHECK(r.predictive_dispersion == near(std::hypot(r.dispersion, 0.0268083180)));
    for (const DriftLimit& d : r.drifts) {
        CHECK(d.interval.lower < d.drift);
        CHECK(d.interval.upper > d.drift);
    }
}

TEST_CASE("performance limits: walls that stood give a bound and no number",
          "[fragility][performance_limits]")
{
    const PerformanceLimits r = performance_limits(Law::lognormal, stood(50, 0.028).limits);
    CHECK_FALSE(r.fitted);
    CHECK_FALSE(r.reason.empty());
    CHECK(r.drifts[2].drift == 0.0);
    CHECK(r.dispersion == 0.0);
    CHECK(r.censored_share == 1.0);
    CHECK(r.bound.median_above == 0.028);
    CHECK(r.bound.strictly);
    CHECK_FALSE(performance_limits(Law::lognormal, {}).fitted);
    CHECK_FALSE(performance_limits(Law::lognormal, std::vector{observed(std::nan(""))}).fitted);
}

TEST_CASE("mode sensitivity: shares move by the walls between two thresholds",
          "[fragility][mode_sensitivity]")
{
    const std::vector<std::vector<double>> walls{{0.1}, {0.35}, {0.45}, {0.55}, {0.9}};
    const std::vector<std::vector<double>> values{{0.5, 0.4, 0.3, 1.0}};
    const auto grid = threshold_grid(values);
    const ModeRule rule = [](std::span<const double> f, std::span<const double> t) {
        return f[0] > t[0] ? 1 : 0;
    };
    const auto s = mode_shares(walls, grid, rule, 2);
    REQUIRE(s.size() == 4);
    CHECK(s[0].shares[1] == near(0.4));
    CHECK(s[0].moved == 0.0);
    CHECK(s[1].shares[1] == near(0.6));
    CHECK(s[1].moved == near(0.2));
    CHECK(s[2].counts[1] == 4.0);
    CHECK(s[3].counts[0] == 5.0);
    CHECK(s[3].moved == near(0.4));
    CHECK(threshold_grid(std::vector<std::vector<double>>{{1, 2}, {3, 4, 5}}).size() == 6);
    CHECK(threshold_grid(std::vector<std::vector<double>>{{1, 2}, {3, 4, 5}})[1] ==
          std::vector<double>{1, 4});
    CHECK_THROWS_AS(mode_shares(walls, grid, rule, 1), std::invalid_argument);
    CHECK_THROWS_AS(mode_shares({}, grid, rule, 2), std::invalid_argument);
}
