#pragma once
/// Sparse polynomial chaos: a response as a sum of products of orthonormal polynomials of
/// independent variables.
///
///   y(c) = sum_t a_t prod_k p_(t, k)(c_k)

#include "uq/surrogates/polynomials.hpp"

#include <Eigen/Core>

#include <vector>

namespace uq {

struct PolynomialChaos {
    std::vector<PolynomialFamily> families; ///< of each input
    Eigen::MatrixXi degrees;                ///< terms x inputs
    Eigen::VectorXd coefficients;           ///< of the terms, in the unit of the response
};

/// Degrees alpha with (sum_k alpha_k^q)^(1 / q) <= degree (hyperbolic set of Blatman and Sudret
/// 2011), the constant first, then by total degree. @param q in (0, 1]; 1: all of that total
/// degree
[[nodiscard]] Eigen::MatrixXi hyperbolic_set(int inputs, int degree, double q);

/// Terms at points: m x terms. @param c coordinates, m x d
[[nodiscard]] Eigen::MatrixXd chaos_terms(const std::vector<PolynomialFamily>& families,
                                          const Eigen::MatrixXi& degrees,
                                          const Eigen::MatrixXd& c);

/// @throws std::invalid_argument if the number of columns is not that of the families
[[nodiscard]] Eigen::VectorXd predict(const PolynomialChaos& chaos, const Eigen::MatrixXd& c);

[[nodiscard]] double mean(const PolynomialChaos& chaos);
[[nodiscard]] double
variance(const PolynomialChaos& chaos); ///< sum of the squares of all but the constant

/// Share of each input alone and with all its interactions [-], in [0, 1] (Sudret 2008).
struct ChaosIndices {
    Eigen::VectorXd first, total;
};
/// All are 0 where the variance is.
[[nodiscard]] ChaosIndices sobol_indices(const PolynomialChaos& chaos);

} // namespace uq
