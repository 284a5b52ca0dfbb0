#pragma once
/// Small probabilities of walls, by active learning and by subset simulation.

#include "app/output/table.hpp"

namespace active_bench {

[[nodiscard]] app::Table wall_table();

} // namespace active_bench
