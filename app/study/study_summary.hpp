#pragma once
/// What a study found, at a glance: one row per stress level.

#include "app/output/table.hpp"
#include "app/study/study_walls.hpp"

#include <cstddef>
#include <string>

namespace app {

constexpr const char* kSummaryTitle = "Results by stress";

struct StudySummary {
    Table table;
    std::string remarks; ///< lines: walls that failed and why, walls still to run
    std::size_t failed = 0, missing = 0;
};

[[nodiscard]] StudySummary summarise(const StudyWalls& walls);

} // namespace app
