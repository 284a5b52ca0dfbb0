#pragma once
/// The free choices of the explicit solver. docs/convergence.md shows their effect.

#include "dem/contact/contact_options.hpp"

namespace dem {

enum class Damping {
    local, ///< Eq. 1: opposes the velocity
    combined ///< half opposes the velocity, half follows the change of force; no drag on steady motion
};

enum class Preload {
    solved, ///< from the static solution (static_start.hpp)
    ramped  ///< from the unloaded wall, by a ramp of the load
};

struct SolverOptions {
    ContactLaw law = ContactLaw::coupled;
    Unloading unloading = Unloading::secant;
    Damping damping = Damping::combined;
    double damping_factor = 0.8; ///< gamma of Eq. 1 [-], in (0, 1)
    /// Of the step that is stable by the bound of block_element.hpp [-], > 0; above 1 the bound
    /// promises nothing, and a step that proves too large is halved.
    double step_fraction = 0.95;
    double steps_per_mm = 1000; ///< of the load line's way at full speed [1/mm], > 0
    /// |top force - base shear| / vertical load above which the drive slows [-]; 0: never
    /// slows.
    double unbalance_limit = 0.001;
    double min_speed = 0.01; ///< slowest drive, as a share of full speed, in (0, 1]
    Preload preload = Preload::solved;
    long long preload_steps = 3000; ///< at most, to come to rest under the vertical load
    /// Unbalanced / applied load at which the vertical load counts as carried [-].
    double preload_unbalance = 1e-4;
    double energy_tolerance = 0.01;    ///< largest energy residual of a run that counts [-]
    long long most_steps = 20'000'000; ///< of one wall
    /// Skips laws where they cannot change the answer. False: for the proof that they do not.
    bool shortcuts = true;
    friend bool operator==(const SolverOptions&, const SolverOptions&) = default;
};

} // namespace dem
