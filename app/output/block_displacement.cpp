#include "app/output/block_displacement.hpp"

#include <cmath>
#include <limits>

namespace app {

dem::Point displacement_at(const dem::Snapshot& wall, int block, dem::Point at)
{
    if (block < 0) return {};
    const dem::BlockState& b = wall.blocks.at(block);
    double nearest = std::numeric_limits<double>::infinity();
    dem::Point u;
    for (std::size_t i = 0; i < b.outline.size(); ++i) {
        const double distance = std::hypot(b.outline[i].x - at.x, b.outline[i].z - at.z);
        if (distance >= nearest) continue;
        nearest = distance;
        u = b.displacement.at(i);
    }
    return u;
}

} // namespace app
