#pragma once
/// Cycles side by side: of pushes to and fro and of measured loops, read by the same rules.

#include "app/compare/compared.hpp"
#include "app/output/table/table.hpp"
#include "fragility/curve/cyclic_curve.hpp"

#include <string>
#include <vector>

namespace app {

/// Cycles of a path. Measured displacements may jitter about zero, which begins no cycle.
[[nodiscard]] std::vector<fragility::Cycle> compared_cycles(const Compared& c);

/// One row for each cycle of those that go to and fro; no rows where none does.
[[nodiscard]] Table compared_cycle_table(const std::vector<Compared>& all);

/// The key of a study that pushes a wall along a measured path to and fro, from turn to turn:
/// "load.targets = 2, -2, 4, -4, 0 mm"; empty for other curves.
[[nodiscard]] std::string targets_along(const Compared& c);

} // namespace app
