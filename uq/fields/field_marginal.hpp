#pragma once
/// From standard normal fields to fields of a material property.

#include "uq/marginals/marginal.hpp"

#include <Eigen/Core>

namespace uq {

/// The field with marginal `m` at every site (translation, Grigoriu 1984): m's quantile of
/// Phi(g). The correlation of the result is a little below that of g unless m is normal.
[[nodiscard]] Eigen::MatrixXd translate(const Eigen::MatrixXd& standard, const Marginal& m);

} // namespace uq
