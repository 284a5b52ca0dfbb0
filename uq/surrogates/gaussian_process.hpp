#pragma once
/// A Gaussian process conditioned on what a response was at some points (kriging).
///
///   y_i = f(x_i)' b + Z(x_i) + e_i,   Cov(Z(x), Z(x')) = variance * correlation,
///   e_i ~ N(0, noise exp(slopes' x_i) + noise_i)
///
/// The trend b is by generalised least squares, and its doubt is part of the variance of a
/// prediction (Rasmussen and Williams 2006, eq. 2.41 and 2.42, with a flat prior on b).

#include "uq/surrogates/process_kernel.hpp"

#include <Eigen/Core>

namespace uq {

enum class ProcessTrend { none, constant, linear };

struct ProcessParameters {
    double variance;         ///< of Z, square of the unit of the response, > 0
    Eigen::VectorXd lengths; ///< one for each input, in its unit, > 0
    double noise;            ///< variance of the noise of every point, >= 0
    /// One for each input, where noise is not the same everywhere: its variance is
    /// noise exp(slopes' x). Empty: none.
    Eigen::VectorXd noise_slopes{};
};

/// Variances of the noise at points, without that of a point alone.
[[nodiscard]] Eigen::VectorXd noise_at(const ProcessParameters& parameters,
                                       const Eigen::MatrixXd& x);

/// Points and what was seen there.
struct ProcessData {
    Eigen::MatrixXd x;       ///< n x d, finite
    Eigen::VectorXd y;       ///< n, finite
    Eigen::VectorXd noise{}; ///< variance of the noise of each point alone, >= 0; empty: none
};

struct GaussianProcess {
    ProcessData data;
    ProcessKernel kernel;
    ProcessTrend trend;
    ProcessParameters parameters;
    Eigen::VectorXd trend_weights; ///< b
    Eigen::VectorXd weights;       ///< K^-1 (y - F b)
    Eigen::MatrixXd scaled;        ///< x over lengths
    Eigen::MatrixXd factor;        ///< L, lower, L L' = K
    Eigen::MatrixXd inverse;       ///< L^-1, lower
    Eigen::MatrixXd white_trend;   ///< L^-1 F
    Eigen::MatrixXd trend_factor;  ///< lower factor of F' K^-1 F
    double log_likelihood;         ///< of y, b at its estimate
};

/// @throws std::invalid_argument for sizes that do not fit, values that are not finite,
/// parameters out of range, fewer
/// points than the trend has terms, or points that cannot be told apart without noise
[[nodiscard]] GaussianProcess condition(ProcessData data, ProcessKernel kernel,
                                        ProcessTrend trend, ProcessParameters parameters);

/// Rows of the trend: nothing, 1, or 1 and x.
[[nodiscard]] Eigen::MatrixXd trend_rows(ProcessTrend trend, const Eigen::MatrixXd& x);

/// K, with noise on its diagonal.
[[nodiscard]] Eigen::MatrixXd process_covariance(const ProcessData& data, ProcessKernel kernel,
                                                 const ProcessParameters& parameters);

struct ProcessPrediction {
    Eigen::VectorXd mean;
    Eigen::VectorXd variance; ///< of f(x)' b + Z(x), without noise, >= 0
};

/// @param x m x d; the answer to a row does not depend on the other rows
/// @throws std::invalid_argument if the number of columns is not that of the data
[[nodiscard]] ProcessPrediction predict(const GaussianProcess& process,
                                        const Eigen::MatrixXd& x);

/// Covariance of f(x)' b + Z(x) between all pairs of rows, without noise; its diagonal is
/// predict().variance to rounding.
[[nodiscard]] Eigen::MatrixXd predict_covariance(const GaussianProcess& process,
                                                 const Eigen::MatrixXd& x);

/// The mean alone: O(n) a row in place of O(n^2).
[[nodiscard]] Eigen::VectorXd predict_mean(const GaussianProcess& process,
                                           const Eigen::MatrixXd& x);

struct ProcessLeaveOneOut {
    Eigen::VectorXd residual; ///< y_i - what the others predict at x_i
    Eigen::VectorXd variance; ///< of that residual, noise of the point included
};

/// Predictions of each point from all others, in closed form (Dubrule 1983): residual_i = (Q
/// y)_i / Q_ii and variance_i = 1 / Q_ii with Q = K^-1 - K^-1 F (F' K^-1 F)^-1 F' K^-1.
/// Parameters are kept, the trend is not.
[[nodiscard]] ProcessLeaveOneOut leave_one_out(const GaussianProcess& process);

/// Logarithms of the densities that the others give to each y_i: the score by which processes
/// with other noise are compared (Gneiting and Raftery 2007).
[[nodiscard]] Eigen::VectorXd log_scores(const ProcessLeaveOneOut& left_out);

/// Mean square of what is missed on points left out over what is promised, at least 1: by this
/// the variance of a prediction is too small.
[[nodiscard]] double inflation_of(const ProcessLeaveOneOut& left_out);

} // namespace uq
