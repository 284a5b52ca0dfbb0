#pragma once
/// Numbers that a study keeps of a history, and its row.

#include "app/sampling/wall_draw.hpp"
#include "app/shake/history_plan.hpp"
#include "app/store/store_row.hpp"
#include "dem/shaking/shake.hpp"

#include <limits>
#include <string>
#include <vector>

namespace app {

/// A wall that was shaken, or could not be made.
struct ShakenHistory {
    HistoryOf of;
    ShakingMotion motion;
    dem::ShakeResult result;
    std::string no_wall;  ///< why its values make no wall; empty: they do
    double seconds = 0.0; ///< of one core
    double pushed_limit =
        std::numeric_limits<double>::quiet_NaN(); ///< ultimate drift of its push [-]
};

[[nodiscard]] std::vector<Column> history_responses(const HistoryPlan& plan);
[[nodiscard]] std::vector<Column> history_counts();

/// A row without a curve. Histories that failed keep their outcome and reason, and no numbers.
[[nodiscard]] WallRow history_row(WallKey key, const WallDraw& draw, const HistoryPlan& plan,
                                  const ShakenHistory& history);

/// Whether its numbers broke, the wall did not stand at rest, or there was none.
[[nodiscard]] bool failed(const ShakenHistory& history);

} // namespace app
