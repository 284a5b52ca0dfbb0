#pragma once
/// Coordinates times the transposed map of a field, many samples at once.

#include <Eigen/Core>

namespace uq {

/// z map^T. Each entry is summed over the coordinates in their order, whatever the number of
/// samples, so a sample has the same bits in every batch. Zeros at the end of the rows of `map`
/// (a triangle) are skipped.
/// @param z n x r  @param map p x r  @return n x p
[[nodiscard]] Eigen::MatrixXd times_transposed(const Eigen::MatrixXd& z,
                                               const Eigen::MatrixXd& map);

} // namespace uq
