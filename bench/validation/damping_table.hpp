#pragma once
/// The paper beside our walls with its damping and with the default of the program.

#include "app/output/table/table.hpp"
#include "bench/validation/level_statistics.hpp"

#include <vector>

namespace bench {

[[nodiscard]] app::Table damping_table(const std::vector<LevelStatistics>& local,
                                       const std::vector<LevelStatistics>& combined);

} // namespace bench
