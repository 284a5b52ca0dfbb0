#pragma once
/// `drystone report`: one page from a study's file.

#include "app/input/command_line.hpp"

namespace app {

/// @return exit code 0
/// @throws StoreError; ConfigError; std::runtime_error if the page cannot be written
[[nodiscard]] int report_command(const Command& command);

} // namespace app
