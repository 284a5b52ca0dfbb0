#pragma once
/// The parts of the page that report_data() puts together.

#include "app/fragility/numbers/fragility_data.hpp"
#include "app/output/table/table.hpp"
#include "app/report/report_choice.hpp"
#include "app/study/stored/study_walls.hpp"

#include <nlohmann/json_fwd.hpp>

#include <cstddef>
#include <string>
#include <vector>

namespace app {

struct Overview {
    std::string lead;                          ///< the answer in a sentence or two
    std::vector<std::string> run, found, sure; ///< plain text
};
[[nodiscard]] Overview overview(const StudyWalls& study);

/// The answer as a table, of six stresses at most: mean peak force, shares of the modes, and
/// the median drift of each limit state by the observed shares (Kaplan-Meier): {"head": [...],
/// "rows": [[...]], "note"}, all texts.
[[nodiscard]] nlohmann::ordered_json answers_json(const StudyWalls& study,
                                                  const DriftData& data);

/// "normal(mean 35 deg, cov 0.15)": "normal, mean 35 deg, coefficient of variation 0.15"
[[nodiscard]] std::string distribution_words(const std::string& text);

/// Stone, joints, units, beam: each value that matters with its unit, its distribution where it
/// was drawn, what it means, and whether the study file gives it.
[[nodiscard]] Table material_table(const StudyWalls& study);

/// The choices that move a drift limit, and how each of them does in this study.
[[nodiscard]] Table choice_table(const StudyWalls& study);

/// The same of geometry, supports and loads.
[[nodiscard]] Table wall_and_load_table(const StudyWalls& study);

/// Histogram of the values of each input over all walls and joints as a density, and the
/// prescribed density, in shown units: [{"key", "unit", "values", "edges": [...], "density":
/// [...], "x": [...], "pdf": [...],
///   "prescribed": "mean 31.8, sd 6.36", "sampled": "mean 31.8, sd 6.31"}]
[[nodiscard]] nlohmann::ordered_json histograms_json(const StudyWalls& study);

constexpr std::size_t kMostRunning = 2'000; ///< walls of a stress in its running means

/// Error of the mean after j walls in percent, of each input against its prescribed mean and of
/// the peak force against the mean of all, with 95 % bands of independent samples: [{"level",
/// "key", "error": [...], "band": [...]}].
[[nodiscard]] nlohmann::ordered_json running_json(const StudyWalls& study);

/// Rank correlation (Spearman) and partial rank correlation of the peak force and of the
/// observed ultimate displacement with each input, 95 % intervals: [{"level", "response",
/// "walls", "bars": [{"key", "spearman": [v, lo, up], "prcc": [v, lo, up]}]}]; empty lists
/// where there are too few walls.
[[nodiscard]] nlohmann::ordered_json sensitivity_json(const StudyWalls& study);

/// Evenly from 0 to the largest displacement; fewer where there are more walls than kManyWalls.
constexpr std::size_t kCurvePoints = 601, kFewCurvePoints = 301;
constexpr std::size_t kManyWalls = 1'000;

/// {"step": [m], "points", "force_step": [N], "counts": points of each wall, "data": base64 of
/// a zlib stream of differences() of order 1, one series of `points` for each wall}.
[[nodiscard]] nlohmann::ordered_json curves_json(const StudyWalls& study,
                                                 const WallList& listed);

/// The means of fragility_means.hpp, in kN, of two walls and more: [{"level", "mode": "all" |
/// "rocking" | "mixed", "walls", "step" [m], "mean", "lower", "upper"}].
[[nodiscard]] nlohmann::ordered_json mean_curves_json(const StudyWalls& study);

constexpr int kLoopPoints = 4; ///< from one frame of a film to the next

/// Paths evenly along their way, kLoopPoints points to a frame of a film: {"per_frame",
/// "points", "step" [m], "force_step" [N], "counts": points of each wall, "data": base64 of a
/// zlib stream of differences() of order 1, one series of `points` displacements and one of
/// forces for each wall}. Null for a push that goes one way.
[[nodiscard]] nlohmann::ordered_json loops_json(const StudyWalls& study,
                                                const WallList& listed);

/// The means of fragility_cycles.hpp: [{"level", "mode": "all" | "rocking" | ..., "walls" [-],
/// "drift" [%], "damping" [%], "lower", "upper"}].
[[nodiscard]] nlohmann::ordered_json damping_json(const StudyWalls& study);

/// P(limit state reached | drift) of each limit state and stress, as in the pictures of
/// `drystone fragility`: [{"name", "rule", "curves": [{"level", "drift": [...], "least",
/// "most", "lower", "upper", "fitted",
///   "steps": [[drift, probability], ...], "known_to"}]}]; where walls reached a drift limit
///   that is set and nothing else,
/// "limit" says it in words and there is no curve.
[[nodiscard]] nlohmann::ordered_json fragility_json(const DriftData& data);

/// Share of rocking walls of each stress with its interval, and a logistic regression on the
/// stress: {"levels": [{"stress" [MPa], "value", "lower", "upper", "walls"}],
///  "model": {"stress", "value", "lower", "upper"}, "note": text}; no "model" below two
///  stresses, or if it
/// does not fit the shares, which the note says.
[[nodiscard]] nlohmann::ordered_json modes_json(const StudyWalls& study);

/// Walls of a stress that the page's surrogates are learned from (choice): those of
/// `drystone surrogate` where a study has no more. A process of 200 walls is 12 kB of the page.
constexpr std::size_t kMostAskedWalls = 200;
constexpr std::size_t kAskedValues = 101; ///< places of a slider

/// Surrogates of peak force and ultimate drift, and the modes, of each stress, for the page's
/// sliders: {"none": why there are no sliders, "inputs": [{"key", "unit", "scale",
/// "coordinate", "values": [...], "coordinates": [...], "start"}], "share", "factor",
/// "responses": [{"name", "unit", "decimals", "levels": [...]}], "modes": [...]}; levels and
/// modes as in surrogate.json (docs/surrogates.md), the better surrogate alone, "left_out".
/// Sliders reach from the least to the most value of all walls of the study; coordinates are
/// those of their values.
[[nodiscard]] nlohmann::ordered_json whatif_json(const StudyWalls& study);

} // namespace app
