#pragma once
/// Findings of a study, at a glance: one row per stress level.

#include "app/output/table/table.hpp"
#include "app/study/stored/study_walls.hpp"

#include <cstddef>
#include <string>

namespace app {

constexpr const char* kSummaryTitle = "Results by stress";

struct StudySummary {
    Table table;
    std::string remarks; ///< study_remarks
    std::size_t failed = 0, missing = 0;
};

[[nodiscard]] StudySummary summarise(const StudyWalls& walls);

/// The remarks on a study wherever it is summed up, one sentence a line: walls that failed and
/// why, walls still to run, and what leaves its walls without a limit of their own.
[[nodiscard]] std::string study_remarks(const StudyWalls& walls);

} // namespace app
