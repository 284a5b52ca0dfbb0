#pragma once
/// `drystone study`: all walls of a study into one file.

#include "app/input/command.hpp"
#include "app/study/pushed/wall_frames.hpp"

namespace app {

/// @param frames of the walls that this run pushes
/// @return exit code: 0 no wall failed; 1 some failed
/// @throws Interrupted once the walls that are finished are in the file
/// @throws ConfigError, StoreError
[[nodiscard]] int study_command(const Command& command, const FrameTaker& frames = {});

} // namespace app
