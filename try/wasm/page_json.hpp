#pragma once
/// Everything that the page shows, as JSON.

#include "app/input/prepared_study.hpp"
#include "app/study/pushed/pushed_wall.hpp"
#include "app/text/json_text.hpp"
#include "dem/scene/geometry/snapshot.hpp"

#include <vector>

namespace page {

/// Name, section, unit, range, words, default and meaning of each key that a push reads.
[[nodiscard]] app::Json keys_json();

/// Corners of the stones, cracks in them, the line of the load; the study in full and notes on
/// it.
[[nodiscard]] app::Json scene_json(const app::PreparedStudy& ready);

/// The blocks of a push with all points of their outlines, and its faces with their points
/// there.
[[nodiscard]] app::Json moving_scene_json(const dem::Snapshot& wall);

/// For each point of this scene its displacement [m], x and z in turn; then for each face the
/// least damage of its contacts, their largest opening [m] and slip [m].
[[nodiscard]] std::vector<float> movement_of(const dem::Snapshot& wall);

/// Displacements [mm] and forces [kN].
[[nodiscard]] app::Json curve_json(const app::PushedWall& wall);

/// Each limit state with its drift [%], and whether the wall reached it.
[[nodiscard]] app::Json limits_json(const app::Study& study, const app::WallReading& reading,
                                    double height);

/// One wall of many: its peak, curve and limits.
[[nodiscard]] app::Json wall_json(const app::Study& study, int sample,
                                  const app::PushedWall& wall);

/// A lognormal law with its band, and the shares of walls without a law.
/// @param drifts {"observed": [...], "censored": [...], "capped": [...]} [%]
[[nodiscard]] app::Json fit_json(const app::Json& drifts);

} // namespace page
