#pragma once
/// `drystone study STUDY.ini --slurm FILE`: a job array instead of a run.

#include "app/input/command.hpp"
#include "app/input/prepared_study.hpp"

namespace app {

/// Runs one register of walls to know what a wall takes.
/// @return exit code
/// @throws ConfigError
[[nodiscard]] int write_slurm_script(const PreparedStudy& ready, const Command& command);

} // namespace app
