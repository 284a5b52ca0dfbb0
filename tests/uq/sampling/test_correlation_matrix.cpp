#include "uq/designs/correlation_matrix.hpp"

#include <catch2/catch.hpp>

#include <Eigen/Eigenvalues>

#include <cmath>
#include <stdexcept>

using namespace uq;

TEST_CASE("correlation_matrix: the nearest to Higham's examples", "[uq][correlation_matrix]")
{
    Eigen::MatrixXd a(3, 3), b(4, 4), nearest_a(3, 3);
    a << 1, 1, 0, 1, 1, 1, 0, 1, 1;
    nearest_a << 1, 0.7607, 0.1573, 0.7607, 1, 0.7607, 0.1573, 0.7607, 1; // Higham 2002
    CHECK((nearest_correlation(a, 0.0) - nearest_a).cwiseAbs().maxCoeff() < 0.5e-4);
    b << 2, -1, 0, 0, -1, 2, -1, 0, 0, -1, 2, -1, 0, 0, -1, 2;
    Eigen::MatrixXd nearest_b(4, 4); // Higham 2002
    nearest_b << 1, -0.8084, 0.1916, 0.1068, -0.8084, 1, -0.6562, 0.1916, 0.1916, -0.6562, 1,
        -0.8084, 0.1068, 0.1916, -0.8084, 1;
    CHECK((nearest_correlation(b, 0.0) - nearest_b).cwiseAbs().maxCoeff() < 0.5e-4);
}

TEST_CASE(
    "correlation_matrix: the nearest to a correlation is itself, to others one that passes",
    "[uq][correlation_matrix]")
{
    Eigen::MatrixXd r(3, 3), bad(3, 3);
    r << 1, 0.5, 0.2, 0.5, 1, -0.3, 0.2, -0.3, 1;
    CHECK((nearest_correlation(r) - r).cwiseAbs().maxCoeff() < 1e-14);
    CHECK_NOTHROW(check_correlation(r, 3, "pearson"));
    bad << 1, 0.9, -0.9, 0.9, 1, 0.9, -0.9, 0.9, 1;
    const Eigen::MatrixXd n = nearest_correlation(bad);
    CHECK_NOTHROW(check_correlation(n, 3, "pearson"));
    CHECK(Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(n).eigenvalues()[0] ==
          Approx(1e-6).epsilon(1e-3));
}

TEST_CASE("correlation_matrix: others are refused with the nearest shown",
          "[uq][correlation_matrix]")
{
    const auto refused = [](Eigen::MatrixXd r, const char* says) {
        CHECK_THROWS_WITH(check_correlation(r, 2, "pearson"), Catch::Contains(says));
        CHECK_THROWS_AS(check_correlation(r, 2, "pearson"), std::invalid_argument);
    };
    refused((Eigen::MatrixXd(2, 2) << 1, 0.5, 0.4, 1).finished(),
            "not symmetric; nearest: [1, 0.45], [0.45, 1]");
    refused((Eigen::MatrixXd(2, 2) << 1, 0.5, 0.5, 0.9).finished(), "not 1 on its diagonal");
    refused((Eigen::MatrixXd(2, 2) << 1, 1.5, 1.5, 1).finished(),
            "outside [-1, 1]; nearest: [1, 0.9999], [0.9999, 1]");
    refused((Eigen::MatrixXd(2, 2) << 1, 1, 1, 1).finished(), "not positive definite");
    refused((Eigen::MatrixXd(2, 2) << 1, std::nan(""), 0.5, 1).finished(), "not a finite");
    refused(Eigen::MatrixXd::Identity(3, 3), "3 x 3; allowed: 2 x 2");
    Eigen::MatrixXd large = Eigen::MatrixXd::Identity(12, 12);
    large(3, 1) = large(1, 3) = 1.2;
    CHECK_THROWS_WITH(check_correlation(large, 12, "pearson"),
                      Catch::Contains("(4, 2) from 1.2 to 0.9999"));
}
