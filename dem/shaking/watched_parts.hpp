#pragma once
/// The parts of a wall that a history watches: its top, its foot, and how far it has turned.

#include "dem/shaking/true_masses.hpp"
#include "dem/solver/state/wall_state.hpp"

#include <vector>

namespace dem {

struct Layout;

/// The blocks whose displacement is told: the beam, or the top course.
[[nodiscard]] std::vector<int> top_of(const Model& model);

/// Bed joints between blocks that the ground holds, or itself, and those that move.
[[nodiscard]] std::vector<ContactRun> foot_of(const StepTables& tables,
                                              const std::vector<BlockMass>& masses);

/// Share of the area of these contacts that is open [-].
template <class Real>
[[nodiscard]] double open_share(const StepTables& tables, const std::vector<ContactRun>& runs,
                                const WallState<Real>& state, int lane);

/// Whether the wall, in the mean by mass, has turned past length over height.
template <class Real>
[[nodiscard]] bool overturned(const Layout& layout, const std::vector<BlockMass>& masses,
                              const FiniteState<Real>& state, int lane);

} // namespace dem
