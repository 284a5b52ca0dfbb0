#pragma once
/// Moment-independent importance of one input from given samples (Borgonovo 2007).
///
///   delta = 1/2 E_x[ integral |f_y - f_y|x| dy ], in [0, 1]; 0: y does not depend on x

#include "uq/estimates/estimate.hpp"

#include <Eigen/Core>

#include <cstdint>

namespace uq {

struct DeltaOptions {
    int resamples = 100; ///< of the bootstrap, >= 10
    double confidence = kConfidence;
    std::uint64_t seed = 1;
    std::uint64_t stream = 0; ///< number of the input: each has resamples of its own
};

/// Estimate of Plischke, Borgonovo and Smith (2013): classes of equal counts along x, densities
/// by Gaussian kernels with Silverman's width. The value is twice the estimate less the mean of
/// its bootstrap, which takes the bias of few samples off only in part; it can come out below
/// 0, and then says nothing but that the dependence is weak.
/// @param x, y finite, of equal length, at least 10; else std::invalid_argument, also where one
/// of them does not vary
[[nodiscard]] Estimate delta_index(const Eigen::VectorXd& x, const Eigen::VectorXd& y,
                                   const DeltaOptions& options = {});

/// The estimate without bootstrap.
[[nodiscard]] double raw_delta(const Eigen::VectorXd& x, const Eigen::VectorXd& y);

} // namespace uq
