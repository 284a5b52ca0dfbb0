#pragma once
/// Walls of random rubble.

#include "dem/scene/geometry/clip.hpp"

#include <vector>

namespace dem {

struct Rubble {
    double length = 1.0, height = 1.0; ///< of the wall, > 0 [m]
    /// Size of a stone of mean area; their ratio is the mean elongation of the stones. > 0 [m]
    double stone_length = 0.20, stone_height = 0.10;
    unsigned seed = 1;
};

/// Stones that fill an upright rectangle with its lower left corner at the origin: cells around
/// random places that keep apart, in a plane stretched by the elongation. Sides below a tenth
/// of the smaller size of a stone are closed to points. Outlines are simple, counter-clockwise,
/// from the bottom to the top, and stones touch along whole sides. Cost: with the square of the
/// number of stones.
/// @throws std::invalid_argument if a size is not positive
[[nodiscard]] std::vector<Outline> rubble(const Rubble& wall);

} // namespace dem
