#pragma once
/// Random fields over sites: coordinates of a sample in, one value per site out.
///
/// A sample is one row of independent standard normal coordinates. The caller draws them: keyed
/// by sample (field_coordinates), or a Latin hypercube or sequence on the unit cube
/// (normal_coordinates). A row gives the same field alone and among others, to the bit.

#include "uq/fields/field_basis.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace uq {

/// n x `count` standard normal coordinates; row i is read off the stream (seed, id[i], field),
/// so it does not depend on which other samples are asked for. Several fields of one sample
/// share the stream: ask once for all their coordinates and split the columns.
[[nodiscard]] Eigen::MatrixXd
field_coordinates(std::uint64_t seed, std::span<const std::uint64_t> id, Eigen::Index count);

/// Standard normal quantiles of a design on the unit cube.
/// @throws std::invalid_argument naming the entry that is not in (0, 1)
[[nodiscard]] Eigen::MatrixXd normal_coordinates(const Eigen::MatrixXd& unit_cube);

/// Standard normal field: n samples x sites.
/// @param z n x coordinates of `basis`, finite, else std::invalid_argument
[[nodiscard]] Eigen::MatrixXd realise(const FieldBasis& basis, const Eigen::MatrixXd& z);

/// Several standard normal fields over the same sites in separable form: the correlation
/// between variable k at site i and variable l at site j is variables(k, l) x correlation of i
/// and j.
/// @param variables v x v correlation matrix
/// @param z n x (v x coordinates), the coordinates of the first variable first
/// @return one matrix n x sites for each variable
/// @throws std::invalid_argument as realise and cholesky_basis
[[nodiscard]] std::vector<Eigen::MatrixXd>
realise(const FieldBasis& basis, const Eigen::MatrixXd& variables, const Eigen::MatrixXd& z);

} // namespace uq
