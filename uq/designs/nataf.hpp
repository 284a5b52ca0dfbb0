#pragma once
/// Pearson correlation through the normal copula (Liu and Der Kiureghian 1986; Nataf 1962):
/// which correlation of the normal variables gives the one asked for between the variables
/// themselves.
///
/// With x(z) = sum a_k h_k(z) in orthonormal Hermite polynomials, the correlation of x_1(z_1)
/// and x_2(z_2) is  rho = sum a_k b_k rho_z^k  (Mehler 1866; Grigoriu 1995, ch. 3): one
/// quadrature per variable, not one per pair and step.

#include "uq/marginals/marginal.hpp"

#include <Eigen/Core>

namespace uq {

/// a_1, a_2, ... of the standardised variable, until only zeros follow; at most 1000, which
/// only separate values and the kink of a triangle need. Empty for a constant.
///
/// The remainder of a pair beyond the 1000 falls with |rho_z|^1000. Triangles: below 1e-9 of
/// rho up to
/// |rho_z| = 1. Separate values with separate values: two coins, the worst, lose 3e-8 of rho at
/// |rho_z| = 0.99, 1e-3 at 0.999 and 2e-2 at 1; 3 to 200 observations 1e-2 to 4e-4 at 1. So
/// the last hundredth or less below the largest correlation is refused as not attainable, and
/// above |rho_z| = 0.99 the one found is too large in size. One variable that is not separate
/// is enough for more digits.
[[nodiscard]] Eigen::VectorXd hermite_coefficients(const Marginal& m);

/// rho of the variables with coefficients a and b for rho_z in [-1, 1] of their normal images.
[[nodiscard]] double pearson_of_normals(const Eigen::VectorXd& a, const Eigen::VectorXd& b,
                                        double rho_z);

/// rho_z that gives rho.
/// @throws std::invalid_argument naming the range that the variables can attain
[[nodiscard]] double normal_correlation(const Eigen::VectorXd& a, const Eigen::VectorXd& b,
                                        double rho);

} // namespace uq
