#pragma once
/// Scenes far from the paper, to see what error the speed of the drive leaves in a push.

#include "app/input/study/study.hpp"

#include <cstdint>
#include <span>
#include <string>

namespace bench {

struct AccuracyScene {
    std::uint64_t number = 0;
    std::string text; ///< a study file, which `drystone push` takes as it is
    std::string kind; ///< of the wall: "courses", "opening", "drawing", "arch", "rubble"
    /// Name of what pushes and how the vertical load follows: "stress", "own weight", "body",
    /// "body, beam", "fixed_line", "follower", "link", "level beam".
    std::string load;
    std::string extras; ///< of "mortar", "crushing", "wear", "cracks", those that the wall has
    int stones = 0;     ///< roughly
};

/// Scene `number` of the campaign of this seed: the same on every machine. A draw that the
/// input refuses is drawn again.
[[nodiscard]] AccuracyScene accuracy_scene(std::uint64_t seed, std::uint64_t number);

/// @param overrides section.key=value in place of its own
/// @throws app::ConfigError
[[nodiscard]] app::Study study_of(const AccuracyScene& scene,
                                  std::span<const std::string> overrides = {});

} // namespace bench
