#pragma once
/// Eigenvalues of symmetric matrices. One file solves all of them, because a compiler takes
/// seconds for each file that does.

#include <Eigen/Core>

namespace uq {

struct EigenPairs {
    Eigen::MatrixXd vectors; ///< one in each column, orthonormal
    Eigen::VectorXd values;  ///< in rising order
};

/// @param symmetric at least one row; the lower triangle is read
[[nodiscard]] EigenPairs eigen_pairs(const Eigen::MatrixXd& symmetric);

} // namespace uq
