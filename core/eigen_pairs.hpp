#pragma once
/// Dense symmetric eigenvalue problems of blocks. One file solves all of them, because a
/// compiler takes seconds for each file that does.

#include <Eigen/Dense>

namespace core {

struct EigenPairs {
    Eigen::MatrixXd
        vectors; ///< one in each column; V^T V = 1, or V^T C V = 1 where there is a C
    Eigen::VectorXd values; ///< in rising order
};

/// Solves K v = lambda v. K is symmetric and has at least one row.
[[nodiscard]] EigenPairs eigen_pairs(const Eigen::MatrixXd& k);

/// Solves K v = lambda C v. K is symmetric, C symmetric and positive definite; both have the
/// same size, at least one row.
[[nodiscard]] EigenPairs eigen_pairs(const Eigen::MatrixXd& k, const Eigen::MatrixXd& c);

} // namespace core
