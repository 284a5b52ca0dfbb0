#pragma once
/// One file solves the eigenvalue problems of all tests: a compiler takes long over it.

#include <Eigen/Core>

/// Of a symmetric matrix, rising.
[[nodiscard]] Eigen::VectorXd eigenvalues(const Eigen::MatrixXd& symmetric);
