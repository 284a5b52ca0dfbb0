#include "uq/designs/design_criteria.hpp"

#include <catch2/catch.hpp>

#include <cmath>

using namespace uq;

TEST_CASE("design_criteria: discrepancy, distance and phi of four points in the plane",
          "[uq][design_criteria]")
{
    Eigen::MatrixXd u(4, 2);
    u << .125, .625, .375, .125, .625, .875, .875, .375;
    CHECK(centred_discrepancy(u) == Approx(0.127524422361409).epsilon(1e-13).margin(0.0));
    CHECK(minimum_distance(u) == Approx(std::sqrt(5.0) / 4.0).epsilon(1e-15).margin(0.0));
    CHECK(phi_p(u, 50.0) == Approx(1.8391459245564282).epsilon(1e-14).margin(0.0));
}

TEST_CASE("design_criteria: rows that coincide are as bad as can be, one row as good",
          "[uq][design_criteria]")
{
    CHECK(minimum_distance(Eigen::MatrixXd::Constant(3, 2, 0.5)) == 0.0);
    CHECK(std::isinf(phi_p(Eigen::MatrixXd::Constant(3, 2, 0.5), 50.0)));
    CHECK(phi_p(Eigen::MatrixXd::Constant(1, 2, 0.5), 50.0) == 0.0);
    CHECK(centred_discrepancy(Eigen::MatrixXd::Constant(1, 1, 0.5)) ==
          Approx(std::sqrt(1.0 / 12.0)).epsilon(1e-14));
}
