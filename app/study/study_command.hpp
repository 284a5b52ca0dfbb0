#pragma once
/// `drystone study`: all walls of a study into one file.

#include "app/input/command_line.hpp"

namespace app {

/// @return exit code: 0 all walls there, none failed; 1 some failed, or interrupted
/// @throws ConfigError, StoreError
[[nodiscard]] int study_command(const Command& command);

} // namespace app
