#include "uq/reliability/active/doubtful_points.hpp"

#include <catch2/catch.hpp>

#include <cmath>

namespace {

/// g = 2 - u_0 known at some points of a plane.
uq::GaussianProcess plane()
{
    Eigen::MatrixXd u(5, 2);
    u << 0, 0, 1, 1, -1, 1, 1, -1, -1, -1;
    const Eigen::VectorXd g = 2.0 - u.col(0).array();
    return uq::condition({u, g, {}}, uq::ProcessKernel::matern_52, uq::ProcessTrend::constant,
                         {1.0, Eigen::Vector2d(1.5, 1.5), 1e-6});
}

} // namespace

TEST_CASE("next points: what a point is expected to take away is what is seen to go",
          "[uq][next_points]")
{
    const uq::GaussianProcess g = plane();
    const uq::WeighedPoints p = uq::weighed_points(g, 2000, 1);
    const auto doubt = [](const uq::WeighedPoints& w, const uq::GaussianProcess& at) {
        const uq::ProcessPrediction f = predict(at, w.u);
        double sum = 0.0;
        for (Eigen::Index i = 0; i < w.u.rows(); ++i) {
            const double passing =
                0.5 *
                std::erfc(f.mean(i) / std::sqrt(2.0 * (f.variance(i) + at.parameters.noise)));
            sum += w.weight(i) * passing * (1.0 - passing);
        }
        return sum;
    };
    const uq::NextPoints next = next_points(g, p, 1, 1);
    const uq::ProcessPrediction f = predict(g, next.u);
    // the mean over what the process thinks that the answer may be
    double left = 0.0, weights = 0.0;
    for (int k = -8; k <= 8; ++k) {
        const double z = 0.5 * k, weight = std::exp(-0.5 * z * z);
        uq::ProcessData more = g.data;
        more.x.conservativeResize(6, Eigen::NoChange);
        more.x.row(5) = next.u.row(0);
        more.y.conservativeResize(6);
        more.y(5) = f.mean(0) + z * std::sqrt(f.variance(0) + g.parameters.noise);
        // a trend that is kept: its doubt is in the variance of both
        left += weight * doubt(p, condition(more, g.kernel, g.trend, g.parameters));
        weights += weight;
    }
    CHECK(1.0 - left / weights / doubt(p, g) == Approx(next.gain).epsilon(0.1));
    CHECK(next.gain > 0.1);
}

TEST_CASE("next points: a batch has no two points at one place", "[uq][next_points]")
{
    const uq::GaussianProcess g = plane();
    const uq::NextPoints next = next_points(g, uq::weighed_points(g, 2000, 1), 8, 1);
    for (Eigen::Index i = 0; i < 8; ++i)
        for (Eigen::Index j = 0; j < i; ++j)
            CHECK((next.u.row(i) - next.u.row(j)).norm() > 0.2);
}
