#include "uq/estimates/latin_error.hpp"

#include "core/moments.hpp"
#include "core/normal.hpp"
#include "uq/estimates/estimate.hpp"

#include "tests/uq/latin_scene.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <functional>
#include <limits>
#include <stdexcept>
#include <vector>

namespace {

/// A response of normal variables, and whether it counts.
struct Answer {
    double y;
    bool member = true;
};
using BlackBox = std::function<Answer(const Eigen::VectorXd&)>;

/// Over many hypercubes: mean of the stated error of independent samples, and of the hypercube,
/// over the true one, which is the scatter of the means.
struct Ratios {
    double independent, hypercube;
};

Ratios stated_over_true(const BlackBox& box, int n, int seeds, int inputs = 5)
{
    std::vector<double> means;
    double independent = 0.0, hypercube = 0.0;
    for (int seed = 1; seed <= seeds; ++seed) {
        Eigen::MatrixXd x =
            scenes::latin_hypercube(n, inputs, static_cast<std::uint64_t>(seed));
        x = x.unaryExpr([](double u) { return core::normal_quantile(u); });
        std::vector<double> y, counted;
        std::vector<bool> member;
        for (int i = 0; i < n; ++i) {
            const Answer a = box(x.row(i).transpose());
            y.push_back(a.y);
            member.push_back(a.member);
            if (a.member) counted.push_back(a.y);
        }
        const uq::Estimate e = uq::estimate_mean(counted);
        means.push_back(e.value);
        independent += e.std_error * e.std_error / seeds;
        hypercube += std::pow(uq::latin_subset_error(y, member, x), 2) / seeds;
    }
    const double truth = core::moments(means).sd;
    return {std::sqrt(independent) / truth, std::sqrt(hypercube) / truth};
}

/// A part that no input explains, the same for the same inputs.
double rough(const Eigen::VectorXd& x)
{
    const double s = 1e4 * std::sin(12.9898 * x[0] + 78.233 * x[1] + 37.719 * x[2]);
    return s - std::floor(s) - 0.5;
}

} // namespace

TEST_CASE("latin error: stated over true error is one where that of independent walls is not",
          "[uq][latin_error]")
{
    // like a peak force: additive, a little curved, a little rough. That of independent samples
    // is several times too large
    const auto peak = [](const Eigen::VectorXd& x) {
        return Answer{50.0 + 4.0 * x[0] + x[1] + 0.5 * x[0] * x[0] + 0.8 * x[0] * x[1] +
                      rough(x)};
    };
    // like a share: a step along a slope
    const auto share = [](const Eigen::VectorXd& x) {
        return Answer{x[0] - 0.5 * x[1] + 0.3 * x[2] > 0.4 ? 1.0 : 0.0};
    };
    // like a drop: mostly rough, of some of the walls only
    const auto drop = [](const Eigen::VectorXd& x) {
        return Answer{15.0 + 0.5 * x[0] + 20.0 * rough(x), x[1] + x[2] > -0.6};
    };
    const Ratios p = stated_over_true(peak, 50, 400), s = stated_over_true(share, 50, 400),
                 d = stated_over_true(drop, 50, 400);
    for (const Ratios& r : {p, s, d}) {
        CHECK(r.hypercube > 0.8);
        CHECK(r.hypercube < 1.25);
    }
    CHECK(p.independent > 3.0);
    CHECK(s.independent > 1.4);
    CHECK(d.independent == Approx(1.0).margin(0.15));
}

TEST_CASE("latin error: few walls whose residual is largest at the ends of the inputs",
          "[uq][latin_error]")
{
    // the fit follows samples at the ends most: where those miss most, its plain residual is
    // too small (0.80 and 0.78 of the true error)
    const auto product = [](const Eigen::VectorXd& x) {
        return Answer{0.3 * x[0] + x[0] * x[1]};
    };
    const auto growing = [](const Eigen::VectorXd& x) {
        return Answer{std::exp(0.4 * (x[0] + x[1]))};
    };
    for (const BlackBox& box : {BlackBox(product), BlackBox(growing)}) {
        const double ratio = stated_over_true(box, 20, 2000, 2).hypercube;
        CHECK(ratio > 0.88);
        CHECK(ratio < 1.15);
    }
}

TEST_CASE("latin error: a jump along one input alone has an error that is stated too large",
          "[uq][latin_error]")
{
    // no smooth function has it, and the hypercube removes nearly all of it: an upper bound
    const auto jump = [](const Eigen::VectorXd& x) { return Answer{x[0] > 0.2 ? 1.0 : 0.0}; };
    const Ratios r = stated_over_true(jump, 50, 200);
    CHECK(r.hypercube > 2.0);
    CHECK(r.hypercube < 0.6 * r.independent);
}

TEST_CASE("latin error: without enough samples for a regression it is that of independent ones",
          "[uq][latin_error]")
{
    const std::vector<double> y = {1.0, 4.0, 2.0, 8.0, 5.0};
    const Eigen::MatrixXd x = scenes::latin_hypercube(5, 5, 1);
    CHECK(uq::latin_mean_error(y, x) == Approx(uq::estimate_mean(y).std_error).epsilon(1e-12));
    CHECK(uq::latin_mean_error(y, Eigen::MatrixXd(5, 0)) ==
          Approx(uq::estimate_mean(y).std_error).epsilon(1e-12));
}

TEST_CASE("latin error: inputs count by their ranks", "[uq][latin_error]")
{
    const Eigen::MatrixXd x = scenes::latin_hypercube(40, 2, 1);
    std::vector<double> y;
    for (int i = 0; i < 40; ++i) y.push_back(x(i, 0) + x(i, 0) * x(i, 1));
    const double error = uq::latin_mean_error(y, x);
    const Eigen::MatrixXd other = x.unaryExpr([](double u) { return std::exp(7.0 * u); });
    CHECK(uq::latin_mean_error(y, other) == Approx(error).epsilon(1e-12));
    for (double& v : y) v = 3.0 * v - 2.0;
    CHECK(uq::latin_mean_error(y, x) == Approx(3.0 * error).epsilon(1e-9));
}

TEST_CASE("latin error: a subset that holds all samples is the whole", "[uq][latin_error]")
{
    const Eigen::MatrixXd x = scenes::latin_hypercube(50, 5, 3);
    std::vector<double> y;
    for (int i = 0; i < 50; ++i) y.push_back(x(i, 0) * x(i, 1) + 2.0 * x(i, 2));
    CHECK(uq::latin_subset_error(y, std::vector<bool>(50, true), x) ==
          Approx(uq::latin_mean_error(y, x)).epsilon(1e-10));
}

TEST_CASE("latin error: wrong sizes and values that are no numbers are refused",
          "[uq][latin_error]")
{
    const Eigen::MatrixXd x = scenes::latin_hypercube(4, 2, 1);
    const std::vector<double> y = {1.0, 2.0, 3.0, 4.0};
    const double nan = std::numeric_limits<double>::quiet_NaN();
    CHECK_THROWS_AS(uq::latin_mean_error(std::vector{1.0}, x.topRows(1)),
                    std::invalid_argument);
    CHECK_THROWS_AS(uq::latin_mean_error(y, x.topRows(3)), std::invalid_argument);
    CHECK_THROWS_AS(uq::latin_mean_error(std::vector{1.0, 2.0, 3.0, nan}, x),
                    std::invalid_argument);
    CHECK_THROWS_AS(uq::latin_subset_error(y, {true, false, false, false}, x),
                    std::invalid_argument);
    CHECK_THROWS_AS(uq::latin_subset_error(y, {true, true}, x), std::invalid_argument);
}
