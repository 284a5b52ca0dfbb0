#include "uq/reliability/mean_value.hpp"

#include "uq/reliability/evaluate.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <stdexcept>

using namespace uq;
using Eigen::Matrix2d;
using Eigen::Vector2d;

namespace {

const Model ratio = by_rows(
    [](const Eigen::VectorXd& x) { return Eigen::VectorXd::Constant(1, x(0) / x(1)); }, 1);

} // namespace

TEST_CASE("mean value: the log ratio problem of the Dakota manual", "[uq][mean_value]")
{
    const MeanValue m = mean_value(ratio, 0, Vector2d(1.0, 1.0), Vector2d(0.5, 0.5),
                                   Matrix2d{{1.0, 0.3}, {0.3, 1.0}}, 1e-4);
    CHECK(m.failure.empty());
    CHECK(m.mean == 1.0);
    CHECK(m.sd == Approx(0.59160798127).epsilon(1e-8));
    CHECK(m.importance(0, 0) == Approx(0.7142857).margin(5e-8));
    CHECK(m.importance(1, 1) == Approx(0.7142857).margin(5e-8));
    CHECK(m.importance(0, 1) + m.importance(1, 0) == Approx(-0.4285714).margin(5e-8));
    CHECK(m.importance.sum() == Approx(1.0).epsilon(1e-14));
}

TEST_CASE("mean value: a failed sample is a failure, not a number", "[uq][mean_value]")
{
    const MeanValue m =
        mean_value(ratio, 0, Vector2d(1.0, 0.0), Vector2d(0.5, 0.5), Matrix2d::Identity());
    CHECK_FALSE(m.failure.empty());
    CHECK(m.sd == 0.0);
    CHECK(m.importance.isZero(0.0));
}

TEST_CASE("mean value: input out of range is refused", "[uq][mean_value]")
{
    const Vector2d one(1.0, 1.0);
    const Matrix2d c = Matrix2d::Identity();
    CHECK_THROWS_AS(mean_value(ratio, 0, one, Vector2d(1.0, 0.0), c), std::invalid_argument);
    CHECK_THROWS_AS(mean_value(ratio, 0, one, one, Eigen::MatrixXd::Identity(3, 3)),
                    std::invalid_argument);
    CHECK_THROWS_AS(mean_value(ratio, 0, one, one, c, 0.0), std::invalid_argument);
    CHECK_THROWS_AS(mean_value(ratio, -1, one, one, c), std::invalid_argument);
}
