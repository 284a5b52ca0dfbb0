#pragma once
/// `drystone push`: every stress level of a study file, one wall each.

#include "app/input/command.hpp"

namespace app {

/// Writes, into command.out or a folder per stress level below it: capacity.csv, capacity.svg,
/// summary.json, wall.svg, study.ini (the effective configuration) and series/*.pvd for
/// ParaView, which are written while the wall is pushed. Several levels also give levels.csv, .md, .tex, .svg. Files of
/// an earlier push are removed.
/// @returns exit code: 0, or 1 if a wall's numbers broke
/// @throws ConfigError before anything is written
[[nodiscard]] int push_command(const Command& command);

} // namespace app
