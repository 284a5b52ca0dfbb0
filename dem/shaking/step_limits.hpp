#pragma once
/// The largest time steps of a wall whose rigid motions have true masses.
///
/// The elastic modes of a block keep fictitious masses, which follow from the step: they are
/// static at the frequencies of an earthquake. The step is then that of rigid blocks.

#include "dem/shaking/true_masses.hpp"

#include <array>
#include <cstddef>
#include <vector>

namespace dem {

/// Largest stable time steps [s].
struct StepLimits {
    /// By block: 2 / omega of the bound of block_element.hpp, for its rigid motions.
    std::vector<double> block;
    double bound = 0.0; ///< the least of them
    /// 2 / omega of the wall in which nothing opens, slips or cracks: at least the bound. Where
    /// joints close, the bound.
    double whole = 0.0;
    /// Time step that elastic modes have the masses of: kElasticStep times the bound.
    double elastic = 0.0;
    /// The least 2 / sqrt(k / m) of a dry joint alone between two blocks that move along its
    /// normal: contacts that open and close keep the energy at a quarter of it, or less.
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
