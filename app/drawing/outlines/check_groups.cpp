#include "app/drawing/outlines/outline_network.hpp"
#include "dem/scene/geometry/polygon.hpp"

#include <algorithm>
#include <map>

namespace app {
namespace {

/// Where no sides cross and the blocks at each corner lie one after the other, a block within
/// another shares no corner with it, nor do the blocks that hang together with it: one corner
/// of each such group tells.
void check_hidden(const OutlineNetwork& network, IndexSets& touching)
{
    std::vector<std::vector<dem::Point>> outlines;
    std::vector<dem::Region> extents;
    for (const Ring& ring : network.rings) {
        outlines.push_back(outline_of(network, ring));
        extents.push_back(dem::extent_of(outlines.back()));
    }
    for (std::size_t i = 0; i < network.rings.size(); ++i) {
        if (touching.first_of(static_cast<int>(i)) != static_cast<int>(i)) continue;
        const dem::Point p = network.nodes[network.rings[i].corners.front()];
        for (std::size_t j = 0; j < network.rings.size(); ++j) {
            const dem::Region& e = extents[j];
            if (p.x < e.x0 || p.x > e.x1 || p.z < e.z0 || p.z > e.z1) continue;
            if (touching.first_of(static_cast<int>(j)) == static_cast<int>(i) ||
                !dem::is_inside(outlines[j], p))
                continue;
            refuse(network.frame, network.rings[i].line,
                   "this block lies within " + block_name(network, network.rings[j]) + ", at " +
                       coordinates(network.frame, p) +
                       "; delete one of them, or draw the outer one around it");
        }
    }
}

IndexSets rings_that_share(const OutlineNetwork& network, bool sides)
{
    IndexSets sets(network.rings.size());
    std::map<Side, int> owner;
    for (std::size_t r = 0; r < network.rings.size(); ++r) {
        const std::vector<int>& c = network.rings[r].corners;
        for (std::size_t i = 0; i < c.size(); ++i) {
            const int a = c[i], b = sides ? c[(i + 1) % c.size()] : a;
            const auto [known, is_new] =
                owner.emplace(Side{std::min(a, b), std::max(a, b)}, static_cast<int>(r));
            if (!is_new) sets.unite(known->second, static_cast<int>(r));
        }
    }
    return sets;
}

void check_floating(const OutlineNetwork& network)
{
    IndexSets joined = rings_that_share(network, true);
    std::vector<char> stands(network.rings.size());
    for (std::size_t r = 0; r < network.rings.size(); ++r)
        for (const int n : network.rings[r].corners)
            if (network.nodes[n].z == 0.0) stands[joined.first_of(static_cast<int>(r))] = 1;
    std::size_t floating = 0;
    const Ring* first = nullptr;
    for (std::size_t r = 0; r < network.rings.size(); ++r) {
        if (stands[joined.first_of(static_cast<int>(r))]) continue;
        if (++floating == 1) first = &network.rings[r];
    }
    if (!first) return;
    refuse(network.frame, first->line,
           "the block at " + coordinates(network.frame, network.nodes[first->corners.front()]) +
               " stands neither on the floor nor on blocks that do (" +
               counted(floating, "such block", "such blocks") + "); close the gaps" +
               snap_advice(network, ", or make wall.snap (" + millimetres(network.snap) +
                                        ") larger than they are"));
}

} // namespace

void check_groups(const OutlineNetwork& network)
{
    IndexSets touching = rings_that_share(network, false);
    check_hidden(network, touching);
    check_floating(network);
}

} // namespace app
