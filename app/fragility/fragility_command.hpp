#pragma once
/// `drystone fragility FILE.h5`, or of a CSV: tables, curves and pictures in a folder.

#include "app/fragility/numbers/drift_fits.hpp"
#include "app/fragility/numbers/fragility_data.hpp"
#include "app/fragility/numbers/fragility_output.hpp"
#include "app/input/command.hpp"
#include "app/study/stored/study_walls.hpp"

namespace app {

/// Tables, curves and pictures that need drifts alone.
[[nodiscard]] FragilityOutput drift_output(DriftData data, const FitProgress& seen = {});

/// The same of a study, and what its walls tell beyond.
[[nodiscard]] FragilityOutput study_output(const StudyWalls& walls,
                                           const FitProgress& seen = {});

/// Asks before a run what the tables would refuse after it.
/// @throws ConfigError if a file of theirs is there and is from no earlier run
void check_fragility(const Command& command);

/// @return exit code
/// @throws ConfigError, StoreError, std::runtime_error
int fragility_command(const Command& command);

} // namespace app
