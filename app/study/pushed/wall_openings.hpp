#pragma once
/// Doors and windows of a wall, given in courses or found in a drawing.

#include "dem/scene/drawn_layout.hpp"
#include "dem/scene/wall.hpp"

#include <vector>

namespace app {

struct Masonry;

/// Gaps between the stones at a height, from left to right [m].
struct Gap {
    double from = 0.0, to = 0.0;
    [[nodiscard]] double width() const { return to - from; }
};

/// Gaps of a drawn wall that are wider than `least` [m].
[[nodiscard]] std::vector<Gap> gaps_at(const std::vector<dem::DrawnUnit>& units, double z,
                                       double least);

/// Width above which a gap is an opening and no joint [m].
[[nodiscard]] double least_opening(const Masonry& masonry);

/// Openings of a wall in courses as they are given. Of a drawn wall the gaps that lie above
/// each other, each as the rectangle of its mean width. None of rubble.
[[nodiscard]] std::vector<dem::Opening> wall_openings(const Masonry& masonry);

} // namespace app
