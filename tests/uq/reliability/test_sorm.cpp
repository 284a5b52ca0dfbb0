#include "uq/reliability/design_point/sorm.hpp"

#include "tests/uq/reliability/reliability_problems.hpp"

#include <catch2/catch.hpp>
#include <gsl/gsl_cdf.h>
#include <gsl/gsl_randist.h>

#include <cmath>
#include <stdexcept>

using namespace uq;
using Eigen::VectorXd;

namespace {

/// P(U > beta + kappa V^2 / 2) by Simpson's rule over V.
double by_quadrature(double beta, double kappa)
{
    const int n = 40000;
    const double top = 40.0, h = 2.0 * top / n;
    double sum = 0.0;
    for (int i = 0; i <= n; ++i) {
        const double v = -top + h * i;
        const double weight = i == 0 || i == n ? 1.0 : (i % 2 == 1 ? 4.0 : 2.0);
        sum +=
            weight * gsl_ran_ugaussian_pdf(v) * gsl_cdf_ugaussian_Q(beta + 0.5 * kappa * v * v);
    }
    return sum * h / 3.0;
}

SormResult of(const problems::Problem& p, double step)
{
    FormOptions o;
    o.starts = 1;
    o.search.step = 1e-4;
    o.search.on_surface = 1e-9;
    o.search.on_axis = 1e-8;
    return sorm(p.limit, form(p.limit, o).points.at(0), step);
}

} // namespace

TEST_CASE("sorm: the paraboloid's probability is its integral", "[uq][sorm]")
{
    const double beta = GENERATE(-2.0, -0.3, 0.0, 1e-3, 0.5, 2.0, 5.0, 12.0);
    const double kappa = GENERATE(-0.9, -0.07, 0.0, 0.07, 0.4, 5.0);
    INFO("beta " << beta << ", kappa " << kappa);
    CHECK(paraboloid_probability(beta, VectorXd::Constant(1, kappa)) ==
          Approx(by_quadrature(beta, kappa)).epsilon(1e-11).margin(0.0));
}

TEST_CASE("sorm: without curvature the paraboloid is a plane, in any dimension", "[uq][sorm]")
{
    for (const double beta : {-1.0, 0.0, 3.0, 8.0, 30.0})
        for (const Eigen::Index n : {0, 1, 5, 184})
            CHECK(paraboloid_probability(beta, VectorXd::Zero(n)) ==
                  Approx(gsl_cdf_ugaussian_Q(beta)).epsilon(1e-12).margin(0.0));
    CHECK_THROWS_AS(paraboloid_probability(std::nan(""), VectorXd::Zero(1)),
                    std::invalid_argument);
}

TEST_CASE("sorm: an RP22 limit state is a paraboloid, so Tvedt is exact", "[uq][sorm]")
{
    const SormResult r = of(problems::rp22(), 1e-2);
    REQUIRE(r.outcome == SormOutcome::found);
    CHECK(r.curvatures(0) == Approx(0.4).epsilon(1e-9));
    CHECK(*r.tvedt == Approx(4.207305511300e-3).epsilon(1e-9));
    CHECK(*r.breitung == Approx(gsl_cdf_ugaussian_Q(2.5) / std::sqrt(2.0)).epsilon(1e-9));
}

TEST_CASE("sorm: Breitung and Hohenbichler of Dakota, to the printed digits", "[uq][sorm]")
{
    // Dakota differentiates exactly: Richardson's extrapolation to a step of zero.
    const auto limit = [](const problems::Problem& p) {
        return (4.0 * *of(p, 2e-2).hohenbichler - *of(p, 4e-2).hohenbichler) / 3.0;
    };
    CHECK(limit(problems::portal_frame()) == Approx(1.2640106440e-2).epsilon(1e-9));
    CHECK(limit(problems::steel_section()) == Approx(1.3783736922e-7).epsilon(1e-10));
    CHECK(*of(problems::portal_frame(), 1e-2).breitung == Approx(1.201e-2).epsilon(4e-4));
}

TEST_CASE("sorm: planes keep the first-order probability", "[uq][sorm]")
{
    for (const problems::Problem& p : {problems::difference_4_2(), problems::difference_7_2(),
                                       problems::log_ratio(0.4), problems::log_ratio(1.75)}) {
        const SormResult r = of(p, 1e-2);
        REQUIRE(r.outcome == SormOutcome::found);
        for (const auto& value : {r.breitung, r.hohenbichler, r.tvedt})
            CHECK(*value == Approx(p.exact).epsilon(1e-7));
    }
}

TEST_CASE("sorm: a curved limit state that holds the origin has the rest of one", "[uq][sorm]")
{
    const problems::Problem p = problems::rp22();
    LimitState other = p.limit;
    other.passing = Passing::at_or_above;
    const SormResult r = sorm(other, form(other).points.at(0));
    CHECK(r.curvatures(0) == Approx(-0.4).epsilon(1e-6));
    CHECK(*r.tvedt == Approx(1.0 - p.exact).epsilon(1e-9));
}

TEST_CASE("sorm: a point that is not the nearest is refused", "[uq][sorm]")
{
    // A circle of radius 2 about (1, 0): its far point has beta 3 and curvature -1/2.
    const LimitState s = problems::limit_state(
        2, [](const VectorXd& x) { return 4.0 - (x(0) - 1.0) * (x(0) - 1.0) - x(1) * x(1); });
    Ledger ledger;
    const LinearLimit far = *linearise(s, Eigen::Vector2d(3.0, 0.0), 1e-3, ledger);
    const SormResult r = sorm(s, {far, direction(far), 3.0});
    CHECK(r.outcome == SormOutcome::not_a_minimum);
    CHECK_FALSE(r.tvedt);
    CHECK(r.curvatures(0) == Approx(-0.5).epsilon(1e-3));
    CHECK(form(s).points.at(0).beta == Approx(1.0).margin(1e-6));
}

TEST_CASE("sorm: a failed point of the differences is no answer", "[uq][sorm]")
{
    const problems::Problem p = problems::rp8();
    const DesignPoint point = form(p.limit).points.at(0);
    const LimitState s = problems::failing(p.limit, [](const VectorXd&) { return true; });
    const SormResult r = sorm(s, point);
    CHECK(r.outcome == SormOutcome::evaluation_failed);
    CHECK_FALSE(r.breitung);
    CHECK(r.ledger.evaluations == 51);
    CHECK_THROWS_AS(sorm(p.limit, point, 0.0), std::invalid_argument);
}

TEST_CASE("sorm: Hohenbichler's formula ends where it is not real", "[uq][sorm]")
{
    CHECK_FALSE(hohenbichler(2.0, VectorXd::Constant(1, -0.45)));
    CHECK(breitung(2.0, VectorXd::Constant(1, -0.45)) ==
          Approx(gsl_cdf_ugaussian_Q(2.0) / std::sqrt(0.1)).epsilon(1e-12));
    CHECK_THROWS_AS(breitung(2.0, VectorXd::Constant(1, -0.5)), std::invalid_argument);
    CHECK_THROWS_AS(breitung(-1.0, VectorXd::Zero(1)), std::invalid_argument);
}

TEST_CASE("sorm: beside a circle about the origin Breitung is left out", "[uq][sorm]")
{
    const LimitState s = problems::limit_state(
        2, [](const VectorXd& x) { return 3.5 - x.norm(); }); // P = exp(-3.5^2 / 2) = 0.0022
    Ledger ledger;
    const LinearLimit at = *linearise(s, Eigen::Vector2d(3.5, 0.0), 1e-3, ledger);
    const SormResult r = sorm(s, {at, direction(at), 3.5});
    CHECK(r.outcome == SormOutcome::found);
    CHECK_FALSE(r.breitung); // 0.16
    CHECK_FALSE(r.hohenbichler);
    CHECK(*r.tvedt == Approx(by_quadrature(3.5, -1.0 / 3.5)).epsilon(1e-3));
}
