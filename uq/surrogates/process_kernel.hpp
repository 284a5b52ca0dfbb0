#pragma once
/// Correlation functions of a Gaussian process over scaled distances (Rasmussen and Williams
/// 2006, chapter 4).
///
///   r^2 = sum_k ((x_k - x'_k) / l_k)^2
///   matern_32           (1 + a) exp(-a),             a = sqrt(3) r
///   matern_52           (1 + a + a^2 / 3) exp(-a),   a = sqrt(5) r
///   squared_exponential exp(-r^2 / 2)

#include <Eigen/Core>

#include <string_view>

namespace uq {

enum class ProcessKernel { matern_32, matern_52, squared_exponential };
[[nodiscard]] std::string_view name(ProcessKernel kernel); ///< "Matern 5/2"

/// @param r2 square of the scaled distance [-], >= 0
[[nodiscard]] double process_correlation(ProcessKernel kernel, double r2);

/// -2 d correlation / d r^2: the derivative by ln l_k is this times ((x_k - x'_k) / l_k)^2.
[[nodiscard]] double process_slope(ProcessKernel kernel, double r2);

/// Squares of the scaled distances of `point` to the rows of `x`. Each is the same number
/// whatever other rows there are.
/// @param scaled rows over lengths, n x d @param point over lengths, d
[[nodiscard]] Eigen::VectorXd scaled_distances(const Eigen::MatrixXd& scaled,
                                               const Eigen::RowVectorXd& point);

} // namespace uq
