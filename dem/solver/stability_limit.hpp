#pragma once
/// How far the time step is from the one that is not stable any more, measured.
///
/// Leapfrog with a unit step is stable while omega_max <= 2, omega_max^2 the largest eigenvalue of
/// M^-1 K: fastest is the wall with all contacts closed, sticking and uncracked. At the limit a
/// mode changes sign in every step, q_n = (-1)^n a. Its force F_n = -omega^2 m q_n then opposes the
/// velocity that led there and has the sign of its own change F_n - F_(n-1): local damping adds
/// gamma |F| to it, combined damping adds both its halves, and every step is one of an undamped
/// mode of stiffness (1 + gamma) K. With damping of either kind the wall is thus stable while
///   sqrt(1 + gamma) omega_max <= 2
/// (test: growing just above, bounded just below). The masses of load_lane keep step_fraction
/// below 1 of this by the bound of block_element.hpp; here is what it is of the true limit.
///
/// Where it stops holding: a contact that opens and closes at speed v gets its kick in one step,
/// v' = v (1 - k x) with k = (1 + gamma) omega^2 and the depth x v anywhere in (0, v]. On average over x,
/// v'^2 / v^2 = ((k - 1)^3 + 1) / (3 k), above 1 for k > 3: beyond 0.87 of the limit a rebound makes
/// energy. Damping elsewhere in the wall outweighs it from gamma = 0.5 on, and mostly from 0.2
/// (docs/bench/stability.md); where it does not, the ledger tells.

#include "dem/solver/solver_options.hpp"
#include "dem/solver/wall_state.hpp"

namespace dem {

/// omega_max [1/step], at most 1e-3 of itself too small: Lanczos iteration without reorthogonalisation
/// (copies of the largest eigenvalue do no harm). NaN where the wall has numbers out of range.
/// @param state one unloaded wall; unchanged
[[nodiscard]] double largest_frequency(const StepTables& tables, WallState<double>& state);

/// Time step of this wall over the largest stable one [-], with the damping of the options.
/// Over the largest stable one without damping: divide by sqrt(1 + damping_factor).
[[nodiscard]] double step_over_limit(const StepTables& tables, WallState<double>& state,
                                     const SolverOptions& options);
[[nodiscard]] double step_over_limit(const Model& model, const WallMaterials& wall,
                                     const SolverOptions& options);

} // namespace dem
