#pragma once
/// Capacity curves for the page: of each wall, and their means.

#include "app/report/report_choice.hpp"

#include <nlohmann/json_fwd.hpp>

#include <cstddef>
#include <vector>

namespace app {

/// Evenly from 0 to the largest displacement; fewer where there are more walls than kManyWalls.
constexpr std::size_t kCurvePoints = 601, kFewCurvePoints = 301;
constexpr std::size_t kManyWalls = 1'000;

/// {"step": [m], "points", "force_step": [N], "counts": points of each wall, "data": base64 of a zlib
/// stream of differences() of order 1, one series of `points` for each wall}.
[[nodiscard]] nlohmann::ordered_json curves_json(const StudyWalls& study,
                                                 const WallList& listed);

/// The means of fragility_means.hpp, in kN, of two walls and more:
/// [{"level", "mode": "all" | "rocking" | "mixed", "walls", "step" [m], "mean", "lower", "upper"}].
[[nodiscard]] nlohmann::ordered_json mean_curves_json(const StudyWalls& study);

} // namespace app
