#pragma once
/// The motions that a block can make: modes that are orthogonal in its elasticity and in the
/// stiffness of its contacts.

#include "dem/block/block_spec.hpp"
#include "dem/block/condensation.hpp"

#include <Eigen/Dense>
#include <Eigen/Sparse>

namespace dem {

struct BlockModes {
    Eigen::MatrixXd phi;    ///< 2 points x modes, phi^T C phi = 1
    Eigen::VectorXd lambda; ///< phi^T K phi, exactly 0 for rigid motions
};

/// C, the stiffness of the block's contacts while their other side is held, 2 points x 2 points
/// [N/m].
[[nodiscard]] Eigen::MatrixXd contact_metric(const BlockSpec& spec, const Condensed& c);

/// The same, of a block whose unknowns begin with those of the points.
[[nodiscard]] Eigen::SparseMatrix<double>
sparse_metric(const BlockSpec& spec, const std::vector<Point>& points, Eigen::Index unknowns);

/// Displacements at the points that modes begin with, 2 points x fields; none that a support
/// forbids.
struct LinearFields {
    Eigen::MatrixXd rigid;  ///< of a block that no support touches
    Eigen::MatrixXd moving; ///< those of them that it can make
    Eigen::MatrixXd linear; ///< constant strains and pure bending, or what a support allows
};
[[nodiscard]] LinearFields linear_fields(const BlockSpec& spec,
                                         const std::vector<Point>& points);

/// If spec.modes = m > 0, a free block keeps m modes: the three rigid motions first, then (from
/// m = 6 on) the constant strains, so that a uniform stress is exact, then those of pure
/// bending where spec.begins_with_bending, so that a linear stress is exact in a rectangle,
/// then the modes with the smallest lambda, which are soft against the contacts. A clamped
/// block keeps m - 3 modes: the linear fields that its support allows, then the softest. The
/// driven beam has no horizontal rigid motion, and no rotation where that is fixed.
[[nodiscard]] BlockModes block_modes(const BlockSpec& spec, const Condensed& c);

} // namespace dem
