#pragma once
/// `drystone fragility FILE.h5`, or of a CSV: tables, curves and pictures in a folder.

#include "app/input/command.hpp"

namespace app {

/// Checks before a run that the tables replace nothing of others.
/// @throws ConfigError if a file of theirs is there and is from no earlier run
void check_fragility(const Command& command);

/// @return exit code
/// @throws ConfigError, StoreError, std::runtime_error
int fragility_command(const Command& command);

} // namespace app
