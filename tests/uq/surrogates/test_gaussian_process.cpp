#include "tests/uq/latin_scene.hpp"
#include "uq/surrogates/gaussian_process.hpp"
#include "uq/surrogates/process_fit.hpp"

#include "core/normal.hpp"

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

TEST_CASE("gaussian process: many predictions are those of each point alone, bit by bit",
          "[uq][gaussian_process]")
{
    const auto trend =
        GENERATE(ProcessTrend::none, ProcessTrend::constant, ProcessTrend::linear);
    const ProcessParameters parameters{0.7, Eigen::Vector3d(0.4, 0.6, 0.9), 1e-3};
    const GaussianProcess p =
        condition(smooth_data(37), ProcessKernel::matern_52, trend, parameters);
    const Eigen::MatrixXd x = scenes::latin_hypercube(301, 3, 8);
    const ProcessPrediction all = predict(p, x);
    const Eigen::VectorXd diagonal = predict_covariance(p, x).diagonal();
    for (Eigen::Index i = 0; i < x.rows(); ++i) {
        const ProcessPrediction one = predict(p, x.row(i));
        CHECK(all.mean(i) == one.mean(0));
        CHECK(all.variance(i) == one.variance(0));
        CHECK(all.variance(i) == Approx(diagonal(i)).epsilon(1e-9).margin(1e-12));
    }
    CHECK((all.mean - predict_mean(p, x)).norm() == 0.0);
}

namespace {

/// Noise whose standard deviation doubles across the input.
struct DoublingNoise {
    static double sd(double x) { return 0.1 * std::exp2(x); }
    static double mean(double x) { return std::sin(6.0 * x); }
};

ProcessData doubling_data(int n, std::uint64_t seed)
{
    const Eigen::MatrixXd x = scenes::latin_hypercube(n, 1, seed);
    Stream scatter(seed, 0, Purpose::monte_carlo);
    Eigen::VectorXd y(n);
    for (Eigen::Index i = 0; i < n; ++i)
        y(i) = DoublingNoise::mean(x(i, 0)) + DoublingNoise::sd(x(i, 0)) * scatter.normal();
    return {x, y};
}

/// Share of further responses in the 90 % interval, in the lower and the upper part of the
/// input: by the law of the noise.
Eigen::Vector2d held(const GaussianProcess& p)
{
    const Eigen::MatrixXd x = Eigen::VectorXd::LinSpaced(200, 0.0025, 0.9975);
    const ProcessPrediction said = predict(p, x);
    const Eigen::VectorXd noise = noise_at(p.parameters, x);
    Eigen::Vector2d share = Eigen::Vector2d::Zero();
    const auto below = [](double z) { return 0.5 * std::erfc(-z / std::sqrt(2.0)); };
    for (Eigen::Index i = 0; i < 200; ++i) {
        const double half = 1.6448536269514722 * std::sqrt(said.variance(i) + noise(i));
        const double off = said.mean(i) - DoublingNoise::mean(x(i, 0)),
                     sd = DoublingNoise::sd(x(i, 0));
        share(i < 100 ? 0 : 1) += 0.01 * (below((off + half) / sd) - below((off - half) / sd));
    }
    return share;
}

} // namespace

TEST_CASE("process fit: noise that grows gives intervals that hold in both halves of the input",
          "[uq][process_fit][repeats]")
{
    Eigen::Vector2d varies = Eigen::Vector2d::Zero(), same = varies;
    constexpr int kRuns = 20;
    for (int run = 1; run <= kRuns; ++run) {
        const ProcessData data = doubling_data(150, static_cast<std::uint64_t>(run));
        varies += held(fit_process(data, {.noise_varies = true})) / kRuns;
        same += held(fit_process(data)) / kRuns;
    }
    for (Eigen::Index half = 0; half < 2; ++half) {
        CHECK(varies(half) > 0.86);
        CHECK(varies(half) < 0.94);
    }
    CHECK(same(0) > 0.94);
    CHECK(same(1) < 0.86);
}

TEST_CASE("process fit: slopes of the noise stand at the top of the likelihood, in any unit",
          "[uq][process_fit]")
{
    ProcessData data = doubling_data(100, 3);
    data.x = (1000.0 + 50.0 * data.x.array()).matrix();
    const GaussianProcess p = fit_process(data, {.noise_varies = true});
    REQUIRE(p.parameters.noise_slopes.size() == 1);
    CHECK(p.parameters.noise_slopes(0) > 0.0);
    for (const double move : {-0.3, 0.3}) {
        ProcessParameters q = p.parameters;
        q.noise_slopes(0) += move / 50.0;
        q.noise *= std::exp(-move / 50.0 * 1025.0); // the same in the middle
        CHECK(condition(data, p.kernel, p.trend, q).log_likelihood < p.log_likelihood);
    }
    const GaussianProcess same = fit_process(data);
    CHECK(noise_clearly_varies(p, same));
    const ProcessLeaveOneOut out = leave_one_out(same);
    CHECK(log_scores(out)(7) ==
          Approx(-0.5 * std::log(2.0 * M_PI * out.variance(7)) -
                 0.5 * out.residual(7) * out.residual(7) / out.variance(7))
              .epsilon(1e-13));
}

TEST_CASE("process fit: noise that is the same everywhere is left so",
          "[uq][process_fit][repeats]")
{
    int alarms = 0;
    for (std::uint64_t run = 1; run <= 30; ++run) {
        ProcessData data = smooth_data(60);
        Stream scatter(run, 0, Purpose::monte_carlo);
        for (double& y : data.y) y += 0.1 * scatter.normal();
        alarms +=
            noise_clearly_varies(fit_process(data, {.noise_varies = true}), fit_process(data));
    }
    CHECK(alarms <= 2);
}

namespace {

/// Ten inputs, two of which matter, and a tenth of the variance that none explains.
ProcessData noisy_data(int n, std::uint64_t seed)
{
    Eigen::MatrixXd x = scenes::latin_hypercube(n, 10, seed);
    x = x.unaryExpr([](double u) { return core::normal_quantile(u); });
    Stream scatter(seed, 1, Purpose::monte_carlo);
    Eigen::VectorXd y = 4.0 * x.col(0) + 2.0 * x.col(1);
    for (double& v : y) v += 1.4 * scatter.normal();
    return {x, y};
}

/// Over many fits: share of further responses in the 95 % intervals, and root mean square of
/// what is missed on points left out over what is missed on further ones.
struct Promise {
    double held = 0.0, left_out = 0.0;
};

Promise kept(const GaussianProcess& p, const ProcessLeaveOneOut& out, const ProcessData& more)
{
    const ProcessPrediction said = predict(p, more.x);
    const Eigen::ArrayXd off = (more.y - said.mean).array().square(),
                         variance = (said.variance + noise_at(p.parameters, more.x)).array();
    constexpr double kSquare = 1.96 * 1.96;
    return {(off <= kSquare * inflation_of(out) * variance).cast<double>().mean(),
            std::sqrt(out.residual.array().square().mean() / off.mean())};
}

} // namespace

TEST_CASE("process fit: held out, 30 points for ten inputs promise what further points keep",
          "[uq][process_fit][repeats]")
{
    Promise refitted, closed;
    constexpr int kRuns = 40;
    for (int run = 1; run <= kRuns; ++run) {
        const GaussianProcess p = fit_process(noisy_data(30, static_cast<std::uint64_t>(run)));
        const ProcessData more = noisy_data(400, static_cast<std::uint64_t>(1000 + run));
        const auto add = [&](Promise& all, const ProcessLeaveOneOut& out) {
            const Promise one = kept(p, out, more);
            all.held += one.held / kRuns;
            all.left_out += one.left_out / kRuns;
        };
        add(refitted, held_out(p));
        add(closed, leave_one_out(p));
    }
    CHECK(refitted.held > 0.90);
    CHECK(refitted.held < 0.97);
    CHECK(refitted.left_out > 0.95);
    CHECK(refitted.left_out < 1.25);
    CHECK(closed.held < 0.85); // the parameters have seen the points
    CHECK(closed.left_out < 0.80);
}

TEST_CASE("process fit: held out, no part has a say in its own prediction", "[uq][process_fit]")
{
    const int n = GENERATE(40, 110); // all starts, and those of the fit alone
    ProcessData data = doubling_data(n, 4);
    const GaussianProcess p = fit_process(data, {.noise_varies = true});
    const ProcessLeaveOneOut before = held_out(p);
    std::vector<Eigen::Index> in;
    for (Eigen::Index i = 0; i < n; ++i)
        if (i % 10 != 3) in.push_back(i);
    ProcessFitOptions options{.noise_varies = true};
    if (n > 100) options.from = p.parameters;
    const ProcessData rest{data.x(in, Eigen::all), data.y(in)};
    const GaussianProcess without = fit_process(rest, options);
    const Eigen::MatrixXd x = data.x.row(13);
    const ProcessPrediction said = predict(without, x);
    CHECK(before.residual(13) == Approx(data.y(13) - said.mean(0)).epsilon(1e-12));
    CHECK(before.variance(13) ==
          Approx(said.variance(0) + noise_at(without.parameters, x)(0)).epsilon(1e-12));
    // from its own top the fit goes nowhere
    const GaussianProcess again =
        fit_process(data, {.noise_varies = true, .from = p.parameters});
    CHECK(again.log_likelihood == Approx(p.log_likelihood).margin(1e-3));
}

TEST_CASE("process fit: where all points but those of one part are equal, parameters stay",
          "[uq][process_fit]")
{
    ProcessData data = doubling_data(20, 5);
    data.y.setZero();
    data.y(3) = data.y(13) = 1.0; // both of part 3
    const GaussianProcess p = fit_process(data);
    const ProcessLeaveOneOut out = held_out(p);
    CHECK(out.residual(3) == Approx(1.0).margin(1e-9));
    CHECK(out.variance.minCoeff() > 0.0);
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
