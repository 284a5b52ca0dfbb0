#pragma once
/// How many samples are enough: the stopping rule of a study.

#include "app/study/stored/study_walls.hpp"

#include <cstdint>
#include <string>

namespace app {

struct StoppingState {
    std::uint32_t next = 0; ///< samples to have at the next look; 0: enough
    std::string
        remark; ///< one line per stress level: how narrow its interval is, and why it stops
};

/// State of stopping by the walls in the file, level by level; the level that needs most
/// decides. A shard cannot know: the rule is for whole studies.
[[nodiscard]] StoppingState stopping_state(const StudyWalls& walls);

} // namespace app
