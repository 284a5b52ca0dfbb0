#pragma once
/// What was drawn, and how well it stands for its distributions.

#include "app/study/study_walls.hpp"

#include <nlohmann/json_fwd.hpp>

namespace app {

/// Of each input: histogram of its values over all walls and joints as a density, and the prescribed
/// density, in shown units:
/// [{"key", "unit", "values", "edges": [...], "density": [...], "x": [...], "pdf": [...],
///   "prescribed": "mean 31.8, sd 6.36", "sampled": "mean 31.8, sd 6.31"}]
[[nodiscard]] nlohmann::ordered_json histograms_json(const StudyWalls& study);

constexpr std::size_t kMostRunning = 2'000; ///< walls of a stress in its running means

/// Error of the mean after j walls in percent, of each input against its prescribed mean and of the
/// peak force against the mean of all, with 95 % bands of independent samples:
/// [{"level", "key", "error": [...], "band": [...]}].
[[nodiscard]] nlohmann::ordered_json running_json(const StudyWalls& study);

/// Rank correlation (Spearman) and partial rank correlation of the peak force and of the observed
/// ultimate displacement with each input, 95 % intervals:
/// [{"level", "response", "walls", "bars": [{"key", "spearman": [v, lo, up], "prcc": [v, lo, up]}]}];
/// empty lists where there are too few walls.
[[nodiscard]] nlohmann::ordered_json sensitivity_json(const StudyWalls& study);

} // namespace app
