#pragma once
/// How evenly the rows of a design lie in the unit cube. Rows are samples.

#include <Eigen/Core>

namespace uq {

/// Smallest Euclidean distance of two rows; infinity for one row.
[[nodiscard]] double minimum_distance(const Eigen::MatrixXd& u);

/// (sum over pairs of distance^-p)^(1/p) (Morris and Mitchell 1995), p > 0; small is good.
[[nodiscard]] double phi_p(const Eigen::MatrixXd& u, double p);

/// Centred L2 discrepancy, the root (Hickernell 1998, eq. 4.6); small is good.
[[nodiscard]] double centred_discrepancy(const Eigen::MatrixXd& u);

} // namespace uq
