#pragma once
/// Effects of what the paper leaves open: one choice changed at a time, the same samples.

#include "app/output/table/table.hpp"
#include "bench/validation/level_statistics.hpp"

#include <filesystem>

namespace bench {

/// A row per choice whose study is in `folder` (bench/validation.sh), changes against the study
/// with our choices; then the thresholds of the mode rule, read again from that study.
/// @throws std::runtime_error naming a study that is missing
[[nodiscard]] app::Table effects_table(const app::StudyWalls& base,
                                       const std::filesystem::path& folder);

} // namespace bench
