#pragma once
/// Intervals of regression coefficients by resampling the rows.

#include "uq/sensitivity/regression.hpp"

namespace uq {

/// Replaces standard errors and intervals of the identifiable inputs by those of resamples
/// (Efron and Tibshirani 1993, percentile). Resample b is read off the stream (seed, b,
/// bootstrap). A resample whose response does not vary is drawn again.
/// @throws std::invalid_argument for fewer than 20 resamples
void bootstrap_intervals(Regression& r, const Eigen::MatrixXd& x, const Eigen::VectorXd& y,
                         const RegressionOptions& options);

} // namespace uq
