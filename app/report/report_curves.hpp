#pragma once
/// Capacity curves for the page: of each wall, and their means.

#include "app/report/report_study.hpp"
#include "app/study/resampled_curve.hpp"

#include <nlohmann/json_fwd.hpp>

#include <cstddef>
#include <vector>

namespace app {

/// Evenly from 0 to the largest displacement; fewer where there are more walls than kManyWalls.
constexpr std::size_t kCurvePoints = 601, kFewCurvePoints = 301;
constexpr std::size_t kManyWalls = 1'000;
constexpr std::size_t kMeanPoints = 301; ///< of the means, likewise

/// {"step": [m], "points", "force_step": [N], "counts": points of each wall, "data": base64 of a zlib
/// stream of differences() of order 1, one series of `points` for each wall}.
/// @param listed places in ReportStudy::walls
[[nodiscard]] nlohmann::ordered_json curves_json(const ReportStudy& study,
                                                 const std::vector<std::size_t>& listed);

/// Mean force of the walls of one stress, and of each mode of it, with 95 % intervals of the mean, in
/// kN: [{"level", "mode": "all" | "rocking" | "mixed", "walls", "step", "mean", "lower", "upper"}]. Ends
/// where fewer than kMeanNeedsShare of the walls go on: the rest are not a fair sample.
[[nodiscard]] nlohmann::ordered_json mean_curves_json(const ReportStudy& study);

} // namespace app
