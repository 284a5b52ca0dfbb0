#pragma once
/// Whether a response depends on an input at all, and how much: the Hilbert-Schmidt
/// independence criterion (Gretton et al. 2005) and the index of Da Veiga (2015), with Gaussian
/// kernels whose width is the standard deviation.

#include "uq/estimates/estimate.hpp"

#include <Eigen/Core>

#include <cstdint>

namespace uq {

struct Hsic {
    double share;   ///< HSIC(x, y) / sqrt(HSIC(x, x) HSIC(y, y)) [-], in [0, 1]; too large by
                    ///< about 1 / n of the distance to 1
    Estimate index; ///< the same by estimators without that bias; below 0 it says nothing
    double p_value; ///< share of permutations that do as well by chance [-], in (0, 1]
};

struct HsicOptions {
    int permutations = 499; ///< >= 19
    double confidence = kConfidence;
    std::uint64_t seed = 1;
    std::uint64_t stream = 0; ///< number of the input: each has permutations of its own
};

/// The index is the one of the unbiased estimators of Song et al. (2012); its standard error is
/// that of the jackknife, the interval normal and cut at 0 and 1. Bootstraps of this index hold
/// the truth less often (docs/bench/uq/given_data_coverage.md).
/// Cost: n^2 for each permutation.
/// @param x, y finite, of equal length, at least 6; else std::invalid_argument, also where one
/// of them does not vary
[[nodiscard]] Hsic hsic(const Eigen::VectorXd& x, const Eigen::VectorXd& y,
                        const HsicOptions& options = {});

} // namespace uq
