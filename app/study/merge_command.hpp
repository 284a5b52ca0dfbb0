#pragma once
/// `drystone merge`: shards of one study into one file.

#include "app/input/command.hpp"

namespace app {

/// @return exit code: 0 all walls there, none failed; 1 some failed, or missing with --partial
/// @throws StoreError
[[nodiscard]] int merge_command(const Command& command);

} // namespace app
