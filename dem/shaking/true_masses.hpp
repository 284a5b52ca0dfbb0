#pragma once
/// True masses of the rigid motions of blocks, and the largest time step that they allow.
///
/// The elastic modes of a block keep their fictitious masses, which follow from the step: they
/// are static at the frequencies of an earthquake. The step is then that of rigid blocks.

#include "dem/shaking/load_mass.hpp"
#include "dem/solver/state/step_tables.hpp"

#include <array>
#include <cstddef>
#include <vector>

namespace dem {

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

/// Largest stable time steps [s].
struct StepLimits {
    /// By block: 2 / omega of the bound of block_element.hpp, for its rigid motions.
    std::vector<double> block;
    double all = 0.0; ///< the least of them
    /// The least 2 / sqrt(k / m) of a dry joint alone between two blocks that move along its
    /// normal: contacts that open and close keep the energy at a fifth of it.
    double contact = 0.0;
};
/// @param stiffer stiffness of contacts that the step allows for, over that of the materials;
/// joints that close need more than 1 [-]
[[nodiscard]] StepLimits step_limits(const Model& model, const StepTables& tables,
                                     const WallMaterials& wall,
                                     const std::vector<BlockMass>& masses,
                                     double stiffer = 1.0);

/// Reduced mass of the two blocks of a run of dry contacts along its normal [kg].
[[nodiscard]] double reduced_mass(const std::array<int, 2>& blocks,
                                  const std::vector<BlockMass>& masses);

/// Normal stiffness of a run of dry contacts [N/m].
[[nodiscard]] double normal_stiffness(const StepTables& tables, std::size_t run,
                                      const WallMaterials& wall, const Model& model);

} // namespace dem
