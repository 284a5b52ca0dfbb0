#pragma once
/// Products of a matrix with many rows, such as coordinates of samples with the map of a field.

#include <Eigen/Core>

namespace core {

/// z map^T. Each entry is summed over the coordinates in their order, whatever the number of
/// rows, so a row has the same bits in every batch. Zeros at the end of the rows of `map` (a
/// triangle) are skipped.
/// @param z n x r  @param map p x r  @return n x p
[[nodiscard]] Eigen::MatrixXd times_transposed(const Eigen::MatrixXd& z,
                                               const Eigen::MatrixXd& map);

} // namespace core
