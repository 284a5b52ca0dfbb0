#pragma once
/// `drystone study`: all walls of a study into one file.

#include "app/input/command.hpp"
#include "app/study/wall_frames.hpp"

namespace app {

/// @param frames of the walls that this run pushes
/// @return exit code: 0 all walls there, none failed; 1 some failed, or interrupted
/// @throws ConfigError, StoreError
[[nodiscard]] int study_command(const Command& command, const FrameTaker& frames = {});

} // namespace app
