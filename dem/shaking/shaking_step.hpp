#pragma once
/// One explicit step of walls on ground that moves, one in each lane: leapfrog with true masses
/// of the rigid motions of blocks.
///
/// Positions are seen from the ground. In this moving frame the force -m a acts at the centre
/// of gravity of every block, a being the acceleration of the ground. No damping but that of
/// the contacts, where it is asked for. Each wall has its own time step, in units of which its
/// motion is.

#include "dem/shaking/step_limits.hpp"
#include "dem/solver/state/wall_state.hpp"

namespace dem {

/// Data of one block that leapfrog needs, in units of the step.
template <class Real> struct ShakenBlock {
    Real inv_mass{0.0}, inv_inertia{0.0}; ///< [step2/kg], [step2/(kg m2)]; 0: held
    Real weight_mass{0.0};                ///< what the ground's acceleration acts on [kg]
    Real centre_x{0.0}, centre_z{0.0};    ///< of gravity, from the pivot, undeformed [m]
    Real x{0.0}, z{0.0};                  ///< of gravity, now [m]
    Real vx{0.0}, vz{0.0}, spin{0.0};     ///< half a step behind [m], [rad] in a step
};

/// Walls that are shaken, one in each lane.
template <class Real> struct ShakenWalls {
    WallState<Real> state;
    std::vector<ShakenBlock<Real>> blocks;
    Real ground_work{0.0}; ///< so far [J]
    Real fall_work{0.0};   ///< of weight and vertical load, so far [J]
    Real supported{0.0};   ///< mass of blocks that the ground holds [kg]
};

/// Every lane empty. @param dashed whether walls of this batch have dashpots in their contacts
template <class Real>
[[nodiscard]] ShakenWalls<Real> empty_shaken(const Model& model, const StepTables& tables,
                                             bool dashed);

/// Puts a lane to rest: it has no wall.
template <class Real>
void clear_lane(const StepTables& tables, int lane, ShakenWalls<Real>& walls);

/// Puts a wall, at rest where `start` has it, into a lane.
/// @param options those of this wall, with its share of the stable step
/// @param dt its time step [s]
template <class Real>
void load_lane(const Model& model, const StepTables& tables, const WallMaterials& wall,
               const SolverOptions& options, const WallState<double>& start,
               const std::vector<BlockMass>& masses, double dt, int lane,
               ShakenWalls<Real>& walls);

/// Motion of the ground under each wall in a step: acceleration to the right and upwards
/// [m/s2]. The kick is 1, half of it in the first step, which starts from rest, and 0 in a lane
/// without a wall.
template <class Real> struct ShakingInput {
    Real x{0.0}, z{0.0}, kick{0.0};
};

template <class Real>
void shaking_step(const StepTables& tables, const SolverOptions& options,
                  const ShakingInput<Real>& input, ShakenWalls<Real>& walls);

/// Kinetic energy of the rigid motions of each wall [J] at the end of the last step, to where
/// half a step of the forces there brings the velocities. Half a step behind, the energy
/// balance would miss what contacts do in half a step, which is much when blocks strike. The
/// work of the ground is half a step behind, and so is what it has moved.
template <class Real>
[[nodiscard]] Real kinetic_energy(const StepTables& tables, const ShakenWalls<Real>& walls);

/// Gives the dry contacts of a wall dashpots with the share zeta of what is critical for two
/// blocks that move along the normal of their joint. They act where a contact is closed, and
/// never pull. Each is taken implicitly, with the factor exp(-c dt / m) on the relative
/// velocity and the mass m that the bound of the step gives the contact.
/// @param shares see dashpot_shares()
template <class Real>
void set_dashpots(const std::vector<double>& shares, int lane, WallState<Real>& state);

/// By run of dry contacts: stress of its dashpots over stiffness times displacement in a step
/// of dt [-].
[[nodiscard]] std::vector<double> dashpot_shares(const Model& model, const StepTables& tables,
                                                 const WallMaterials& wall,
                                                 const std::vector<BlockMass>& masses,
                                                 const StepLimits& limits, double zeta,
                                                 double dt);

} // namespace dem
