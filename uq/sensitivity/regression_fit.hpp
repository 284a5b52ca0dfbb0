#pragma once
/// Least squares on standardised values or ranks.

#include "uq/sensitivity/regression.hpp"

namespace uq {

struct RegressionFit {
    Eigen::MatrixXd x; ///< n x d, columns of mean 0 and mean square 1, or 0 if they do not vary
    Eigen::VectorXd y; ///< likewise
    Eigen::MatrixXd inverse;  ///< pseudo-inverse of x, d x n
    Eigen::VectorXd beta;     ///< standardised coefficients, of least norm
    Eigen::VectorXd residual; ///< of y
    Eigen::Index rank;        ///< of x, to a relative pivot of 1e-9
};

/// @param x, y sound rows
[[nodiscard]] RegressionFit fit_standardised(const Eigen::MatrixXd& x, const Eigen::VectorXd& y,
                                             RegressionScale scale);

/// t / sqrt(t^2 + freedom) of coefficient j, in [-1, 1]; 0 where it is 0.
[[nodiscard]] double partial_correlation(const RegressionFit& f, Eigen::Index j);

} // namespace uq
