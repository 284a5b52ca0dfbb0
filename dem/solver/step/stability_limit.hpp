#pragma once
/// Measures how far the time step is from the largest stable one.
///
/// Leapfrog with a unit step is stable while omega_max <= 2, where omega_max^2 is the largest
/// eigenvalue of M^-1 K. The wall is fastest when all contacts are closed, sticking and
/// uncracked. At the limit a mode changes sign in every step, q_n = (-1)^n a. Its force F_n =
/// -omega^2 m q_n then opposes the velocity that led there and has the sign of its own change
/// F_n - F_(n-1): local damping adds gamma |F| to it, combined damping adds both its halves,
/// and every step is one of an undamped mode of stiffness (1 + gamma) K. With damping of either
/// kind the wall is thus stable while
///   sqrt(1 + gamma) omega_max <= 2
/// (test: it grows just above and stays bounded just below). The masses that load_lane chooses
/// keep the step below this limit by the bound of block_element.hpp; the functions here measure
/// how far below.
///
/// This analysis has an end: a contact that opens and closes at speed v gets its kick in one
/// step, v' = v (1 - k x) with k = (1 + gamma) omega^2 and the depth x v anywhere in (0, v]. On
/// average over x, v'^2 / v^2 = ((k - 1)^3 + 1) / (3 k), above 1 for k > 3: beyond 0.87 of the
/// limit a rebound makes energy. Damping elsewhere in the wall outweighs it from gamma = 0.5
/// on, and mostly from 0.2 (docs/bench/stability/stability.md). Where it does not, the energy
/// balance tells.

#include "dem/solver/state/solver_options.hpp"
#include "dem/solver/state/wall_state.hpp"

#include <Eigen/Core>

#include <vector>

namespace dem {

/// A matrix R with R R^T = M^-1. Masses of rigid motions may be coupled in each block.
struct MassRoots {
    std::vector<double> modes; ///< by mode: 1 / sqrt(mass), or 1 of a mode of `rigid`
    struct Rigid {
        int first_mode = 0;
        Eigen::Matrix3d root; ///< R of three modes
    };
    std::vector<Rigid> rigid;
};

/// omega_max, too small by at most 1e-3 of itself. Lanczos iteration without
/// reorthogonalisation: copies of the largest eigenvalue do no harm. NaN if numbers of the wall
/// are out of range.
/// @param state one unloaded wall; it is left unchanged
[[nodiscard]] double largest_frequency(const StepTables& tables, const MassRoots& roots,
                                       WallState<double>& state);
/// The same with the masses of the state [1/step].
[[nodiscard]] double largest_frequency(const StepTables& tables, WallState<double>& state);

/// Time step of this wall over the largest stable one [-], with the damping of the options.
/// Divide by sqrt(1 + damping_factor) to relate it to the largest stable step without damping.
[[nodiscard]] double step_over_limit(const StepTables& tables, WallState<double>& state,
                                     const SolverOptions& options);
[[nodiscard]] double step_over_limit(const Model& model, const WallMaterials& wall,
                                     const SolverOptions& options);

} // namespace dem
