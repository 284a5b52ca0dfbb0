#pragma once
/// Where outlines touch.

#include "dem/scene/layout.hpp"

#include <utility>
#include <vector>

namespace dem {

/// Points closer than this, in x and in z, are one to a block, and a point closer than this to
/// a side is on it [m]. A touch lies within kTouching of the corners that it passes, and they
/// within kTouching of the sides of both blocks.
constexpr double kSamePlace = 3.0 * kTouching;

/// A common straight piece of the outlines of two blocks, a below or left of b.
struct Touch {
    int a = 0, b = 0;
    Point from, to; ///< left to right, or bottom to top where it is steeper than 45 degrees [m]
    Point normal;   ///< from a to b
};

/// Corners of a block, counter-clockwise.
[[nodiscard]] std::vector<Point> corners_of(const Block& block);

/// The level sides of a block at height z, as x from and to; `up` for its upper sides.
[[nodiscard]] std::vector<std::pair<double, double>> level_sides(const Block& block, double z,
                                                                 bool up);

/// Whether the lower right, or left, corner of its extent is a corner of the block.
[[nodiscard]] bool has_lower_corner(const Block& block, bool left);

/// In the order of the pairs. Pieces that are one straight line are one touch.
[[nodiscard]] std::vector<Touch> touching(const std::vector<Block>& blocks);

} // namespace dem
