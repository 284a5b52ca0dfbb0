#pragma once
/// Factors of dense matrices. One file computes all of them, because a compiler takes seconds
/// for each file that does.

#include <Eigen/Cholesky>

namespace core {

/// m = L L^T. info() is not Eigen::Success where m is not positive definite.
/// @param m symmetric; only its lower triangle is read
[[nodiscard]] Eigen::LLT<Eigen::MatrixXd> cholesky(const Eigen::MatrixXd& m);

/// The solutions x of L L^T x = b, a column for each of b.
[[nodiscard]] Eigen::MatrixXd solve(const Eigen::LLT<Eigen::MatrixXd>& factor,
                                    const Eigen::MatrixXd& b);

struct LeastSquares {
    Eigen::VectorXd coefficients; ///< one for each column
    Eigen::Index rank;            ///< number of columns that are independent
};

/// The coefficients b that make |x b - y| least, by a QR factor with pivots.
[[nodiscard]] LeastSquares least_squares(const Eigen::MatrixXd& x, const Eigen::VectorXd& y);

/// Part of each y_i in its own fitted value: the diagonal of x (x' x)^-1 x', in [0, 1].
[[nodiscard]] Eigen::VectorXd leverages(const Eigen::MatrixXd& x);

/// The number of columns that are independent.
[[nodiscard]] Eigen::Index rank(const Eigen::MatrixXd& m);

} // namespace core
