#pragma once
/// Drift limits of the walls of a study of histories when they are pushed.

#include "app/input/prepared_study.hpp"
#include "app/sampling/sample_plan.hpp"
#include "app/store/store_row.hpp"

#include <map>
#include <vector>

namespace app {

/// Ultimate drift of each wall [-], or the drift at which its push ended before; walls whose
/// push failed are left out.
/// @param walls their samples are numbers of walls
/// @throws Interrupted
[[nodiscard]] std::map<WallKey, double> pushed_limits(const PreparedStudy& ready,
                                                      const SamplePlan& samples,
                                                      const std::vector<WallKey>& walls,
                                                      int threads);

} // namespace app
