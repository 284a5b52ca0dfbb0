#include "uq/designs/nataf.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>
#include <stdexcept>

using namespace uq;

namespace {

double solved(const Marginal& a, const Marginal& b, double rho)
{
    return normal_correlation(hermite_coefficients(a), hermite_coefficients(b), rho);
}

auto near(double value, double tolerance)
{
    return Approx(value).epsilon(tolerance).margin(0.0);
}

Marginal lognormal(double cov) { return {lognormal_from_moments(1.0, cov)}; }

} // namespace

TEST_CASE("nataf: normal images of two lognormals, by the closed form", "[uq][nataf]")
{
    CHECK(solved(lognormal(0.3), lognormal(0.5), 0.5) == near(0.521522175943414, 1e-12));
    CHECK(solved(lognormal(0.3), lognormal(0.5), -0.5) == near(-0.562199955851082, 1e-12));
    CHECK(solved(lognormal(0.5), lognormal(0.5), 0.9) == near(0.909463180994768, 1e-12));
    // Dakota, log ratio
    CHECK(solved(lognormal(0.5), lognormal(0.5), 0.3) == near(0.324099267730085, 1e-12));
    const double v1 = GENERATE(0.05, 0.3, 1.5), v2 = GENERATE(0.2, 2.0);
    const double rho_z = GENERATE(-0.9, 0.1, 0.7, 1.0);
    const double product = std::sqrt(std::log1p(v1 * v1) * std::log1p(v2 * v2));
    CHECK(pearson_of_normals(hermite_coefficients(lognormal(v1)),
                             hermite_coefficients(lognormal(v2)),
                             rho_z) == near(std::expm1(rho_z * product) / (v1 * v2), 1e-12));
}

TEST_CASE("nataf: a lognormal whose variance lies 14 deviations out", "[uq][nataf]")
{
    const Eigen::VectorXd a = hermite_coefficients(lognormal(1000.0));
    CHECK(a.squaredNorm() == near(1.0, 1e-13));
    CHECK(pearson_of_normals(a, a, 0.1) ==
          near(std::expm1(0.1 * std::log1p(1e6)) / 1e6, 1e-12));
}

TEST_CASE("nataf: normal with lognormal, normal with normal, uniform with uniform",
          "[uq][nataf]")
{
    const Marginal n{Normal{35.0, 7.0}}, u{Uniform{2.0, 3.0}};
    CHECK(solved(n, lognormal(0.5), 0.5) == near(0.529234123387546, 1e-12));
    CHECK(solved(n, n, -0.83) == near(-0.83, 1e-13));
    CHECK(solved(u, u, 0.5) == near(2.0 * std::sin(std::numbers::pi / 12.0), 1e-12));
    CHECK(solved(u, u, -0.95) == near(-2.0 * std::sin(0.95 * std::numbers::pi / 6.0), 1e-12));
    CHECK(solved(n, u, 0.5) == near(0.5 * std::sqrt(std::numbers::pi / 3.0), 1e-12));
    CHECK(solved(n, u, 0.0) == 0.0);
}

TEST_CASE("nataf: the squares of the coefficients are the variance, cut shapes too",
          "[uq][nataf]")
{
    for (const Marginal& m :
         {Marginal{Gamma{2.5, 1.0}}, Marginal{Weibull{0.8, 3.0}}, Marginal{Gumbel{1.0, 2.0}},
          Marginal{Beta{2.0, 5.0, 0.0, 1.0}}, Marginal{Normal{35.0, 7.0}, 20.0, 50.0}}) {
        CAPTURE(m.shape.index());
        CHECK(hermite_coefficients(m).squaredNorm() == near(1.0, 1e-12));
    }
    // A kink and steps leave a rest that falls with a power of the order.
    CHECK(hermite_coefficients({Triangular{0.0, 0.2, 1.0}}).squaredNorm() == near(1.0, 1e-6));
    const Eigen::VectorXd coin = hermite_coefficients({Empirical{{0.0, 1.0}}});
    CHECK(pearson_of_normals(coin, coin, 0.5) ==
          near(2.0 / std::numbers::pi * std::asin(0.5), 1e-12));
    CHECK(pearson_of_normals(coin, coin, 0.9) ==
          near(2.0 / std::numbers::pi * std::asin(0.9), 1e-12));
    CHECK(hermite_coefficients({Constant{2.0}}).size() == 0);
}

TEST_CASE("nataf: what 1000 coefficients leave out close to rho_z = 1 is what the header says",
          "[uq][nataf]")
{
    const Eigen::VectorXd coin = hermite_coefficients({Empirical{{0.0, 1.0}}});
    const auto left_out = [&](double rho_z) {
        return 2.0 / std::numbers::pi * std::asin(rho_z) -
               pearson_of_normals(coin, coin, rho_z);
    };
    CHECK(left_out(0.99) == near(3.0e-8, 0.1));
    CHECK(left_out(0.999) == near(1.4e-3, 0.1));
    CHECK(left_out(1.0) == near(1.6e-2, 0.1));
    CHECK(hermite_coefficients({Empirical{{0.0, 1.0}}}).size() == 1000);
    for (const double mode : {0.0, 0.2, 0.5, 1.0})
        CHECK(std::abs(hermite_coefficients({Triangular{0.0, mode, 1.0}}).squaredNorm() - 1.0) <
              1e-9);
}

TEST_CASE("nataf: what marginals cannot attain is refused with what they can", "[uq][nataf]")
{
    CHECK_THROWS_WITH(solved(lognormal(1.0), lognormal(1.0), -0.6),
                      Catch::Contains("allowed: inside (-0.5, 1)"));
    CHECK_THROWS_AS(solved({Constant{1.0}}, lognormal(1.0), 0.1), std::invalid_argument);
    CHECK(solved({Constant{1.0}}, lognormal(1.0), 0.0) == 0.0);
}
