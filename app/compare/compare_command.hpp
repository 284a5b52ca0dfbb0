#pragma once
#include "app/input/command.hpp"

namespace app {

/// `drystone compare`: studies, pushes and measured curves in one table (compare.csv, .md,
/// .tex), one chart (compare.svg) and one page (compare.html).
[[nodiscard]] int compare_command(const Command& command);

} // namespace app
