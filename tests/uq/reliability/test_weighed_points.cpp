#include "uq/reliability/active/doubtful_points.hpp"

#include <catch2/catch.hpp>

#include <cmath>

namespace {

/// A process that knows g = beta - u_0 as a straight trend.
uq::GaussianProcess straight(double beta, Eigen::Index d)
{
    Eigen::MatrixXd u = Eigen::MatrixXd::Zero(2 * d + 1, d);
    for (Eigen::Index k = 0; k < d; ++k) u(2 * k + 1, k) = 2.0, u(2 * k + 2, k) = -2.0;
    const Eigen::VectorXd g = beta - u.col(0).array();
    return uq::condition({u, g, {}}, uq::ProcessKernel::squared_exponential,
                         uq::ProcessTrend::linear,
                         {1e-6, Eigen::VectorXd::Constant(d, 4.0), 1e-10});
}

} // namespace

TEST_CASE("weighed points: the probability by the process, down to 1e-9 and in ten dimensions",
          "[uq][weighed_points][repeats]")
{
    const double beta = GENERATE(2.0, 4.0, 6.0);
    const Eigen::Index d = GENERATE(2, 10);
    const uq::WeighedPoints p = uq::weighed_points(straight(beta, d), 10000, 1);
    const double exact = 0.5 * std::erfc(beta / std::sqrt(2.0));
    INFO(beta << " in " << d);
    CHECK(p.probability == Approx(exact).epsilon(0.08));
    CHECK(std::abs(p.probability - exact) < 4.0 * p.std_error);
    CHECK(p.std_error < 0.03 * exact);
}

TEST_CASE("weighed points: their weights make means over the normal distribution",
          "[uq][weighed_points]")
{
    const uq::WeighedPoints p = uq::weighed_points(straight(3.0, 2), 20000, 1);
    CHECK(p.weight.sum() == Approx(1.0).margin(0.1));
    CHECK(p.weight.dot(p.u.col(1).cwiseAbs2()) == Approx(1.0).margin(0.1));
}
