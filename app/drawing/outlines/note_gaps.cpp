#include "app/drawing/outlines/outline_network.hpp"

#include <algorithm>
#include <utility>

namespace app {

void note_gaps(OutlineNetwork& network)
{
    constexpr double kNear = 4.0; // times snap
    const NetworkSides all = network_sides(network);
    const std::vector<std::vector<int>> rings = rings_of_nodes(network);
    std::vector<char> counted_node(network.nodes.size());
    std::size_t n = 0;
    double widest = 0.0;
    dem::Point first;
    std::vector<std::vector<int>> found;
    try {
        found = nodes_on_sides(network.nodes, all.sides, kNear * network.snap);
    } catch (const TooCrowded&) {
        return; // a note is not worth it
    }
    for (std::size_t s = 0; s < found.size(); ++s)
        for (const int node : found[s]) {
            const std::vector<int>& own = rings[node];
            if (std::ranges::find(own, all.ring[s]) != own.end()) continue;
            if (std::exchange(counted_node[node], 1)) continue;
            const OnSegment on =
                nearest_on_segment(network.nodes[node], network.nodes[all.sides[s].a],
                                   network.nodes[all.sides[s].b]);
            widest = std::max(widest, on.distance);
            if (++n == 1) first = network.nodes[node];
        }
    if (n == 0) return;
    network.notes.push_back(
        counted(n, "corner lies", "corners lie") + " near a side of another block, up to " +
        millimetres(widest) + " away, and " + (n == 1 ? "does" : "do") +
        " not touch it, such as the one at " + coordinates(network.frame, first) +
        (network.frame.snap_given ? "; a larger wall.snap would close these gaps."
                                  : "; joints need corners on the side."));
}

} // namespace app
