#pragma once
/// `drystone serve`: the walls of a study over HTTP, for any program that speaks UM-Bridge.

#include "app/input/command.hpp"

namespace app {

/// Serves until it is told to end (Ctrl-C, SIGTERM).
/// @return exit code
/// @throws ConfigError; std::runtime_error if the port is taken
[[nodiscard]] int serve_command(const Command& command);

} // namespace app
