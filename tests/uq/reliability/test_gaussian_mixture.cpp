#include "uq/reliability/simulation/gaussian_mixture.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

namespace {

Eigen::MatrixXd normal_points(Eigen::Index n, Eigen::Index d, std::uint64_t seed)
{
    Eigen::MatrixXd u(n, d);
    uq::Stream random(seed, 0, uq::Purpose::monte_carlo);
    for (double& v : u.reshaped()) v = random.normal();
    return u;
}

} // namespace

TEST_CASE("gaussian mixture: four heaps get a part each", "[uq][gaussian_mixture]")
{
    Eigen::MatrixXd u = 0.2 * normal_points(800, 2, 1);
    for (Eigen::Index i = 0; i < u.rows(); ++i) {
        u(i, 0) += i % 2 ? 3.0 : -3.0;
        u(i, 1) += i % 4 < 2 ? 3.0 : -3.0;
    }
    const uq::GaussianMixture m = uq::fit_mixture(u, 1);
    for (const double x : {-3.0, 3.0})
        for (const double y : {-3.0, 3.0}) {
            const Eigen::Vector2d heap(x, y);
            double share = 0.0;
            for (const uq::MixturePart& p : m)
                if ((p.mean - heap).norm() < 0.5) share += p.share;
            CHECK(share == Approx(0.25).margin(0.01));
        }
}

TEST_CASE("gaussian mixture: its density over the normal one is that of what it draws",
          "[uq][gaussian_mixture]")
{
    Eigen::MatrixXd u = normal_points(1000, 3, 2);
    u.col(0) = 3.0 + 0.3 * u.col(0).array().abs();
    const uq::GaussianMixture m = uq::fit_mixture(u, 1);
    // the standard normal share of u_0 >= 3, from draws of the mixture
    double sum = 0.0;
    constexpr int kDraws = 20000;
    uq::Stream random(3, 0, uq::Purpose::bootstrap);
    for (int i = 0; i < kDraws; ++i) {
        const Eigen::VectorXd at = draw(m, random);
        if (at(0) >= 3.0) sum += 1.0 / relative_density(m, at);
    }
    CHECK(sum / kDraws == Approx(1.349898e-3).epsilon(0.03));
}

TEST_CASE("gaussian mixture: variances near 1 are 1, small ones four times as large",
          "[uq][gaussian_mixture]")
{
    Eigen::MatrixXd u = normal_points(1000, 2, 4);
    u.col(0) *= 0.1;
    const uq::GaussianMixture m = uq::fit_mixture(u, 1);
    REQUIRE(m.size() == 1);
    const Eigen::Matrix2d c = m[0].factor * m[0].factor.transpose();
    CHECK(c(0, 0) == Approx(0.04).epsilon(0.15));
    CHECK(c(1, 1) == Approx(1.0).epsilon(1e-4));
}
