#pragma once
/// Pearson correlation through the normal copula (Liu and Der Kiureghian 1986; Nataf 1962): which
/// correlation of the normal variables gives the one asked for between the variables themselves.
///
/// With x(z) = sum a_k h_k(z) in orthonormal Hermite polynomials, the correlation of x_1(z_1) and
/// x_2(z_2) is  rho = sum a_k b_k rho_z^k  (Mehler 1866; Grigoriu 1995, ch. 3): one quadrature per
/// variable, not one per pair and step.

#include "uq/marginal.hpp"

#include <Eigen/Core>

namespace uq {

/// a_1, a_2, ... of the standardised variable, until only zeros follow; at most 1000, which only
/// separate values and the kink of a triangle need. Empty for a constant.
[[nodiscard]] Eigen::VectorXd hermite_coefficients(const Marginal& m);

/// rho of the variables with coefficients a and b for rho_z in [-1, 1] of their normal images.
[[nodiscard]] double pearson_of_normals(const Eigen::VectorXd& a, const Eigen::VectorXd& b,
                                        double rho_z);

/// rho_z that gives rho.
/// @throws std::invalid_argument naming the range that the variables can attain
[[nodiscard]] double normal_correlation(const Eigen::VectorXd& a, const Eigen::VectorXd& b,
                                        double rho);

/// rho_z = 2 sin(pi rho_s / 6) gives Spearman's rho_s whatever the (continuous) marginals.
[[nodiscard]] double normal_correlation_of_ranks(double rho_s);

} // namespace uq
