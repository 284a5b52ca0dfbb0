#include "uq/surrogates/gaussian_process.hpp"

#include "core/matrix_factors.hpp"
#include "core/row_products.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>

namespace uq {

namespace {

void check_process(const ProcessData& d, ProcessTrend trend, const ProcessParameters& p)
{
    const auto refuse = [](bool wrong, const char* why) {
        if (wrong) throw std::invalid_argument(why);
    };
    const Eigen::Index n = d.x.rows();
    refuse(n < 1 || d.y.size() != n || (d.noise.size() != 0 && d.noise.size() != n),
           "process: x, y and noise must have the same number of rows, at least one");
    refuse(!d.x.allFinite() || !d.y.allFinite(), "process: x and y must be finite");
    refuse(d.noise.size() != 0 && !(d.noise.allFinite() && d.noise.minCoeff() >= 0.0),
           "process: noise of a point must be >= 0");
    refuse(!(p.variance > 0.0 && std::isfinite(p.variance)), "process: variance must be > 0");
    refuse(!(p.noise >= 0.0 && std::isfinite(p.noise)), "process: noise must be >= 0");
    refuse(p.lengths.size() != d.x.cols(), "process: one length for each input");
    refuse(p.noise_slopes.size() != 0 && p.noise_slopes.size() != d.x.cols(),
           "process: one slope of the noise for each input, or none");
    refuse(p.noise_slopes.size() != 0 && !p.noise_slopes.allFinite(),
           "process: slopes of the noise must be finite");
    refuse(p.lengths.size() > 0 && !(p.lengths.allFinite() && p.lengths.minCoeff() > 0.0),
           "process: lengths must be > 0");
    refuse(n < trend_rows(trend, d.x.topRows(1)).cols(),
           "process: fewer points than terms of the trend");
}

Eigen::MatrixXd over_lengths(const Eigen::MatrixXd& x, const Eigen::VectorXd& lengths)
{
    return x * lengths.cwiseInverse().asDiagonal();
}

/// Covariances of `point`, over lengths, with the data.
Eigen::VectorXd covariances(const GaussianProcess& p, const Eigen::RowVectorXd& point)
{
    Eigen::VectorXd k = scaled_distances(p.scaled, point);
    for (double& v : k) v = p.parameters.variance * process_correlation(p.kernel, v);
    return k;
}

void check_columns(const GaussianProcess& p, const Eigen::MatrixXd& x)
{
    if (x.cols() != p.data.x.cols())
        throw std::invalid_argument("process: a point has another number of inputs");
}

} // namespace

Eigen::MatrixXd trend_rows(ProcessTrend trend, const Eigen::MatrixXd& x)
{
    if (trend == ProcessTrend::none) return {x.rows(), 0};
    Eigen::MatrixXd f = Eigen::MatrixXd::Ones(x.rows(), 1);
    if (trend == ProcessTrend::linear) {
        f.conservativeResize(Eigen::NoChange, 1 + x.cols());
        f.rightCols(x.cols()) = x;
    }
    return f;
}

Eigen::VectorXd noise_at(const ProcessParameters& p, const Eigen::MatrixXd& x)
{
    if (p.noise_slopes.size() == 0) return Eigen::VectorXd::Constant(x.rows(), p.noise);
    return p.noise * (x * p.noise_slopes).array().exp();
}

Eigen::MatrixXd process_covariance(const ProcessData& data, ProcessKernel kernel,
                                   const ProcessParameters& p)
{
    const Eigen::MatrixXd scaled = over_lengths(data.x, p.lengths);
    const Eigen::Index n = scaled.rows();
    const Eigen::VectorXd noise = noise_at(p, data.x);
    Eigen::MatrixXd k(n, n);
    for (Eigen::Index j = 0; j < n; ++j) {
        const Eigen::VectorXd r2 = scaled_distances(scaled, scaled.row(j));
        for (Eigen::Index i = j; i < n; ++i)
            k(i, j) = k(j, i) = p.variance * process_correlation(kernel, r2(i));
        k(j, j) += noise(j) + (data.noise.size() ? data.noise(j) : 0.0);
    }
    return k;
}

GaussianProcess condition(ProcessData data, ProcessKernel kernel, ProcessTrend trend,
                          ProcessParameters parameters)
{
    check_process(data, trend, parameters);
    GaussianProcess p{
        std::move(data), kernel, trend, std::move(parameters), {}, {}, {}, {}, {}, {}, {}, 0.0};
    p.scaled = over_lengths(p.data.x, p.parameters.lengths);
    const auto k = core::cholesky(process_covariance(p.data, kernel, p.parameters));
    p.factor = k.matrixL();
    // rounding of a pivot is near 1e-16 of the diagonal: a smaller one is nothing but rounding
    const double most = p.factor.diagonal().maxCoeff(), least = p.factor.diagonal().minCoeff();
    if (k.info() != Eigen::Success || !(least > 1e-7 * most))
        throw std::invalid_argument(
            "process: points are too close to be told apart without noise");
    const auto lower = p.factor.triangularView<Eigen::Lower>();
    p.inverse = lower.solve(Eigen::MatrixXd::Identity(p.factor.rows(), p.factor.cols()));
    const Eigen::MatrixXd f = trend_rows(trend, p.data.x);
    p.white_trend = f;
    if (f.cols() > 0) lower.solveInPlace(p.white_trend); // Eigen reads where nothing is
    const Eigen::VectorXd white_y = lower.solve(p.data.y);
    Eigen::VectorXd white = white_y;
    if (f.cols() > 0) {
        const auto a = core::cholesky(p.white_trend.transpose() * p.white_trend);
        if (a.info() != Eigen::Success)
            throw std::invalid_argument(
                "process: the points do not tell the terms of the trend apart");
        p.trend_factor = a.matrixL();
        p.trend_weights = a.solve(p.white_trend.transpose() * white_y);
        white -= p.white_trend * p.trend_weights;
    }
    p.weights = p.factor.transpose().triangularView<Eigen::Upper>().solve(white);
    p.log_likelihood =
        -0.5 * white.squaredNorm() - p.factor.diagonal().array().log().sum() -
        0.5 * static_cast<double>(p.data.y.size()) * std::log(2.0 * std::numbers::pi);
    return p;
}

namespace {

/// @param k covariances of the point with the data
double mean_at(const GaussianProcess& p, const Eigen::RowVectorXd& point,
               const Eigen::VectorXd& k)
{
    const double mean = k.dot(p.weights);
    if (p.trend_weights.size() == 0) return mean;
    return mean + trend_rows(p.trend, point).row(0).dot(p.trend_weights);
}

constexpr Eigen::Index kBlock = 128; ///< points whose covariances stay in the cache

/// Variances at points. Each is a sum in the order of the data, whatever points are beside it.
/// @param x points @param k their covariances with the data, a row for each
Eigen::VectorXd variances(const GaussianProcess& p, const Eigen::MatrixXd& x,
                          const Eigen::MatrixXd& k)
{
    const Eigen::MatrixXd white = core::times_transposed(k, p.inverse);
    Eigen::VectorXd variance = Eigen::VectorXd::Constant(x.rows(), p.parameters.variance);
    for (Eigen::Index j = 0; j < white.cols(); ++j)
        variance.array() -= white.col(j).array().square();
    if (p.trend_weights.size() > 0) {
        const Eigen::MatrixXd left =
            (trend_rows(p.trend, x) - core::times_transposed(white, p.white_trend.transpose()))
                .transpose();
        for (Eigen::Index i = 0; i < x.rows(); ++i)
            variance(i) +=
                p.trend_factor.triangularView<Eigen::Lower>().solve(left.col(i)).squaredNorm();
    }
    return variance.cwiseMax(0.0);
}

} // namespace

Eigen::VectorXd predict_mean(const GaussianProcess& p, const Eigen::MatrixXd& x)
{
    check_columns(p, x);
    const Eigen::MatrixXd scaled = over_lengths(x, p.parameters.lengths);
    Eigen::VectorXd mean(x.rows());
    for (Eigen::Index i = 0; i < x.rows(); ++i)
        mean(i) = mean_at(p, x.row(i), covariances(p, scaled.row(i)));
    return mean;
}

ProcessPrediction predict(const GaussianProcess& p, const Eigen::MatrixXd& x)
{
    check_columns(p, x);
    ProcessPrediction all{Eigen::VectorXd(x.rows()), Eigen::VectorXd(x.rows())};
    const Eigen::MatrixXd scaled = over_lengths(x, p.parameters.lengths);
    for (Eigen::Index from = 0; from < x.rows(); from += kBlock) {
        const Eigen::Index rows = std::min(kBlock, x.rows() - from);
        Eigen::MatrixXd k(rows, p.data.y.size());
        for (Eigen::Index i = 0; i < rows; ++i) {
            const Eigen::VectorXd one = covariances(p, scaled.row(from + i));
            all.mean(from + i) = mean_at(p, x.row(from + i), one);
            k.row(i) = one.transpose();
        }
        all.variance.segment(from, rows) = variances(p, x.middleRows(from, rows), k);
    }
    return all;
}

Eigen::MatrixXd predict_covariance(const GaussianProcess& p, const Eigen::MatrixXd& x)
{
    check_columns(p, x);
    const Eigen::MatrixXd scaled = over_lengths(x, p.parameters.lengths);
    const auto lower = p.factor.triangularView<Eigen::Lower>();
    Eigen::MatrixXd white(p.data.y.size(), x.rows()), all(x.rows(), x.rows());
    for (Eigen::Index j = 0; j < x.rows(); ++j) {
        white.col(j) = covariances(p, scaled.row(j));
        const Eigen::VectorXd r2 = scaled_distances(scaled, scaled.row(j));
        for (Eigen::Index i = 0; i < x.rows(); ++i)
            all(i, j) = p.parameters.variance * process_correlation(p.kernel, r2(i));
    }
    lower.solveInPlace(white);
    all -= white.transpose() * white;
    if (p.trend_weights.size() > 0) {
        Eigen::MatrixXd left =
            trend_rows(p.trend, x).transpose() - p.white_trend.transpose() * white;
        p.trend_factor.triangularView<Eigen::Lower>().solveInPlace(left);
        all += left.transpose() * left;
    }
    return all;
}

ProcessLeaveOneOut leave_one_out(const GaussianProcess& p)
{
    Eigen::VectorXd q = p.inverse.colwise().squaredNorm();
    if (p.trend_weights.size() > 0) {
        const Eigen::MatrixXd f =
            p.factor.transpose().triangularView<Eigen::Upper>().solve(p.white_trend); // K^-1 F
        q -= p.trend_factor.triangularView<Eigen::Lower>()
                 .solve(f.transpose())
                 .colwise()
                 .squaredNorm()
                 .transpose();
    }
    return {p.weights.cwiseQuotient(q), q.cwiseInverse()};
}

Eigen::VectorXd log_scores(const ProcessLeaveOneOut& out)
{
    return -0.5 * ((2.0 * std::numbers::pi * out.variance.array()).log() +
                   out.residual.array().square() / out.variance.array());
}

double inflation_of(const ProcessLeaveOneOut& out)
{
    return std::max(1.0, (out.residual.array().square() / out.variance.array()).mean());
}

} // namespace uq
