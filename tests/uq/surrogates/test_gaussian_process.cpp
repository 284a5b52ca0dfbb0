#include "tests/uq/latin_scene.hpp"
#include "uq/surrogates/gaussian_process.hpp"
#include "uq/surrogates/process_fit.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <stdexcept>

using namespace uq;

namespace {

/// sin(2 pi x) at five points: sd 1, length 0.3, noise variance 1e-4.
GaussianProcess sine(ProcessKernel kernel)
{
    Eigen::MatrixXd x(5, 1);
    x << 0.0, 0.25, 0.5, 0.75, 1.0;
    const Eigen::VectorXd y = (2.0 * M_PI * x.col(0).array()).sin();
    return condition({x, y}, kernel, ProcessTrend::none,
                     {1.0, Eigen::VectorXd::Constant(1, 0.3), 1e-4});
}

struct SineValues {
    ProcessKernel kernel;
    double mean[2], variance[2], likelihood, residual[2];
};

/// Smooth, with one interaction.
Eigen::VectorXd smooth(const Eigen::MatrixXd& x)
{
    return (3.0 * x.col(0).array()).sin() +
           x.col(1).array().square() * (1.0 + x.col(2).array());
}

ProcessData smooth_data(int n)
{
    const Eigen::MatrixXd x = scenes::latin_hypercube(n, 3, 3);
    return {x, smooth(x)};
}

double q2(const Eigen::VectorXd& truth, const Eigen::VectorXd& said)
{
    return 1.0 - (truth - said).squaredNorm() / (truth.array() - truth.mean()).square().sum();
}

} // namespace

TEST_CASE("gaussian process: five points of a sine", "[uq][gaussian_process]")
{
    // independent values, nine digits
    const SineValues v = GENERATE(SineValues{ProcessKernel::squared_exponential,
                                             {.532377620, -.621842788},
                                             {.004182937, .001637874},
                                             -5.844273967,
                                             {-.6632888, .3709847}},
                                  SineValues{ProcessKernel::matern_52,
                                             {.472456747, -.601704087},
                                             {.045967404, .038523250},
                                             -5.681261361,
                                             {-.7009584, .7377050}},
                                  SineValues{ProcessKernel::matern_32,
                                             {.446830024, -.550125968},
                                             {.099564044, .093734329},
                                             -5.657211835,
                                             {-.6418670, .8448314}});
    const GaussianProcess p = sine(v.kernel);
    Eigen::MatrixXd at(2, 1);
    at << 0.1, 0.6;
    const ProcessPrediction said = predict(p, at);
    for (int i = 0; i < 2; ++i) {
        CHECK(said.mean(i) == Approx(v.mean[i]).epsilon(0).margin(1e-9));
        CHECK(said.variance(i) == Approx(v.variance[i]).epsilon(0).margin(1e-9));
    }
    CHECK(p.log_likelihood == Approx(v.likelihood).epsilon(0).margin(1e-9));
    const Eigen::VectorXd out = leave_one_out(p).residual;
    CHECK(out(0) == Approx(v.residual[0]).epsilon(0).margin(1e-7));
    CHECK(out(1) == Approx(v.residual[1]).epsilon(0).margin(1e-7));
    CHECK(std::abs(out(2)) < 1e-12);
    CHECK(out(3) == Approx(-out(1)).epsilon(1e-10));
    CHECK(out(4) == Approx(-out(0)).epsilon(1e-10));
}

TEST_CASE("gaussian process: leave-one-out in closed form is what each point says when it is "
          "left out",
          "[uq][gaussian_process]")
{
    const auto kernel = GENERATE(ProcessKernel::matern_32, ProcessKernel::matern_52,
                                 ProcessKernel::squared_exponential);
    const auto trend =
        GENERATE(ProcessTrend::none, ProcessTrend::constant, ProcessTrend::linear);
    ProcessData data = smooth_data(14);
    data.noise = Eigen::VectorXd::LinSpaced(14, 0.0, 0.02);
    const ProcessParameters parameters{0.7, Eigen::Vector3d(0.4, 0.6, 0.9), 1e-3};
    const ProcessLeaveOneOut all = leave_one_out(condition(data, kernel, trend, parameters));
    for (Eigen::Index i = 0; i < 14; ++i) {
        std::vector<Eigen::Index> others;
        for (Eigen::Index j = 0; j < 14; ++j)
            if (j != i) others.push_back(j);
        const ProcessData rest{data.x(others, Eigen::all), data.y(others), data.noise(others)};
        const ProcessPrediction said =
            predict(condition(rest, kernel, trend, parameters), data.x.row(i));
        CHECK(all.residual(i) == Approx(data.y(i) - said.mean(0)).epsilon(1e-9).margin(1e-11));
        CHECK(all.variance(i) ==
              Approx(said.variance(0) + parameters.noise + data.noise(i)).epsilon(1e-9));
    }
}

TEST_CASE("gaussian process: a linear trend alone is generalised least squares",
          "[uq][gaussian_process]")
{
    // lengths far below the spacing: independent errors, whose variance is 1 + noise_i
    ProcessData data = smooth_data(20);
    data.noise = Eigen::VectorXd::LinSpaced(20, 0.0, 3.0);
    const GaussianProcess p = condition(data, ProcessKernel::matern_52, ProcessTrend::linear,
                                        {1.0, Eigen::VectorXd::Constant(3, 1e-4), 0.0});
    const Eigen::VectorXd root = (1.0 + data.noise.array()).sqrt().inverse();
    const Eigen::MatrixXd f = root.asDiagonal() * trend_rows(ProcessTrend::linear, data.x);
    const Eigen::VectorXd b = f.colPivHouseholderQr().solve(root.cwiseProduct(data.y).eval());
    CHECK((p.trend_weights - b).norm() < 1e-12 * b.norm());
    Eigen::RowVector4d at(1.0, 0.2, 0.5, 0.7);
    const double doubt = 1.0 + (at * (f.transpose() * f).inverse()).dot(at);
    CHECK(predict(p, at.tail(3)).variance(0) == Approx(doubt).epsilon(1e-12));
}

TEST_CASE("gaussian process: the likelihood has its top at the fitted parameters",
          "[uq][process_fit]")
{
    const auto kernel = GENERATE(ProcessKernel::matern_32, ProcessKernel::matern_52);
    ProcessData data = smooth_data(60);
    Stream scatter(5, 0, Purpose::monte_carlo);
    for (double& y : data.y) y += 0.1 * scatter.normal();
    const GaussianProcess p = fit_process(data, {kernel});
    CHECK(std::sqrt(p.parameters.noise) == Approx(0.1).epsilon(0.25));
    const auto likelihood = [&](const ProcessParameters& q) {
        return condition(data, kernel, ProcessTrend::constant, q).log_likelihood;
    };
    for (const double factor : {0.8, 1.25}) {
        ProcessParameters q = p.parameters;
        q.variance *= factor;
        CHECK(likelihood(q) < p.log_likelihood);
        q = p.parameters;
        q.noise *= factor;
        CHECK(likelihood(q) < p.log_likelihood);
        for (Eigen::Index k = 0; k < 3; ++k) {
            q = p.parameters;
            q.lengths(k) *= factor;
            CHECK(likelihood(q) < p.log_likelihood);
        }
    }
}

TEST_CASE("gaussian process: a fit predicts points that it has not seen, with its doubt",
          "[uq][process_fit]")
{
    const GaussianProcess p = fit_process(smooth_data(60));
    const Eigen::MatrixXd x = scenes::monte_carlo(400, 3, 11);
    const ProcessPrediction said = predict(p, x);
    CHECK(q2(smooth(x), said.mean) > 0.999);
    const Eigen::ArrayXd z = (smooth(x) - said.mean).array() / said.variance.array().sqrt();
    CHECK((z.abs() < 1.96).count() > 320); // 80 %: the doubt of the parameters is not in it
    CHECK(predict_mean(p, x.bottomRows(1))(0) == said.mean(399));
}

TEST_CASE("gaussian process: scaling inputs and response scales the answer and nothing else",
          "[uq][process_fit]")
{
    const ProcessData data = smooth_data(30);
    const Eigen::Vector3d by(1e9, 1e-6, 5.0);
    const GaussianProcess a = fit_process(data);
    const GaussianProcess b =
        fit_process({data.x * by.asDiagonal(), 1e3 * data.y.array() + 7e3});
    CHECK((b.parameters.lengths.cwiseQuotient(a.parameters.lengths) - by)
              .cwiseQuotient(by)
              .norm() < 1e-3);
    const Eigen::MatrixXd x = scenes::monte_carlo(5, 3, 12);
    const Eigen::VectorXd u = predict_mean(a, x), v = predict_mean(b, x * by.asDiagonal());
    CHECK((v - (1e3 * u.array() + 7e3).matrix()).norm() < 1e-3 * v.norm());
}

TEST_CASE("gaussian process: bad input is refused", "[uq][gaussian_process]")
{
    const ProcessData good = smooth_data(5);
    const ProcessParameters p{1.0, Eigen::Vector3d::Ones(), 0.0};
    const auto refused = [](const ProcessData& d, const ProcessParameters& q,
                            ProcessTrend trend = ProcessTrend::constant) {
        CHECK_THROWS_AS(condition(d, ProcessKernel::matern_52, trend, q),
                        std::invalid_argument);
    };
    ProcessData d = good;
    d.y(2) = std::nan("");
    refused(d, p);
    CHECK_THROWS_AS(fit_process(d), std::invalid_argument);
    d = good;
    d.y.setConstant(3.0);
    CHECK_THROWS_WITH(fit_process(d), Catch::Contains("does not vary"));
    d = good;
    d.x.row(1) = d.x.row(0); // twice the same point, without noise
    refused(d, p);
    CHECK_NOTHROW(fit_process(d));
    refused({good.x, good.y.head(4)}, p);
    refused(good, {0.0, Eigen::Vector3d::Ones(), 0.0});
    refused(good, {1.0, Eigen::Vector2d::Ones(), 0.0});
    refused(good, {1.0, Eigen::Vector3d::Ones(), -1.0});
    refused({good.x.topRows(3), good.y.head(3)}, p, ProcessTrend::linear);
    CHECK_THROWS_AS(predict(condition(good, ProcessKernel::matern_52, ProcessTrend::none, p),
                            Eigen::MatrixXd::Zero(1, 2)),
                    std::invalid_argument);
}
