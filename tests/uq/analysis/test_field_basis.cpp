#include "uq/fields/field_basis.hpp"

#include "tests/uq/field_scenes.hpp"
#include "uq/fields/kernel.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <stdexcept>

using namespace uq;

namespace {

double largest_error(const FieldBasis& b, const Eigen::MatrixXd& r)
{
    return (b.map * b.map.transpose() - r).cwiseAbs().maxCoeff();
}

} // namespace

TEST_CASE("field basis: Cholesky gives the correlation matrix back without a nugget",
          "[uq][field_basis]")
{
    const Kernel kernel =
        GENERATE(Kernel{{Exponential{1.0}}}, Kernel{{ExponentialL1{0.4, 0.9}}},
                 Kernel{{Matern{1.5, 0.4}}}, Kernel{{GroupCorrelation{Group::unit, 0.7}}});
    const Eigen::MatrixXd r = correlation_matrix(kernel, scenes::wall_grid());
    const FieldBasis basis = cholesky_basis(r);
    CHECK(basis.nugget == 0.0);
    CHECK(largest_error(basis, r) < 1e-14);
    CHECK(basis.map.isLowerTriangular(0.0));
}

TEST_CASE(
    "field basis: the squared exponential is singular to working precision; its nugget is "
    "small, reported, and all the error there is",
    "[uq][field_basis]")
{
    const Eigen::MatrixXd r =
        correlation_matrix(Kernel{{SquaredExponential{1.0}}}, scenes::wall_grid());
    const FieldBasis basis = cholesky_basis(r);
    CHECK(basis.nugget > 0.0);
    CHECK(basis.nugget <= 1e-12); // what OpenTURNS adds
    CHECK(largest_error(basis, r) < 1.01 * basis.nugget + 1e-14);
    CHECK((basis.map.rowwise().squaredNorm().array() - 1.0).abs().maxCoeff() < 1e-14);
}

TEST_CASE("field basis: sites of correlation 1 share one row and one coordinate",
          "[uq][field_basis]")
{
    const auto sites = scenes::grid(6, 4, 0.2, 0.1);
    const Eigen::MatrixXd units =
        correlation_matrix(Kernel{{GroupCorrelation{Group::unit, 1.0}}}, sites);
    const FieldBasis basis = cholesky_basis(units);
    CHECK(basis.map.cols() == 12);
    CHECK(basis.nugget == 0.0);
    CHECK(basis.map * basis.map.transpose() == units);
    CHECK(cholesky_basis(correlation_matrix(scenes::one_for_all(), sites)).map ==
          Eigen::MatrixXd::Ones(24, 1));
    CHECK(cholesky_basis(correlation_matrix(scenes::independent_sites(), sites)).map ==
          Eigen::MatrixXd::Identity(24, 24));
}

TEST_CASE("field basis: what is no correlation matrix is refused", "[uq][field_basis]")
{
    Eigen::MatrixXd r = Eigen::MatrixXd::Identity(3, 3);
    CHECK_THROWS_AS(cholesky_basis(Eigen::MatrixXd(2, 3)), std::invalid_argument);
    CHECK_THROWS_AS(cholesky_basis(Eigen::MatrixXd(0, 0)), std::invalid_argument);
    r(0, 1) = 0.5; // not symmetric
    CHECK_THROWS_AS(cholesky_basis(r), std::invalid_argument);
    r(1, 0) = 0.5;
    CHECK_NOTHROW(cholesky_basis(r));
    r(2, 2) = 2.0;
    CHECK_THROWS_AS(cholesky_basis(r), std::invalid_argument);
    r(2, 2) = 1.0;
    r(0, 2) = r(2, 0) = std::nan("");
    CHECK_THROWS_AS(cholesky_basis(r), std::invalid_argument);
    r(0, 2) = r(2, 0) = 0.9; // eigenvalue -0.06
    r(1, 2) = r(2, 1) = -0.9;
    CHECK_THROWS_AS(cholesky_basis(r), std::invalid_argument);
}
