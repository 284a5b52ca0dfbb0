#include "dem/scene/standing.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <stdexcept>
#include <string>

namespace dem {

std::vector<int> hanging_blocks(const Layout& layout)
{
    std::vector<bool> stands(layout.blocks.size());
    for (std::size_t b = 0; b < layout.blocks.size(); ++b)
        stands[b] = layout.blocks[b].z0 < kTouching;
    for (bool more = true; more;) {
        more = false;
        for (const Face& f : layout.faces) {
            if (f.a == kGround || stands[f.a] == stands[f.b]) continue;
            stands[f.a] = stands[f.b] = more = true;
        }
    }
    std::vector<int> hanging;
    for (int b = 0; b < layout.beam; ++b)
        if (!stands[b]) hanging.push_back(b);
    return hanging;
}

void check_standing(const Layout& layout)
{
    const std::vector<int> hanging = hanging_blocks(layout);
    if (hanging.empty()) return;
    double lowest = INFINITY;
    for (const int b : hanging) lowest = std::min(lowest, layout.blocks[b].z0);
    char height[32];
    std::snprintf(height, sizeof height, "%.4g", lowest);
    throw std::invalid_argument(std::string("nothing connects what lies above z = ") + height +
                                " m to the floor; leave a pier beside the openings");
}

} // namespace dem
