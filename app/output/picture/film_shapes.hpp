#pragma once
/// The moving parts of a film: stones, gaps and cracks as shapes whose corners go from frame to
/// frame.

#include "app/output/picture/wall_body.hpp"
#include "app/output/picture/wall_view.hpp"
#include "dem/scene/geometry/snapshot.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace app {

/// The last frame is held for 1/kFilmHold of the others.
constexpr std::size_t kFilmHold = 5;

struct MovingWall {
    std::vector<const dem::Snapshot*> frames; ///< two or more
    WallView view;
    std::string clock; ///< attributes that all motions share
};

/// Values of an attribute over the frames, with the last held; nothing where they are all the
/// same.
[[nodiscard]] std::string svg_motion(const MovingWall& film, std::string_view name,
                                     const std::vector<std::string>& values,
                                     std::string_view how = {});

/// Gaps, stones and cracks, the gaps lowest.
[[nodiscard]] std::string moving_wall(const MovingWall& film, const StoneTints& tints);

} // namespace app
