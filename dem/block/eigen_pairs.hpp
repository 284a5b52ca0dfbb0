#pragma once
/// Dense symmetric eigenvalue problems of blocks. One file solves all of them: these solvers are what takes a compiler
/// longest in the whole folder.

#include <Eigen/Dense>

namespace dem {

struct EigenPairs {
    Eigen::MatrixXd vectors; ///< one per column, orthonormal (in C, where there is one)
    Eigen::VectorXd values;  ///< rising
};

/// Of K v = lambda v; K symmetric, of at least one row.
[[nodiscard]] EigenPairs eigen_pairs(const Eigen::MatrixXd& k);

/// Of K v = lambda C v; K symmetric, C symmetric and positive definite, both of the same size, at least one row.
[[nodiscard]] EigenPairs eigen_pairs(const Eigen::MatrixXd& k, const Eigen::MatrixXd& c);

} // namespace dem
