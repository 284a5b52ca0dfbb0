#pragma once
/// Small probabilities of walls, by active learning and by subset simulation.

#include "app/output/table/table.hpp"

#include <functional>

namespace active_bench {

/// @param seen gets the table after each event, which takes minutes
void wall_table(const std::function<void(const app::Table&)>& seen);

} // namespace active_bench
