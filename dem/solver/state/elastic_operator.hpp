#pragma once
/// The stiffness of a wall in which nothing opens, slips or cracks, applied without forming a
/// matrix.

#include "dem/solver/state/wall_state.hpp"

#include <vector>

namespace dem {

/// Relative displacements (normal, tangential) of the contacts [m], from the modes.
void stretch(const StepTables& tables, const std::vector<double>& q, std::vector<double>& du);

/// (k_n du_n, k_s du_s) of all contacts [Pa].
void elastic_stress(const StepTables& tables, const WallState<double>& state,
                    const std::vector<double>& du, std::vector<double>& stress);

/// K q of blocks and contacts. The displacements and stresses of the contacts remain in the
/// state.
void apply_stiffness(const StepTables& tables, const std::vector<double>& q,
                     WallState<double>& state, std::vector<double>& kq);

[[nodiscard]] double dot(const std::vector<double>& a, const std::vector<double>& b);

} // namespace dem
