#pragma once
/// Sparse polynomial chaos from samples: the terms that a corrected leave-one-out error
/// chooses.
///
/// Forward selection by orthogonal least squares (Chen, Billings, Luo 1989): the next term is
/// the one that leaves the least residual. Each length of the path, each degree and each
/// hyperbolic set is judged by the leave-one-out error of its least squares times n / (n - P)
/// (1 + tr((A' A)^-1)) (Chapelle, Vapnik, Bengio 2002; Blatman and Sudret 2011).

#include "uq/surrogates/polynomial_chaos.hpp"

#include <vector>

namespace uq {

struct ChaosFitOptions {
    int most_degree = 12;                         ///< >= 1; degrees are tried from 1 on
    std::vector<double> norms = {0.5, 0.75, 1.0}; ///< q of the hyperbolic sets, each in (0, 1]
    Eigen::Index most_terms = 1200;               ///< of a set that is tried
};

struct ChaosFit {
    PolynomialChaos chaos;
    int degree;               ///< of the set that was chosen
    double norm;              ///< its q
    Eigen::VectorXd residual; ///< y_i less what the same terms, fitted to all others, predict
    double
        corrected_error; ///< mean square of `residual`, corrected, over the variance of y [-]
};

/// @param c coordinates, n x d; n >= 3
/// @throws std::invalid_argument for sizes that do not fit, values that are not finite, options
/// out of range, or a response
/// that does not vary
[[nodiscard]] ChaosFit fit_chaos(const std::vector<PolynomialFamily>& families,
                                 const Eigen::MatrixXd& c, const Eigen::VectorXd& y,
                                 const ChaosFitOptions& options = {});

/// Residuals of walls that had no say in the choice of the terms either: the walls are parted
/// into `folds` (row modulo folds), and terms of the set of `fit` are chosen anew without each
/// part.
[[nodiscard]] Eigen::VectorXd held_out_residuals(const ChaosFit& fit, const Eigen::MatrixXd& c,
                                                 const Eigen::VectorXd& y, int folds = 10);

} // namespace uq
