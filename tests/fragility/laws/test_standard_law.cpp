#include "fragility/fits/gamma_likelihood.hpp"
#include "fragility/laws/standard_law.hpp"

#include <boost/math/distributions/normal.hpp>
#include <boost/math/special_functions/gamma.hpp>
#include <catch2/catch.hpp>

#include <cmath>
#include <limits>

using namespace fragility;

namespace {

auto near(double value, double tolerance) { return Approx(value).epsilon(tolerance).margin(0); }

/// Central difference of fourth order.
template <class F> double slope(F f, double x, double h)
{
    return (8.0 * (f(x + h) - f(x - h)) - (f(x + 2.0 * h) - f(x - 2.0 * h))) / (12.0 * h);
}

template <class F> void check_derivatives(F f, double z)
{
    const LogTerm t = f(z);
    const double h = 1e-3 * std::max(1.0, std::abs(z));
    CHECK(
        t.d1 ==
        Approx(slope([&](double x) { return f(x).value; }, z, h)).epsilon(1e-8).margin(1e-11));
    CHECK(t.d2 ==
          Approx(slope([&](double x) { return f(x).d1; }, z, h)).epsilon(1e-8).margin(1e-11));
}

template <class S> void check_between(double m, double h)
{
    const LogBetween t = S::log_between(m, h);
    const double sm = 0.01 * std::min(1.0, 10.0 * h);
    const auto at_m = [&](auto of) {
        return slope([&](double x) { return of(S::log_between(x, h)); }, m, 0.01);
    };
    const auto at_h = [&](auto of) {
        return slope([&](double x) { return of(S::log_between(m, x)); }, h, sm * h);
    };
    const auto value = [](const LogBetween& b) { return b.value; };
    const auto close = [](double x) { return Approx(x).epsilon(2e-6).margin(2e-6); };
    CHECK(t.m == close(at_m(value)));
    CHECK(t.h == close(at_h(value)));
    CHECK(t.mm == close(at_m([](const LogBetween& b) { return b.m; })));
    CHECK(t.mh == close(at_m([](const LogBetween& b) { return b.h; })));
    CHECK(t.hh == close(at_h([](const LogBetween& b) { return b.h; })));
}

} // namespace

TEST_CASE("standard law: derivatives of densities and tails agree with differences",
          "[fragility][standard_law]")
{
    const double z = GENERATE(-8.0, -3.0, -0.7, 0.0, 0.4, 1.9, 3.1);
    check_derivatives(StandardNormal::log_density, z);
    check_derivatives(StandardNormal::log_survival, z);
    check_derivatives(StandardNormal::log_cdf, z);
    check_derivatives(SmallestExtreme::log_density, z);
    check_derivatives(SmallestExtreme::log_survival, z);
    check_derivatives(SmallestExtreme::log_cdf, z);
    check_derivatives(StandardLogistic::log_survival, z);
    check_derivatives(StandardLogistic::log_cdf, z);
}

TEST_CASE("standard law: derivatives of intervals agree with differences, wide and narrow",
          "[fragility][standard_law]")
{
    const double m = GENERATE(-3.0, -0.4, 0.0, 1.3);
    const double h = GENERATE(1e-4, 2e-3, 0.3, 2.0);
    check_between<StandardNormal>(m, h);
    check_between<SmallestExtreme>(m, h);
}

TEST_CASE("standard law: a narrow interval joins the wide one", "[fragility][standard_law]")
{
    // either side of the switch at a width of 1e-3
    const double m = GENERATE(-2.0, 0.3, 1.7);
    for (const auto& between : {StandardNormal::log_between, SmallestExtreme::log_between}) {
        const LogBetween a = between(m, 1e-3 * (1.0 - 1e-9));
        const LogBetween b = between(m, 1e-3 * (1.0 + 1e-9));
        CHECK(a.value == near(b.value, 1e-9));
        CHECK(a.m == near(b.m, 1e-8));
        CHECK(a.mm == near(b.mm, 1e-7));
        CHECK(a.h == near(b.h, 1e-8));
    }
}

TEST_CASE("standard law: tails hold far out", "[fragility][standard_law]")
{
    // Mills' ratio lies between z / (1 + z^2) and 1 / z
    const double z = GENERATE(5.0, 24.9, 25.1, 60.0, 1e3);
    const LogTerm t = StandardNormal::log_survival(z);
    const double density = StandardNormal::log_density(z).value;
    CHECK(t.value < density - std::log(z));
    CHECK(t.value > density + std::log(z / (1.0 + z * z)) - 1e-9 * z * z);
    CHECK(-t.d1 > z);
    CHECK(-t.d1 < z + 1.0 / z);
    CHECK(t.d2 < 0.0);
    CHECK(t.d2 > -1.0);
    // the switch at 25 is not seen
    const double below = StandardNormal::log_survival(25.0 - 1e-12).value;
    CHECK(StandardNormal::log_survival(25.0).value == near(below, 1e-12));
    CHECK(StandardNormal::log_survival(25.0 - 1e-12).d2 ==
          near(StandardNormal::log_survival(25.0).d2, 1e-8));
    CHECK(StandardNormal::log_survival(8.0).value ==
          near(std::log(boost::math::cdf(complement(boost::math::normal(), 8.0))), 1e-14));
}

TEST_CASE("standard law: quantiles undo the distribution", "[fragility][standard_law]")
{
    const double p = GENERATE(1e-9, 0.01, 0.16, 0.5, 0.84, 0.999);
    CHECK(StandardNormal::cdf(StandardNormal::quantile(p)) == near(p, 1e-13));
    CHECK(SmallestExtreme::cdf(SmallestExtreme::quantile(p)) == near(p, 1e-13));
}

TEST_CASE("gamma law: moments of ln x give the incomplete gamma function and its derivatives",
          "[fragility][gamma]")
{
    constexpr double inf = std::numeric_limits<double>::infinity();
    const double a = GENERATE(0.06, 0.5, 1.0, 3.7, 42.0, 900.0);
    const double at = std::log(a * GENERATE(0.3, 0.95, 1.4));
    const LogGammaMoments left = log_gamma_moments(a, -inf, at);
    const LogGammaMoments right = log_gamma_moments(a, at, inf);
    CHECK(left.log_integral - std::lgamma(a) ==
          Approx(std::log(boost::math::gamma_p(a, std::exp(at)))).epsilon(1e-11).margin(1e-11));
    CHECK(right.log_integral - std::lgamma(a) ==
          Approx(std::log(boost::math::gamma_q(a, std::exp(at)))).epsilon(1e-11).margin(1e-11));
    const double h = 1e-3 * a;
    const auto mean =
        slope([&](double x) { return log_gamma_moments(x, at, inf).log_integral; }, a, h);
    const auto variance =
        slope([&](double x) { return log_gamma_moments(x, at, inf).mean; }, a, h);
    CHECK(right.mean == Approx(mean).epsilon(1e-8).margin(1e-8));
    CHECK(right.variance == near(variance, 1e-6));
}
