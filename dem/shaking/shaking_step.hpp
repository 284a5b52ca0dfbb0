#pragma once
/// One explicit step of a wall on ground that moves: leapfrog with true masses of the rigid
/// motions of blocks.
///
/// Positions are seen from the ground. In this moving frame the force -m a acts at the centre
/// of gravity of every block, a being the acceleration of the ground. No damping but that of
/// the contacts, where it is asked for.

#include "dem/shaking/true_masses.hpp"
#include "dem/solver/wall_state.hpp"

namespace dem {

/// Data of one block that leapfrog needs, in units of the step.
struct ShakenBlock {
    double mass = 0.0, inertia = 0.0;      ///< [kg/step2], [kg m2/step2]; 0: held
    double weight_mass = 0.0;              ///< what the ground's acceleration acts on [kg]
    double centre_x = 0.0, centre_z = 0.0; ///< of gravity, from the pivot, undeformed [m]
    double x = 0.0, z = 0.0;               ///< of gravity, now [m]
    double vx = 0.0, vz = 0.0, spin = 0.0; ///< half a step behind [m], [rad] in a step
};

struct ShakenBlocks {
    std::vector<ShakenBlock> blocks;
    double ground_work = 0.0; ///< so far [J]
    double fall_work = 0.0;   ///< of weight and vertical load, so far [J]
    double supported = 0.0;   ///< mass of blocks that the ground holds [kg]
};

/// Blocks at rest where the frames of the state are.
[[nodiscard]] ShakenBlocks shaken_blocks(const Model& model, const StepTables& tables,
                                         const WallMaterials& wall,
                                         const std::vector<BlockMass>& masses, double dt,
                                         const WallState<double>& state);

/// Acceleration of the ground in a step [m/s2]: to the right, and upwards.
struct GroundAcceleration {
    double x = 0.0, z = 0.0;
};

/// @param kick 1; half of it in the first step, which starts from rest
void shaking_step(const StepTables& tables, const SolverOptions& options,
                  const GroundAcceleration& ground, double kick, ShakenBlocks& blocks,
                  WallState<double>& state);

/// Kinetic energy of rigid motions [J].
[[nodiscard]] double kinetic_energy(const ShakenBlocks& blocks);

/// Gives dry contacts dashpots with the share zeta of what is critical for two blocks that move
/// along the normal of their joint. They act where a contact is closed, and never pull. Each is
/// taken implicitly, with the factor exp(-c dt / m) on the relative velocity and the mass m
/// that the bound of the step gives the contact, so that they cost no step.
void add_dashpots(const Model& model, const StepTables& tables, const WallMaterials& wall,
                  const std::vector<BlockMass>& masses, const StepLimits& limits, double zeta,
                  double dt, WallState<double>& state);

} // namespace dem
