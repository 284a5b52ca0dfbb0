#pragma once
/// `drystone sample`: the samples of a study as a table, without running a wall.

#include "app/input/command.hpp"

namespace app {

/// @return exit code
/// @throws ConfigError, StoreError
[[nodiscard]] int sample_command(const Command& command);

} // namespace app
