#pragma once
/// A scene of any outlines: where they touch becomes a joint.

#include "dem/scene/layout.hpp"

#include <vector>

namespace dem {

/// Two sides closer than this touch [m]. Outlines must be welded as closely.
constexpr double kTouching = 1e-6;
/// Pieces of joint below this length carry nothing and are left out [m].
constexpr double kShortestFace = 1e-4;

struct DrawnUnit {
    std::vector<Point> outline; ///< simple, counter-clockwise, no repeated corner [m]
    int material = 0;           ///< as Block::material
};

struct DrawnWall {
    std::vector<DrawnUnit> units; ///< they touch and do not overlap; the floor is at z = 0
    double thickness = 0.20;      ///< > 0 [m]
    Base base = Base::fixed;      ///< of the units with a side on the floor
    /// Of a whole unit [m], which is what Discretisation::contact_points is for; 0: the mean extent of the units.
    double unit_length = 0.0;
    /// A potential crack at mid-length of each unit that is as long as a whole one, where a vertical line crosses
    /// its outline twice.
    bool cracks_in_units = false;
    std::vector<Elastic> stones; ///< as Layout::stones
};

/// A beam lies on the sides at the highest level, from the first to the last of them.
/// @param beam_height [m]; 0: no beam
/// @throws std::invalid_argument if there is no unit, no unit stands on the floor, or a size is not positive
[[nodiscard]] Layout drawn_layout(const DrawnWall& wall, double beam_height);

} // namespace dem
