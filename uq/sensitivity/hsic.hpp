#pragma once
/// Whether a response depends on an input at all: the Hilbert-Schmidt independence criterion
/// (Gretton et al. 2005; Da Veiga 2015), with Gaussian kernels whose width is the standard
/// deviation.

#include <Eigen/Core>

#include <cstdint>

namespace uq {

struct Hsic {
    double share;   ///< HSIC(x, y) / sqrt(HSIC(x, x) HSIC(y, y)) [-], in [0, 1]
    double p_value; ///< share of permutations that do as well by chance [-], in (0, 1]
};

struct HsicOptions {
    int permutations = 499; ///< >= 19
    std::uint64_t seed = 1;
    std::uint64_t stream = 0; ///< number of the input: each has permutations of its own
};

/// Cost: n^2 for each permutation.
/// @param x, y finite, of equal length, at least 5; else std::invalid_argument, also where one
/// of them does not vary
[[nodiscard]] Hsic hsic(const Eigen::VectorXd& x, const Eigen::VectorXd& y,
                        const HsicOptions& options = {});

} // namespace uq
