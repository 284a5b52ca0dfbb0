#pragma once
/// Fragility curves and mode probabilities for the page.

#include "app/fragility/fragility_data.hpp"
#include "app/study/study_walls.hpp"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace app {

/// P(limit state reached | drift) of each limit state and stress, as in the pictures of `drystone fragility`:
/// [{"name", "rule", "curves": [{"level", "drift": [...], "least", "most", "lower", "upper", "fitted",
///   "steps": [[drift, probability], ...], "known_to"}]}]
[[nodiscard]] nlohmann::ordered_json fragility_json(const DriftData& data);

/// Share of rocking walls of each stress with its interval, and a logistic regression on the stress:
/// {"levels": [{"stress" [MPa], "value", "lower", "upper", "walls"}],
///  "model": {"stress", "value", "lower", "upper"}, "note": text}; no "model" below two stresses, or if it
/// does not fit the shares, which the note says.
[[nodiscard]] nlohmann::ordered_json modes_json(const StudyWalls& study);

} // namespace app
