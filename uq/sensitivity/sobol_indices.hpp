#pragma once
/// Shares of the variance of the response (Sobol' 1993): of each input alone (first order), and
/// with all its interactions (total order). Independent inputs.

#include "uq/estimates/estimate.hpp"

#include <Eigen/Core>

#include <vector>

namespace uq {

/// Points to run, (d + 2) n rows: A, B, then for each input A with that column from B (Saltelli
/// et al. 2010). @param a, b n x d on the unit cube, independent of each other (of a sequence:
/// the two halves of one in 2 d dimensions); else std::invalid_argument for unequal sizes
[[nodiscard]] Eigen::MatrixXd pick_freeze(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b);

struct SobolIndex {
    /// Mean of y_B (y_ABi - y_A) (Saltelli et al. 2010); may come out below 0 by its error.
    Estimate first;
    Estimate total; ///< mean of (y_A - y_ABi)^2 / 2 (Jansen 1999)
};

struct SobolIndices {
    std::vector<SobolIndex> inputs;
    double variance; ///< of the response, from the sound rows of A and B
};

/// Standard errors by the delta method over the n rows, as of independent ones: too large where
/// A and B are Latin hypercubes or sequences. `n` of an index counts rows; a row of which A, B
/// or ABi failed (NaN) is left out of index i and counted as failed.
/// @param y response to the rows of pick_freeze
/// @param d number of inputs
/// @throws std::invalid_argument if the length is no multiple of d + 2, a value is infinite,
/// fewer than 2 rows of an index are sound, or the response does not vary
[[nodiscard]] SobolIndices sobol_indices(const Eigen::VectorXd& y, Eigen::Index d,
                                         double confidence = kConfidence);

} // namespace uq
