#pragma once
/// Free choices of the discretisation and of the explicit solver, declared once. Their effect:
/// docs/convergence.md.

#include <string_view>

namespace dem {

enum class FaceRule {
    even,   ///< evenly spaced points, trapezoid areas
    lobatto ///< Gauss-Lobatto points and areas
};

enum class Damping {
    local, ///< Eq. 1: opposes the velocity
    combined ///< half opposes the velocity, half follows the change of force; no drag on steady motion
};

enum class Preload {
    solved, ///< from the static solution (static_start.hpp)
    ramped  ///< from the unloaded wall, by a ramp of the load
};

enum class ContactLaw {
    coupled,  ///< Table 2
    uncoupled ///< tension and shear damage apart (Fig. 7)
};

/// A crack that opened and closes again.
enum class Unloading {
    secant, ///< to the origin: closed at u_n = 0
    elastic ///< with k_n, by the increments of Table 1: propped at what did not spring back
};

struct Discretisation {
    int contact_points = 5; ///< per face of a half unit, >= 2
    FaceRule face_rule = FaceRule::lobatto;
    int zones_per_interval = 2; ///< block zones between two neighbouring contact points, >= 1
    int block_modes = 12;       ///< per block: 3 rigid, 6 simply deformable, ...; 0 all
    int beam_modes = 15;        ///< of the loading beam; 0 all
    friend bool operator==(const Discretisation&, const Discretisation&) = default;
};

/// Rungs from cheap to exact; error and cost of each: docs/bench/paper_walls.md.
enum class Fidelity {
    rigid,    ///< rigid blocks
    simple,   ///< rigid motion and constant strain
    standard, ///< the default: six modes more
    zones,    ///< all modes: the zones in full
    fine      ///< and more contact points: the reference of ensembles
};

[[nodiscard]] constexpr Discretisation discretisation_of(Fidelity f)
{
    Discretisation d;
    if (f == Fidelity::rigid) d.block_modes = 3;
    if (f == Fidelity::simple) d.block_modes = 6;
    if (f == Fidelity::zones || f == Fidelity::fine) d.block_modes = 0;
    if (f == Fidelity::fine) d.contact_points = 6;
    return d;
}

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
