#pragma once
/// One file solves the eigenvalue problems of all tests: a compiler takes long over it.

#include <Eigen/Core>

/// The eigenvalues of a symmetric matrix, in rising order.
[[nodiscard]] Eigen::VectorXd eigenvalues(const Eigen::MatrixXd& symmetric);
