#pragma once
/// `drystone reliability`: the probability of an event, with its doubt and what it depends on.

#include "app/input/command.hpp"

namespace app {

/// @return exit code: 0 an answer; 1 none
/// @throws ConfigError
[[nodiscard]] int reliability_command(const Command& command);

} // namespace app
