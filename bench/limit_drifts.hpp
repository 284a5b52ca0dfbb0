#pragma once
/// Where walls have lost 20 % of their force, or all of it: quantiles of the drift by Kaplan
/// and Meier with 95 % intervals, in which walls that stood longer than their push count as
/// that.

#include "app/output/table/table.hpp"
#include "app/study/stored/study_walls.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace bench {

[[nodiscard]] std::vector<app::Head> limit_head();

/// One stress of a study under the heads above. @param choice what the study differs in
[[nodiscard]] app::Row limit_row(const std::string& choice, const app::StudyWalls& study,
                                 std::size_t level);

/// By stress and mode, of a study that was pushed until no force was left; modes of five walls
/// or more.
[[nodiscard]] app::Table limits_by_mode(const app::StudyWalls& study);

} // namespace bench
