#pragma once
/// Findings of the stress campaign, as tables.

#include "app/output/table/table.hpp"
#include "bench/stability/stress_run.hpp"

#include <vector>

namespace bench {

struct CampaignSums {
    int scenes = 0, walls = 0, broken_rules = 0;
    int compared_scenes = 0; ///< run again without their spoilt wall
    int beyond_bound = 0;    ///< walls that ended ok or collapsed with a step beyond the proof
    double over_limit = 0.0; ///< of these, the largest step over the measured limit [-]
    double residual = 0.0;   ///< largest of the walls called ok [-]
    double slowest = 0.0;    ///< scene [s] of one core
    double seconds = 0.0;    ///< of all scenes, of one core
    long long steps = 0;     ///< of all walls
    int alone = 0;           ///< walls pushed alone besides
    int on_the_way = 0;      ///< walls whose limit was measured on their way
    double most_on_the_way = 0.0; ///< of these, the largest step over the measured limit [-]
};
[[nodiscard]] CampaignSums sums_of(const std::vector<SceneReport>& scenes);

/// Outcomes of the walls, by what was asked of them.
[[nodiscard]] app::Table outcome_table(const std::vector<SceneReport>& scenes);

/// How often the step was halved, by outcome. Without spoilt walls.
[[nodiscard]] app::Table reduction_table(const std::vector<SceneReport>& scenes);

/// Share of walls whose step was halved though it was within the bound, by damping and step.
[[nodiscard]] app::Table within_bound_table(const std::vector<SceneReport>& scenes);

/// Walls that failed, spoilt ones apart, and rules that were broken: how many, and the scenes
/// to run again.
[[nodiscard]] app::Table failed_table(const std::vector<SceneReport>& scenes);

/// Step over the measured limit of the wall of the paper at default settings.
[[nodiscard]] app::Table limit_table();

} // namespace bench
