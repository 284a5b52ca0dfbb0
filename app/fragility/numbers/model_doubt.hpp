#pragma once
/// Tables of what is printed last: limit drifts and peak forces with the error of the model.

#include "app/fragility/numbers/fragility_data.hpp"
#include "app/output/table/table.hpp"
#include "app/study/stored/study_walls.hpp"
#include "fragility/limits/model_factor.hpp"

#include <cstddef>
#include <optional>

namespace app {

/// A limit drift with the doubt of the model: of one law of all walls where it gives all their
/// drifts, and of the shares observed where these come from a mixture, two heaps or the shares;
/// of walls that no law can be fitted to, the bound of their median alone. Nothing where the
/// walls tell nothing, or where a drift limit of a code, of a pier or of the user comes first.
[[nodiscard]] std::optional<fragility::DoubtedLimit>
doubted_limit(const DriftData& data, std::size_t group, std::size_t state);

/// Median, 16 and 84 % drift of a further wall per group and limit state, and the dispersion in
/// its parts.
[[nodiscard]] Table drift_doubt_table(const DriftData& data);

/// The same of the peak forces under each stress.
[[nodiscard]] Table force_doubt_table(const StudyWalls& walls);

} // namespace app
