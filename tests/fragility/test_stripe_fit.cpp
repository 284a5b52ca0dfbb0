#include "fragility/ordinal_fit.hpp"
#include "fragility/stripe_fit.hpp"

#include <catch2/catch.hpp>

#include <cmath>

using namespace fragility;

namespace {

auto near(double value, double tolerance = 1e-9)
{
    return Approx(value).epsilon(tolerance).margin(0.0);
}

/// Baker (2015), data of the example of the published tools.
const std::vector<Stripe> kBaker{{0.2, 0, 40}, {0.3, 0, 40},  {0.4, 0, 40},  {0.6, 4, 40},
                                 {0.7, 6, 40}, {0.8, 13, 40}, {0.9, 12, 40}, {1.0, 16, 40}};

const std::vector<StateCounts> kStates{{0.1, {38, 2, 0}},  {0.2, {30, 9, 1}},
                                       {0.3, {20, 16, 4}}, {0.4, {11, 20, 9}},
                                       {0.6, {4, 17, 19}}, {0.8, {1, 10, 29}}};

std::vector<Stripe> reaching(std::size_t state)
{
    std::vector<Stripe> s;
    for (const StateCounts& d : kStates) {
        double exceeded = 0.0;
        for (std::size_t k = state; k < 3; ++k) exceeded += d.walls[k];
        s.push_back({d.intensity, exceeded, 40.0});
    }
    return s;
}

} // namespace

TEST_CASE("stripe fit: Baker's example by maximum likelihood", "[fragility][stripe_fit]")
{
    const StripeFit f = fit_stripes(kBaker);
    REQUIRE(f.outcome == ModelOutcome::converged);
    CHECK(f.median == near(1.0761157943, 1e-10));
    CHECK(f.dispersion == near(0.4292372038, 2e-10));
    CHECK(f.b0 == near(-0.17090333924494, 1e-12));
    CHECK(f.b1 == near(2.32971417918063, 1e-12));
    CHECK(f.log_likelihood == near(-10.7977046621, 1e-11));
    CHECK(f.deviance == near(2.81972829233, 1e-10));
    CHECK(std::sqrt(f.expected(0, 0)) == near(0.0709738186794, 1e-7));
    CHECK(std::sqrt(f.expected(1, 1)) == near(0.0821036541053, 1e-7));
    CHECK(std::sqrt(f.observed(0, 0)) == near(0.071659541824932, 1e-11));
    CHECK(std::sqrt(f.observed(1, 1)) == near(0.083870649281066, 1e-11));
    CHECK(f.observed(0, 1) / std::sqrt(f.observed(0, 0) * f.observed(1, 1)) ==
          near(0.810492, 1e-6));
}

TEST_CASE("stripe fit: logit link and least squares of the same data",
          "[fragility][stripe_fit]")
{
    const StripeFit f = fit_stripes(kBaker, Link::logit);
    CHECK(f.b0 == near(-0.23380287348305, 1e-12));
    CHECK(f.b1 == near(4.18959138169732, 1e-12));
    CHECK(f.log_likelihood == near(-11.4224746303, 1e-11));
    const auto s = fit_least_squares(kBaker);
    REQUIRE(s);
    CHECK(s->median == near(1.12406876, 1e-8));
    CHECK(s->dispersion == near(0.50704845, 1e-8));
}

TEST_CASE("stripe fit: another unit scales the median and nothing else",
          "[fragility][stripe_fit]")
{
    auto data = kBaker;
    for (Stripe& s : data) s.intensity *= 9.81;
    const StripeFit f = fit_stripes(kBaker);
    const StripeFit g = fit_stripes(data);
    CHECK(g.median == near(9.81 * f.median, 1e-12));
    CHECK(g.dispersion == near(f.dispersion, 1e-12));
    CHECK(g.observed(0, 0) == near(f.observed(0, 0), 1e-10));
}

TEST_CASE("stripe fit: data without a curve are named", "[fragility][stripe_fit]")
{
    using enum ModelOutcome;
    const std::vector<std::pair<std::vector<Stripe>, ModelOutcome>> cases{
        {{}, no_data},
        {{{1, 0, 40}, {2, 0, 40}}, no_contrast},
        {{{1, 40, 40}, {2, 40, 40}}, no_contrast},
        {{{1, 3, 40}, {1, 5, 40}}, no_contrast},
        {{{1, 0, 40}, {2, 40, 40}}, separated},
        {{{1, 0, 40}, {2, 20, 40}, {3, 40, 40}}, separated},
        {{{1, 20, 40}, {2, 3, 40}}, wrong_slope},
        {{{1, 41, 40}, {2, 3, 40}}, invalid_value},
        {{{0, 1, 40}, {2, 3, 40}}, invalid_value},
        {{{1, std::nan(""), 40}, {2, 3, 40}}, invalid_value}};
    for (const auto& [data, outcome] : cases) {
        const StripeFit f = fit_stripes(data);
        CHECK(f.outcome == outcome);
        CHECK_FALSE(f.reason.empty());
        CHECK(f.median == 0.0);
        CHECK_FALSE(fit_least_squares(data));
    }
}

TEST_CASE("ordinal fit: three states as polr (R)", "[fragility][ordinal_fit]")
{
    const OrdinalFit f = fit_ordinal(kStates);
    REQUIRE(f.outcome == ModelOutcome::converged);
    CHECK(f.medians[0] == near(0.286848992, 2e-9));
    CHECK(f.medians[1] == near(0.604556304, 2e-9));
    CHECK(f.dispersion == near(0.564745168, 2e-9));
    CHECK(1.0 / f.dispersion == near(1.77071014947, 1e-9));
    CHECK(std::log(f.medians[0]) / f.dispersion == near(-2.21126170275, 1e-9));
    CHECK(std::log(f.medians[1]) / f.dispersion == near(-0.891128423812, 2e-9));
    CHECK(f.deviance == near(356.429407995, 1e-11));
    // from second differences of the likelihood written in R
    CHECK(std::sqrt(f.covariance(0, 0)) == near(0.05844062340, 1e-6));
    CHECK(std::sqrt(f.covariance(1, 1)) == near(0.06459076940, 1e-6));
    CHECK(std::sqrt(f.covariance(2, 2)) == near(0.05256974469, 1e-6));
    CHECK(f.covariance(0, 2) == near(-0.00069363929, 1e-5));
}

TEST_CASE("ordinal fit: separate probits of the same counts", "[fragility][ordinal_fit]")
{
    const StripeFit one = fit_stripes(reaching(1));
    const StripeFit two = fit_stripes(reaching(2));
    CHECK(one.median == near(0.286746592, 2e-9));
    CHECK(one.dispersion == near(0.575814551, 2e-9));
    CHECK(two.median == near(0.598889961, 2e-9));
    CHECK(two.dispersion == near(0.537204834, 2e-9));
}

TEST_CASE("ordinal fit: with two states it is the stripe fit", "[fragility][ordinal_fit]")
{
    std::vector<StateCounts> data;
    for (const Stripe& s : kBaker)
        data.push_back({s.intensity, {s.n - s.exceeded, s.exceeded}});
    const OrdinalFit o = fit_ordinal(data);
    const StripeFit s = fit_stripes(kBaker);
    CHECK(o.medians[0] == near(s.median));
    CHECK(o.dispersion == near(s.dispersion));
    CHECK(o.covariance(0, 0) == near(s.observed(0, 0)));
    CHECK(o.covariance(0, 1) == near(s.observed(0, 1)));
    CHECK(o.covariance(1, 1) == near(s.observed(1, 1)));
}

TEST_CASE("ordinal fit: data without curves are named", "[fragility][ordinal_fit]")
{
    using enum ModelOutcome;
    const std::vector<std::pair<std::vector<StateCounts>, ModelOutcome>> cases{
        {{}, no_data},
        {{{1, {3, 0, 2}}, {2, {1, 0, 4}}}, absent_mode},
        {{{1, {3, 1, 2}}, {1, {1, 3, 4}}}, no_contrast},
        {{{1, {3, 0, 0}}, {2, {0, 3, 0}}, {3, {0, 0, 3}}}, separated},
        {{{1, {1, 3, 9}}, {2, {9, 3, 1}}}, wrong_slope},
        {{{1, {3, 1}}, {2, {1, 3, 4}}}, invalid_value},
        {{{1, {3}}, {2, {1}}}, invalid_value},
        {{{1, {3, -1}}, {2, {1, 2}}}, invalid_value}};
    for (const auto& [data, outcome] : cases) {
        const OrdinalFit f = fit_ordinal(data);
        CHECK(f.outcome == outcome);
        CHECK(f.medians.empty());
        CHECK_FALSE(f.reason.empty());
    }
}
