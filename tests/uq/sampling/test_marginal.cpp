#include "uq/marginals/marginal.hpp"

#include "tests/uq/marginal_reference.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <vector>

using namespace uq;

namespace {

auto near(double value, double tolerance = 1e-12)
{
    return Approx(value).epsilon(tolerance).margin(0.0);
}

const double kInf = std::numeric_limits<double>::infinity();

} // namespace

TEST_CASE("marginal: both tails hold 12 digits from 1e-304 to 1, whole and cut",
          "[uq][marginal]")
{
    for (const scenes::MarginalPoint& r : scenes::marginal_points()) {
        CAPTURE(r.marginal.shape.index(), r.marginal.lower, r.x);
        CHECK(cdf(r.marginal, r.x) == near(r.below));
        CHECK(complement(r.marginal, r.x) == near(r.above));
    }
}

TEST_CASE("marginal: quantiles from either tail lead back to 12 digits, down to 1e-304",
          "[uq][marginal]")
{
    for (const scenes::MarginalPoint& r : scenes::marginal_points()) {
        CAPTURE(r.marginal.shape.index(), r.marginal.lower, r.x);
        if (r.below <= 0.5) CHECK(quantile(r.marginal, r.below) == near(r.x));
        if (r.above <= 0.5) CHECK(upper_quantile(r.marginal, r.above) == near(r.x));
        // By probabilities where x is one of many: near 1 only these are resolved.
        if (r.below > 0.5 && r.below < 1.0)
            CHECK(cdf(r.marginal, quantile(r.marginal, r.below)) == near(r.below));
        if (r.above > 0.5 && r.above < 1.0)
            CHECK(complement(r.marginal, upper_quantile(r.marginal, r.above)) == near(r.above));
    }
}

TEST_CASE("marginal: the normal axis leads to the same point and back", "[uq][marginal]")
{
    for (const scenes::MarginalPoint& r : scenes::marginal_points()) {
        CAPTURE(r.marginal.shape.index(), r.marginal.lower, r.x);
        const double z = to_normal(r.marginal, r.x);
        CHECK(cdf(Marginal{Normal{0.0, 1.0}}, z) == near(r.below, 1e-11));
        CHECK(complement(Marginal{Normal{0.0, 1.0}}, z) == near(r.above, 1e-11));
        CHECK(from_normal(r.marginal, z) == near(r.x, 1e-11));
    }
}

TEST_CASE(
    "marginal: the tensile strength of the paper's Table 5 has ln mean 1.265 and ln sd 0.294",
    "[uq][marginal]")
{
    const Lognormal ft = lognormal_from_moments(3.7, 0.30);
    CHECK(std::round(1e3 * ft.mu_log) == 1265.0);
    CHECK(std::round(1e3 * ft.sigma_log) == 294.0);
    // LN(mean 0.6, cov 0.1), Dakota reference manual, to the digits of the closed form
    CHECK(lognormal_from_moments(0.6, 0.1).sigma_log == near(0.0997513451195927, 1e-14));
    CHECK(lognormal_from_moments(0.6, 0.1).mu_log == near(-0.515800789192575, 1e-14));
}

TEST_CASE("marginal: what is made from moments has these moments", "[uq][marginal]")
{
    const double cov = GENERATE(0.02, 0.25, 1.3), half = std::sqrt(3.0) * cov * 3.7;
    const std::vector<Marginal> all = {
        {normal_from_moments(3.7, cov)},           {lognormal_from_moments(3.7, cov)},
        {Uniform{3.7 - half, 3.7 + half}},         {gamma_from_moments(3.7, cov)},
        {gumbel_from_moments(3.7, cov)},           {weibull_from_moments(3.7, cov)},
        {beta_from_moments(3.7, cov, -10.0, 20.0)}};
    for (const Marginal& m : all) {
        CAPTURE(m.shape.index());
        CHECK(mean(m) == near(3.7));
        CHECK(sd(m) == near(3.7 * cov));
    }
    CHECK(sd({normal_from_moments(-5.0, 0.1)}) == near(0.5));
}

TEST_CASE("marginal: means and deviations of shapes cut where nothing is are the closed forms",
          "[uq][marginal]")
{
    // The cut takes the way of integration; what it takes away is below 1e-30.
    const std::vector<Marginal> all = {{Normal{35.0, 7.0}, -100.0, 170.0},
                                       {Lognormal{1.25, 0.3}, 1e-3, 1e5},
                                       {Triangular{1.0, 2.0, 5.0}, 1.0, 4.999999999999999},
                                       {Beta{2.0, 5.0, 0.0, 1.0}, 1e-20, kInf},
                                       {Gamma{2.5, 2.0}, 1e-20, kInf},
                                       {Weibull{1.5, 3.0}, 1e-25, kInf},
                                       {Gumbel{10.0, 2.0}, -20.0, kInf}};
    for (const Marginal& m : all) {
        CAPTURE(m.shape.index());
        CHECK(mean(m) == near(mean(Marginal{m.shape})));
        CHECK(sd(m) == near(sd(Marginal{m.shape})));
    }
}

TEST_CASE("marginal: moments of a cut normal, also deep in its tail", "[uq][marginal]")
{
    // Half normal: sqrt(2/pi), sqrt(1 - 2/pi). Above 30 sd: phi/Q and 1 + 30 m - m^2 (mpmath).
    CHECK(mean({Normal{0.0, 1.0}, 0.0}) == near(0.79788456080286535588));
    CHECK(sd({Normal{0.0, 1.0}, 0.0}) == near(0.60281027498908697428));
    CHECK(mean({Normal{0.0, 1.0}, 30.0}) == near(30.033259667433677037));
    CHECK(sd({Normal{0.0, 1.0}, 30.0}) == near(0.033223056931746829667));
}

TEST_CASE("marginal: the density is the slope of both tails", "[uq][marginal]")
{
    for (const scenes::MarginalPoint& r : scenes::marginal_points()) {
        if (r.below < 1e-3 || r.above < 1e-3) continue;
        CAPTURE(r.marginal.shape.index(), r.marginal.lower, r.x);
        const double h = 1e-4 * std::min(std::abs(r.x), 1.0);
        const double slope = (cdf(r.marginal, r.x + h) - cdf(r.marginal, r.x - h)) / (2.0 * h);
        if (cdf(r.marginal, r.x - 2.0 * h) > 0.0 && complement(r.marginal, r.x + 2.0 * h) > 0.0)
            CHECK(pdf(r.marginal, r.x) == near(slope, 2e-4));
    }
    CHECK(pdf({Normal{0.0, 1.0}, 0.0}, -0.1) == 0.0);
}

TEST_CASE("marginal: observations are steps, the constant is one of them", "[uq][marginal]")
{
    const Marginal m{Empirical{{1.0, 2.0, 2.0, 5.0}}};
    CHECK(cdf(m, 0.9) == 0.0);
    CHECK(cdf(m, 2.0) == 0.75);
    CHECK(complement(m, 2.0) == 0.25);
    CHECK(quantile(m, 0.25) == 1.0);
    CHECK(quantile(m, 0.2500001) == 2.0);
    CHECK(upper_quantile(m, 0.25) == 2.0);
    CHECK(upper_quantile(m, 0.2499999) == 5.0);
    CHECK(mean(m) == 2.5);
    CHECK(sd(m) == near(1.5));
    for (const double x : {1.0, 2.0, 5.0}) CHECK(from_normal(m, to_normal(m, x)) == x);
    const Marginal left{m.shape, 1.5, 4.0};
    CHECK(mean(left) == 2.0);
    CHECK(upper_quantile(left, 1e-300) == 2.0);
    CHECK_THROWS_AS(pdf(m, 2.0), std::invalid_argument);

    const Marginal c{Constant{3.0}};
    CHECK(quantile(c, 1e-300) == 3.0);
    CHECK(from_normal(c, 40.0) == 3.0);
    CHECK(to_normal(c, 3.0) == 0.0);
    CHECK(sd(c) == 0.0);
}

TEST_CASE("marginal: nothing that comes out is not a number, however far out", "[uq][marginal]")
{
    for (const scenes::MarginalPoint& r : scenes::marginal_points())
        for (const double z : {-1e300, -40.0, 0.0, 40.0, 1e300}) {
            CAPTURE(r.marginal.shape.index(), r.marginal.lower, z);
            CHECK_FALSE(std::isnan(from_normal(r.marginal, z)));
            CHECK_FALSE(std::isnan(to_normal(r.marginal, z)));
            CHECK_FALSE(std::isnan(cdf(r.marginal, z)));
            CHECK_FALSE(std::isnan(complement(r.marginal, z)));
            CHECK_FALSE(std::isnan(pdf(r.marginal, z)));
        }
}

TEST_CASE("marginal: parameters out of range are refused with what is allowed",
          "[uq][marginal]")
{
    const auto refused = [](const Marginal& m, const char* says) {
        CHECK_THROWS_WITH(check(m), Catch::Contains(says));
        CHECK_THROWS_AS(check(m), std::invalid_argument);
    };
    refused({Constant{kInf}}, "constant: value is inf; allowed: a finite number");
    refused({Normal{0.0, 0.0}}, "normal: sd is 0; allowed: > 0");
    refused({Lognormal{0.0, -1.0}}, "lognormal: sigma_log");
    refused({Uniform{1.0, 1.0}}, "above the lower end");
    refused({Triangular{0.0, 2.0, 1.0}}, "triangular: mode is 2");
    refused({Beta{0.0, 1.0, 0.0, 1.0}}, "beta: alpha");
    refused({Gamma{1.0, std::nan("")}}, "gamma: scale");
    refused({Weibull{-1.0, 1.0}}, "weibull: shape");
    refused({Gumbel{0.0, 0.0}}, "gumbel: scale");
    refused({Empirical{}}, "empirical: no observations");
    refused({Empirical{{2.0, 1.0}}}, "ascending");
    refused({Normal{0.0, 1.0}, 2.0, 1.0}, "cut: upper end");
    refused({Normal{0.0, 1.0}, 40.0}, "nothing of the distribution is left");
    refused({Uniform{0.0, 1.0}, 1.0, 2.0}, "nothing of the distribution is left");
    refused({Constant{1.0}, 2.0}, "nothing of the distribution is left");
    for (const scenes::MarginalPoint& r : scenes::marginal_points())
        CHECK_NOTHROW(check(r.marginal));

    CHECK_THROWS_AS(lognormal_from_moments(-1.0, 0.1), std::invalid_argument);
    CHECK_THROWS_AS(normal_from_moments(0.0, 0.1), std::invalid_argument);
    CHECK_THROWS_AS(gamma_from_moments(1.0, 0.0), std::invalid_argument);
    CHECK_THROWS_AS(weibull_from_moments(1.0, 1e-5), std::invalid_argument);
    CHECK_THROWS_AS(beta_from_moments(0.5, 1.0, 0.0, 1.0), std::invalid_argument);
    CHECK_THROWS_AS(quantile({Normal{0.0, 1.0}}, 0.0), std::invalid_argument);
    CHECK_THROWS_AS(cdf({Normal{0.0, 1.0}}, std::nan("")), std::invalid_argument);
}
