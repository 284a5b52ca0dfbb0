#pragma once
/// `drystone curves`: all capacity curves of a study as one CSV.

#include "app/input/command.hpp"

namespace app {

/// Columns level, vertical_stress_MPa, sample, displacement_mm, force_kN; one line per point, wall by wall.
/// @return exit code
/// @throws StoreError, std::runtime_error
[[nodiscard]] int curves_command(const Command& command);

} // namespace app
