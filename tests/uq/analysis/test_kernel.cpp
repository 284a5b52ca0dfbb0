#include "uq/fields/kernel.hpp"

#include "tests/uq/field_scenes.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>
#include <stdexcept>

using namespace uq;

namespace {

double at(const KernelFactor& f, double dx, double dz = 0.0)
{
    return correlation(Kernel{{f}}, Site{1.0, 2.0}, Site{1.0 + dx, 2.0 + dz});
}

auto near(double value, double tolerance = 1e-14)
{
    return Approx(value).epsilon(tolerance).margin(0.0);
}

} // namespace

TEST_CASE("kernel: each kind is its formula", "[uq][kernel]")
{
    CHECK(at(Exponential{0.5}, 0.3, 0.4) == near(std::exp(-1.0)));
    CHECK(at(SquaredExponential{0.5}, 0.3, 0.4) == near(std::exp(-1.0)));
    CHECK(at(SquaredExponential{0.25}, 0.3, 0.4) == near(std::exp(-4.0)));
    CHECK(at(ExponentialL1{0.5, 0.8}, 0.3, 0.4) == near(std::exp(-1.1)));
    CHECK(at(ExponentialL1{0.5, 0.8}, -0.3, 0.4) == near(std::exp(-1.1)));
}

TEST_CASE("kernel: Matern with nu = 1/2, 3/2, 5/2 is its closed form", "[uq][kernel]")
{
    const double d = GENERATE(1e-6, 1e-3, 0.1, 1.0, 3.0, 20.0);
    const double a = d * std::sqrt(3.0), b = d * std::sqrt(5.0);
    CHECK(at(Matern{0.5, 1.0}, d) == near(std::exp(-d), 2e-14));
    CHECK(at(Matern{1.5, 1.0}, d) == near((1.0 + a) * std::exp(-a), 2e-14));
    CHECK(at(Matern{2.5, 1.0}, d) == near((1.0 + b + b * b / 3.0) * std::exp(-b), 5e-14));
    CHECK(at(Matern{1.5, 2.0}, 2.0 * d) == near((1.0 + a) * std::exp(-a), 2e-14));
}

TEST_CASE("kernel: Matern tends to exp(-d^2 / (2 L^2)) as nu grows, error like 1 / nu",
          "[uq][kernel]")
{
    const double limit = std::exp(-0.5);
    const double e25 = at(Matern{25.0, 1.0}, 1.0) - limit;
    const double e50 = at(Matern{50.0, 1.0}, 1.0) - limit;
    CHECK(std::abs(e50) < 0.005);
    CHECK(e25 / e50 == Approx(2.0).epsilon(0.02));
}

TEST_CASE("kernel: Matern far away is 0 and at the same place 1", "[uq][kernel]")
{
    const double nu = GENERATE(0.05, 0.5, 1.7, 50.0);
    CHECK(at(Matern{nu, 1.0}, 0.0) == 1.0);
    CHECK(at(Matern{nu, 1e-3}, 1e6) == 0.0);
    CHECK(at(Matern{nu, 1.0}, 1e-12) <= 1.0);
    for (double d = 1e-8; d < 1e4; d *= 1.7) {
        // nu ln s and ln K cancel: rounding of nu ln s, at most 50 x 20 x 1.1e-16
        CHECK(at(Matern{nu, 1.0}, d) >= at(Matern{nu, 1.0}, 1.7 * d) * (1.0 - 2e-13));
        CHECK(at(Matern{nu, 1.0}, d) >= 0.0);
    }
}

TEST_CASE("kernel: a group has its correlation inside and none outside", "[uq][kernel]")
{
    const Site a{0.0, 0.0, 3, 7}, b{1.0, 0.0, 3, 8}, c{0.0, 1.0, 4, 7};
    const Kernel unit{{GroupCorrelation{Group::unit, 0.6}}};
    const Kernel course{{GroupCorrelation{Group::course, 0.6}}};
    const Kernel all{{GroupCorrelation{Group::all, 0.6}}};
    CHECK(correlation(unit, a, b) == 0.6);
    CHECK(correlation(unit, a, c) == 0.0);
    CHECK(correlation(course, a, b) == 0.0);
    CHECK(correlation(course, a, c) == 0.6);
    CHECK(correlation(all, b, c) == 0.6);
}

TEST_CASE("kernel: factors multiply, a site with itself is always 1", "[uq][kernel]")
{
    const auto sites = scenes::grid(3, 2, 0.2, 0.1);
    const Kernel k{{Exponential{0.2}, GroupCorrelation{Group::course, 0.5}}};
    const Eigen::MatrixXd r = correlation_matrix(k, sites);
    CHECK(r.isApprox(r.transpose(), 0.0));
    CHECK(r.diagonal() == Eigen::VectorXd::Ones(6));
    CHECK(r(0, 1) == near(0.5 * std::exp(-1.0)));
    CHECK(r(0, 3) == 0.0);
}

TEST_CASE("kernel: bad parameters are refused", "[uq][kernel]")
{
    const auto sites = scenes::grid(2, 1, 1.0, 1.0);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const KernelFactor& f :
         {KernelFactor{Exponential{0.0}}, KernelFactor{Exponential{nan}},
          KernelFactor{SquaredExponential{-1.0}}, KernelFactor{ExponentialL1{1.0, 0.0}},
          KernelFactor{Matern{0.0, 1.0}}, KernelFactor{Matern{51.0, 1.0}},
          KernelFactor{GroupCorrelation{Group::all, 1.01}},
          KernelFactor{GroupCorrelation{Group::all, -0.1}}})
        CHECK_THROWS_AS(correlation_matrix(Kernel{{f}}, sites), std::invalid_argument);
    CHECK_THROWS_AS(correlation_matrix(Kernel{}, sites), std::invalid_argument);
    CHECK_THROWS_AS(correlation_matrix(scenes::one_for_all(), {}), std::invalid_argument);
    const std::vector<Site> astray{{0.0, 0.0}, {nan, 0.0}};
    CHECK_THROWS_AS(correlation_matrix(Kernel{{Exponential{1.0}}}, astray),
                    std::invalid_argument);
}
