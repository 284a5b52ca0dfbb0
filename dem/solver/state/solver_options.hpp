#pragma once
/// The free choices of the explicit solver. docs/bench/accuracy/convergence.md shows their
/// effect.

#include "dem/contact/contact_options.hpp"

namespace dem {

enum class Damping {
    local, ///< opposes the velocity (Eq. 1)
    /// Half of it opposes the velocity, half follows the change of the force, so that a steady
    /// motion is not dragged.
    combined
};

enum class Preload {
    solved, ///< the push starts from the static solution (static_start.hpp)
    ramped  ///< the load is ramped up on the unloaded wall
};

enum class Kinematics {
    small, ///< contacts found once, lever arms of the undeformed wall (the paper, section 2.1)
    finite ///< blocks turn and slide by any amount; forces balance where the blocks are
};

struct SolverOptions {
    /// Error of forces and of limit displacements that a user will bear [-], in (0, 0.5]. The
    /// drive finds the speed that holds it.
    double accuracy = 0.01;
    Kinematics kinematics = Kinematics::small;
    ContactLaw law = ContactLaw::coupled;
    Unloading unloading = Unloading::secant;
    Damping damping = Damping::combined;
    double damping_factor = 0.8; ///< gamma of Eq. 1 [-], in (0, 1)
    /// Time step as a fraction of the proven stability limit (block_element.hpp) [-], > 0. The
    /// key of a study ends at 1. Above 1, which only serves to study the limit itself
    /// (bench/stability), stability is measured before the push, and the step is halved where
    /// the measurement or the energy balance fails.
    double step_fraction = 0.95;
    /// Fewest steps per displacement of the load line: the fastest that the drive may go
    /// [1/mm], > 0.
    double steps_per_mm = 400;
    /// |top force - base shear| above which the drive slows, as a share of the error that is
    /// borne: accuracy x largest
    /// force so far [-], >= 0. With 0 the drive goes at its fastest all the way, whatever it
    /// takes.
    double unbalance_limit = 1.0;
    double min_speed =
        0.01; ///< slowest drive of a wall out of balance, as a share of its speed in balance, in (0, 1]
    /// Largest number of times that a wall that misses the accuracy is pushed again, twice as
    /// slowly each time.
    int most_slowdowns = 3;
    Preload preload = Preload::solved;
    long long preload_steps =
        3000; ///< largest number of steps to come to rest under vertical load
    /// Unbalanced / applied load at which the wall counts as being at rest under vertical load
    /// [-].
    double preload_unbalance = 1e-4;
    double energy_tolerance = 0.01;    ///< largest energy residual of a run that counts [-]
    long long most_steps = 20'000'000; ///< largest number of steps of one wall
    /// Whether laws are skipped where they cannot change the answer. False serves to prove
    /// that.
    bool shortcuts = true;
    friend bool operator==(const SolverOptions&, const SolverOptions&) = default;
};

} // namespace dem
