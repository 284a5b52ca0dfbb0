#pragma once
/// How evenly the rows of a design lie in the unit cube. Rows are samples.

#include <Eigen/Core>

namespace uq {

/// Smallest Euclidean distance of two rows; infinity for one row.
[[nodiscard]] double minimum_distance(const Eigen::MatrixXd& u);

} // namespace uq
