#include "core/eigen_pairs.hpp"

#include <catch2/catch.hpp>

using namespace core;

TEST_CASE("eigen pairs: a matrix of two rows has those of the formula", "[core][eigen_pairs]")
{
    Eigen::MatrixXd k(2, 2);
    k << 2.0, 1.0, 1.0, 2.0;
    const EigenPairs e = eigen_pairs(k);
    CHECK(e.values[0] == Approx(1.0).epsilon(1e-15));
    CHECK(e.values[1] == Approx(3.0).epsilon(1e-15));
    CHECK((e.vectors.transpose() * e.vectors - Eigen::MatrixXd::Identity(2, 2)).norm() < 1e-15);
    CHECK((k * e.vectors - e.vectors * e.values.asDiagonal()).norm() < 1e-15);
}

TEST_CASE("eigen pairs: of two matrices the vectors are orthonormal in the second",
          "[core][eigen_pairs]")
{
    Eigen::MatrixXd k(2, 2), c(2, 2);
    k << 2.0, 1.0, 1.0, 2.0;
    c << 4.0, 1.0, 1.0, 1.0;
    const EigenPairs e = eigen_pairs(k, c);
    CHECK((e.vectors.transpose() * c * e.vectors - Eigen::MatrixXd::Identity(2, 2)).norm() <
          1e-14);
    CHECK((k * e.vectors - c * e.vectors * e.values.asDiagonal()).norm() < 1e-14);
    CHECK(e.values[0] < e.values[1]);
}
