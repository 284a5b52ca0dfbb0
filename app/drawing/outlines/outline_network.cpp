#include "app/drawing/outlines/outline_network.hpp"

#include <algorithm>
#include <string>
#include <utility>

namespace app {

NetworkSides network_sides(const OutlineNetwork& network)
{
    std::vector<std::pair<Side, int>> all;
    for (std::size_t r = 0; r < network.rings.size(); ++r) {
        const std::vector<int>& corners = network.rings[r].corners;
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const int a = corners[i], b = corners[(i + 1) % corners.size()];
            all.push_back({{std::min(a, b), std::max(a, b)}, static_cast<int>(r)});
        }
    }
    std::ranges::sort(all);
    NetworkSides found;
    for (const auto& [side, ring] : all) {
        if (!found.sides.empty() && found.sides.back() == side) continue;
        found.sides.push_back(side);
        found.ring.push_back(ring);
    }
    return found;
}

std::vector<std::vector<int>> rings_of_nodes(const OutlineNetwork& network)
{
    std::vector<std::vector<int>> rings(network.nodes.size());
    for (std::size_t r = 0; r < network.rings.size(); ++r)
        for (const int n : network.rings[r].corners) rings[n].push_back(static_cast<int>(r));
    return rings;
}

std::vector<dem::Point> outline_of(const OutlineNetwork& network, const Ring& ring)
{
    std::vector<dem::Point> outline;
    for (const int n : ring.corners) outline.push_back(network.nodes[n]);
    return outline;
}

std::string snap_text(const OutlineNetwork& network)
{
    const std::string length = millimetres(network.snap);
    return network.frame.snap_given ? "wall.snap (" + length + ")" : length;
}

std::string snap_advice(const OutlineNetwork& network, std::string_view advice)
{
    return network.frame.snap_given ? std::string(advice) : "";
}

std::string block_name(const OutlineNetwork& network, const Ring& ring)
{
    // of a study all blocks stand on one line
    if (ring.line > 0 && network.frame.snap_given)
        return "the block of line " + std::to_string(ring.line);
    return "the block at " + coordinates(network.frame, network.nodes[ring.corners.front()]);
}

} // namespace app
