#include "dem/scene/mechanism/block_displacement.hpp"

#include <cmath>
#include <limits>

namespace dem {

Point displacement_at(const Snapshot& wall, int block, Point at)
{
    if (block < 0) return {};
    const BlockState& b = wall.blocks.at(block);
    double nearest = std::numeric_limits<double>::infinity();
    Point u;
    for (std::size_t i = 0; i < b.outline.size(); ++i) {
        const double distance = std::hypot(b.outline[i].x - at.x, b.outline[i].z - at.z);
        if (distance >= nearest) continue;
        nearest = distance;
        u = b.displacement.at(i);
    }
    return u;
}

} // namespace dem
