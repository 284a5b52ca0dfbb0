#pragma once
/// Random fields over sites: coordinates of a sample in, one value per site out.
///
/// A sample is one row of independent standard normal coordinates, which the caller draws. A
/// row gives the same field alone and among others, to the bit.

#include "uq/fields/field_basis.hpp"

namespace uq {

/// Standard normal field: n samples x sites.
/// @param z n x coordinates of `basis`, finite, else std::invalid_argument
[[nodiscard]] Eigen::MatrixXd realise(const FieldBasis& basis, const Eigen::MatrixXd& z);

} // namespace uq
