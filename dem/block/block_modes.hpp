#pragma once
/// The motions a block is allowed: modes that are orthogonal in its elasticity and in the
/// stiffness of its contacts.

#include "dem/block/block_spec.hpp"
#include "dem/block/condensation.hpp"

#include <Eigen/Dense>

namespace dem {

struct BlockModes {
    Eigen::MatrixXd phi;    ///< 2 points x modes, phi^T C phi = 1
    Eigen::VectorXd lambda; ///< phi^T K phi, exactly 0 for rigid motions
};

/// C: stiffness of the block's contacts with their other side held, 2 points x 2 points [N/m].
[[nodiscard]] Eigen::MatrixXd contact_metric(const BlockSpec& spec, const Condensed& c);

/// Modes kept when spec.modes = m > 0: three rigid ones; from 6 on also the constant strains,
/// so that a uniform stress is exact; then those with the smallest lambda, softest against the
/// contacts. A clamped block keeps m - 3: the linear fields its support lets pass, then the
/// softest. A driven beam loses the horizontal rigid motion, and its rotation where that is
/// fixed.
[[nodiscard]] BlockModes block_modes(const BlockSpec& spec, const Condensed& c);

} // namespace dem
