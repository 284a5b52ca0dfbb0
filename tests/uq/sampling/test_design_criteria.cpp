#include "uq/designs/design_criteria.hpp"

#include <catch2/catch.hpp>

#include <cmath>

using namespace uq;

TEST_CASE("design criteria: the smallest distance of four points in the plane",
          "[uq][design_criteria]")
{
    Eigen::MatrixXd u(4, 2);
    u << .125, .625, .375, .125, .625, .875, .875, .375;
    CHECK(minimum_distance(u) == Approx(std::sqrt(5.0) / 4.0).epsilon(1e-15).margin(0.0));
    CHECK(minimum_distance(Eigen::MatrixXd::Constant(3, 2, 0.5)) == 0.0);
    CHECK(std::isinf(minimum_distance(Eigen::MatrixXd::Constant(1, 2, 0.5))));
}
