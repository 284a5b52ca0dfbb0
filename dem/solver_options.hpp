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

enum class ContactLaw {
    coupled,  ///< Table 2
    uncoupled ///< tension and shear damage apart (Fig. 7)
};

struct Discretisation {
    int contact_points = 5; ///< per face of a half unit, >= 2
    FaceRule face_rule = FaceRule::lobatto;
    int zones_per_interval = 2; ///< block zones between two neighbouring contact points, >= 1
    int block_modes = 0;        ///< per block: 3 rigid, 6 simply deformable, ...; 0 all
    int beam_modes = 15;        ///< of the loading beam; 0 all
};

struct SolverOptions {
    ContactLaw law = ContactLaw::coupled;
    Damping damping = Damping::combined;
    double damping_factor = 0.8; ///< gamma of Eq. 1 [-], in (0, 1)
    /// Of the step that is stable by the bound of block_element.hpp [-], in (0, 1].
    double step_fraction = 0.95;
    double steps_per_mm = 1500; ///< of the load line's way at full speed [1/mm], > 0
    /// |top force - base shear| / vertical load above which the drive slows [-]; 0: never
    /// slows.
    double unbalance_limit = 0.003;
    double min_speed = 0.01;        ///< slowest drive, as a share of full speed, in (0, 1]
    long long preload_steps = 3000; ///< at most, for the vertical load
    /// Unbalanced / applied load at which the vertical load counts as carried [-].
    double preload_unbalance = 1e-4;
};

} // namespace dem
