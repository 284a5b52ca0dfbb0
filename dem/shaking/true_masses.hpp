#pragma once
/// True masses of the rigid motions of blocks.

#include "dem/shaking/load_mass.hpp"
#include "dem/solver/state/step_tables.hpp"

#include <Eigen/Core>

#include <vector>

namespace dem {

struct BlockElement;
struct Model;
struct WallMaterials;

/// One block with what rides on it. The place of the centre of gravity is seen from the pivot,
/// undeformed.
struct BlockMass {
    double mass = 0.0;                     ///< [kg]; 0: a support holds the block
    double inertia = 0.0;                  ///< about the centre of gravity [kg m2]
    double centre_x = 0.0, centre_z = 0.0; ///< [m]
};

/// @param load_height of the floor's mass above the point on which the load acts [m]
/// @throws std::invalid_argument if a support holds some rigid motions of a block but not all,
/// or a block has no mass
[[nodiscard]] std::vector<BlockMass> true_masses(const Model& model, const StepTables& tables,
                                                 const WallMaterials& wall, LoadMass load,
                                                 double load_height = 0.0);

/// Masses of the rigid modes of a block [s2]: those of its pivot, in its first modes.
[[nodiscard]] Eigen::Matrix3d modal_mass(const BlockElement& element, const BlockMass& block);

} // namespace dem
