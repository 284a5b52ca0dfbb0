#pragma once
/// Modes of a block with many contact points, such as the loading beam of a long wall, without
/// a dense matrix of its points: the softest ones by shift and invert (Lanczos with full
/// orthogonalisation).

#include "dem/block/block_spec.hpp"
#include "dem/block/condensation.hpp"

#include <Eigen/Dense>

namespace dem {

/// Points from which blocks that keep few modes take this way. Below, the dense one is as fast,
/// and its bits are those of earlier versions. At 5 points to each half unit 300 points are 60
/// half units: the lower edge of the beam of a wall of 6 m with units of 0.2 m.
constexpr std::size_t kManyPoints = 300;

[[nodiscard]] bool has_many_points(const BlockSpec& spec);

/// The modes of block_modes(), with the displacements of all nodes.
struct SparseModes {
    Eigen::MatrixXd nodes;  ///< 2 nodes x modes
    Eigen::MatrixXd phi;    ///< 2 points x modes
    Eigen::VectorXd lambda; ///< exactly 0 for rigid motions
};
/// @throws std::runtime_error where the zones cannot be factorised, or the search does not
/// converge
[[nodiscard]] SparseModes sparse_modes(const BlockSpec& spec, const SparseBlock& block);

} // namespace dem
