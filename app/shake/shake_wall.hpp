#pragma once
/// One wall of a study under each record and intensity.

#include "app/input/prepared_study.hpp"
#include "app/sampling/wall_draw.hpp"
#include "app/shake/shake_files.hpp"
#include "app/shake/shaking_motions.hpp"

#include <functional>
#include <vector>

namespace app {

/// The study in the layout of a sample, with displacements of any size.
/// @throws ConfigError where it asks for small ones
[[nodiscard]] PreparedStudy shaken_study(PreparedStudy ready, int sample);

/// Told how far all histories are [0 to 1], and how far the top is out in one of them [m]; may
/// throw Interrupted.
using ShakeProgress =
    std::function<void(const ShakingMotion& motion, double done, double displacement)>;

/// Shakes the wall under all motions side by side, in the lanes of a register.
/// @param ready as shaken_study gives it
/// @param frame_every time between the snapshots that are kept [s]; 0: none
/// @param finished takes each history, in the order of the motions, when all are there
/// @throws ConfigError where the wall cannot be shaken
void shake_wall(const PreparedStudy& ready, const WantedWall& wall,
                const std::vector<ShakingMotion>& motions, double frame_every,
                const ShakeProgress& seen, const std::function<void(ShakenWall&&)>& finished);

} // namespace app
