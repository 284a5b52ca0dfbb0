#pragma once
/// `drystone fragility FILE.h5`, or of a CSV: tables, curves and pictures in a folder.

#include "app/fragility/fragility_data.hpp"
#include "app/fragility/fragility_output.hpp"
#include "app/input/command.hpp"
#include "app/study/study_walls.hpp"

namespace app {

/// Tables, curves and pictures that need drifts alone.
[[nodiscard]] FragilityOutput drift_output(DriftData data);

/// The same of a study, and what its walls tell beyond.
[[nodiscard]] FragilityOutput study_output(const StudyWalls& walls);

/// @return exit code
/// @throws ConfigError, StoreError, std::runtime_error
int fragility_command(const Command& command);

} // namespace app
