#pragma once
/// Findings of the accuracy campaign, as tables.

#include "app/output/table/table.hpp"
#include "bench/accuracy/accuracy_errors.hpp"

#include <vector>

namespace bench {

/// One row for each scene.
[[nodiscard]] app::Table scene_table(const std::vector<ComparedScene>& scenes);
/// Errors of all scenes and of groups of them.
[[nodiscard]] app::Table error_table(const std::vector<ComparedScene>& scenes);
[[nodiscard]] app::Table worst_table(const std::vector<ComparedScene>& scenes);
/// Scenes that are not in the errors, or only partly, and why.
[[nodiscard]] app::Table apart_table(const std::vector<ComparedScene>& scenes);

} // namespace bench
