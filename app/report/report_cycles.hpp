#pragma once
/// Cycles of a push to and fro for the page: the loops of each wall, and damping over drift.

#include "app/report/report_choice.hpp"

#include <nlohmann/json_fwd.hpp>

namespace app {

constexpr int kLoopPoints = 4; ///< from one frame of a film to the next

/// Paths evenly along their way, kLoopPoints points to a frame of a film: {"per_frame", "points", "step" [m],
/// "force_step" [N], "counts": points of each wall, "data": base64 of a zlib stream of differences() of order 1, one
/// series of `points` displacements and one of forces for each wall}. Null for a push that goes one way.
[[nodiscard]] nlohmann::ordered_json loops_json(const StudyWalls& study,
                                                const WallList& listed);

/// The means of fragility_cycles.hpp: [{"level", "mode": "all" | "rocking" | ..., "walls" [-], "drift" [%], "damping" [%],
/// "lower", "upper"}].
[[nodiscard]] nlohmann::ordered_json damping_json(const StudyWalls& study);

} // namespace app
