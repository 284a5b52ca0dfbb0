#pragma once
/// A scene of any outlines: where they touch becomes a joint.

#include "dem/scene/layout.hpp"

#include <vector>

namespace dem {

struct DrawnUnit {
    std::vector<Point> outline; ///< simple, counter-clockwise, no repeated corner [m]
    int material = 0;           ///< as Block::material
    int layer =
        0; ///< of the drawing, as whoever reads it counts them; nothing in the model follows from it
};

struct DrawnWall {
    std::vector<DrawnUnit> units; ///< they touch and do not overlap; the floor is at z = 0
    double thickness = 0.20;      ///< > 0 [m]
    Base base = Base::fixed;      ///< of the units with a side on the floor
    /// Length of a whole unit [m], which is what Discretisation::contact_points is for; 0: the
    /// mean extent of the units.
    double unit_length = 0.0;
    UnitCracks cracks{.pattern = {CrackPattern::Kind::none}};
    std::vector<Elastic> stones; ///< as Layout::stones
    int lintels = 0;             ///< as Layout::lintels
};

/// A beam lies on the sides at the highest level, from the first to the last of them.
/// @param beam_height [m]; 0: no beam
/// @throws std::invalid_argument if there is no unit, no unit stands on the floor, or a size is
/// not positive
[[nodiscard]] Layout drawn_layout(const DrawnWall& wall, double beam_height);

} // namespace dem
