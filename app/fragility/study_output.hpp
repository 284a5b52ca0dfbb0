#pragma once
/// Tables, curves and pictures of drift limits: of a study, or of drifts that a user brings.

#include "app/fragility/numbers/drift_fits.hpp"
#include "app/fragility/numbers/fragility_data.hpp"
#include "app/fragility/numbers/fragility_output.hpp"
#include "app/study/stored/study_walls.hpp"

namespace app {

/// Tables, curves and pictures that need drifts alone.
[[nodiscard]] FragilityOutput drift_output(DriftData data, const FitProgress& seen = {});

/// Tables, curves and pictures of a study: those of its drifts, and what its walls tell beside.
[[nodiscard]] FragilityOutput study_output(const StudyWalls& walls,
                                           const FitProgress& seen = {});

} // namespace app
