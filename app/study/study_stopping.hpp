#pragma once
/// How many samples are enough: the stopping rule of a study.

#include "app/input/study.hpp"

#include <cstdint>
#include <filesystem>
#include <string>

namespace app {

struct StoppingState {
    std::uint32_t next = 0; ///< samples to have at the next look; 0: enough
    std::string
        remark; ///< one line per stress level: how narrow its interval is, and why it stops
};

/// What the walls in the file say, level by level; the level that needs most decides. A shard cannot know:
/// the rule is for whole studies.
/// @throws StoreError
[[nodiscard]] StoppingState stopping_state(const Study& study,
                                           const std::filesystem::path& file);

} // namespace app
