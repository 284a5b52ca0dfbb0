#pragma once
/// Correlation by reordering (Iman and Conover 1982): the values of each variable stay what
/// they are, so a Latin hypercube stays Latin.

#include <Eigen/Core>

namespace uq {

/// Scores Phi^-1(rank / (n + 1)) of the values of each column.
[[nodiscard]] Eigen::MatrixXd normal_scores(const Eigen::MatrixXd& x);

/// Columns of x reordered to the ranks of  scores F^-1 C,  F'F = scores' scores / n, C'C =
/// target. The first column keeps the order of its scores; with the scores of x itself rows
/// move no more than the correlation needs.
/// @param target the correlation that the scores get exactly; positive definite
/// @throws std::invalid_argument unless rows outnumber columns and the scores are independent
[[nodiscard]] Eigen::MatrixXd reordered(const Eigen::MatrixXd& x, const Eigen::MatrixXd& target,
                                        const Eigen::MatrixXd& scores);

} // namespace uq
