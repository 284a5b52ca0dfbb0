#pragma once
/// Which matrices are correlations, and which is the nearest that is.

#include <Eigen/Core>

#include <string>

namespace uq {

/// The nearest correlation matrix in the Frobenius norm with no eigenvalue below `least`, by
/// alternating projections with Dykstra's correction (Higham 2002, algorithm 3.3).
/// @param a square, finite; its symmetric part is taken
[[nodiscard]] Eigen::MatrixXd nearest_correlation(const Eigen::MatrixXd& a,
                                                  double least = 1e-6);

/// The matrix as text: rows in brackets, 6 digits. Of a large matrix only the entries that
/// differ most from those of `from` are listed.
[[nodiscard]] std::string correlation_text(const Eigen::MatrixXd& r,
                                           const Eigen::MatrixXd& from);

/// @param what name of the matrix, which begins the message: "pearson"
/// @throws std::invalid_argument if `r` is not d x d, finite, symmetric (to 1e-12), 1 on its
/// diagonal, within [-1, 1] and positive definite (eigenvalues above 1e-10); the message shows
/// the nearest matrix that is
void check_correlation(const Eigen::MatrixXd& r, Eigen::Index d, const std::string& what);

} // namespace uq
