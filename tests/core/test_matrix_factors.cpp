#include "core/matrix_factors.hpp"

#include <catch2/catch.hpp>

using namespace core;
using Eigen::MatrixXd;
using Eigen::VectorXd;

TEST_CASE("matrix factors: a matrix of two rows is solved as by the formula",
          "[core][matrix_factors]")
{
    MatrixXd m(2, 2);
    m << 4.0, 7.0, 2.0, 10.0; // only the lower triangle counts
    const auto factor = cholesky(m);
    REQUIRE(factor.info() == Eigen::Success);
    const MatrixXd l = factor.matrixL();
    CHECK(l(0, 0) == 2.0);
    CHECK(l(1, 0) == 1.0);
    CHECK(l(0, 1) == 0.0);
    CHECK(l(1, 1) == 3.0);
    const MatrixXd inverse = solve(factor, MatrixXd::Identity(2, 2)); // of 4 2 2 10
    CHECK(inverse(0, 0) == Approx(10.0 / 36.0).epsilon(1e-15));
    CHECK(inverse(0, 1) == Approx(-2.0 / 36.0).epsilon(1e-15));
    CHECK(inverse(1, 1) == Approx(4.0 / 36.0).epsilon(1e-15));
    m(1, 1) = 0.5;
    CHECK(cholesky(m).info() != Eigen::Success);
}

TEST_CASE("matrix factors: a line through four points, and columns that depend on others",
          "[core][matrix_factors]")
{
    MatrixXd x(4, 2);
    x << 1.0, 0.0, 1.0, 1.0, 1.0, 2.0, 1.0, 3.0;
    const VectorXd y = (VectorXd(4) << 1.0, 4.0, 4.0, 7.0).finished();
    const LeastSquares line = least_squares(x, y);
    CHECK(line.rank == 2);
    CHECK(line.coefficients(0) == Approx(1.3).epsilon(1e-14));
    CHECK(line.coefficients(1) == Approx(1.8).epsilon(1e-14));
    MatrixXd dependent(4, 3);
    dependent << x, 2.0 * x.col(1) - x.col(0);
    CHECK(rank(x) == 2);
    CHECK(rank(dependent) == 2);
    const LeastSquares same = least_squares(dependent, y);
    CHECK(same.rank == 2);
    CHECK((dependent * same.coefficients - x * line.coefficients).norm() < 1e-13);
}
