#include "app/drawing/outline_network.hpp"

#include <algorithm>
#include <map>

namespace app {
namespace {

bool contains(const OutlineNetwork& network, const Ring& ring, dem::Point p)
{
    bool inside = false;
    for (std::size_t i = 0; i < ring.corners.size(); ++i) {
        const dem::Point a = network.nodes[ring.corners[i]];
        const dem::Point b = network.nodes[ring.corners[(i + 1) % ring.corners.size()]];
        if ((a.z > p.z) == (b.z > p.z)) continue;
        if (p.x < a.x + (p.z - a.z) / (b.z - a.z) * (b.x - a.x)) inside = !inside;
    }
    return inside;
}

struct Box {
    dem::Point low, high;
};

Box box_of(const OutlineNetwork& network, const Ring& ring)
{
    Box box{network.nodes[ring.corners.front()], network.nodes[ring.corners.front()]};
    for (const int n : ring.corners) {
        const dem::Point p = network.nodes[n];
        box.low = {std::min(box.low.x, p.x), std::min(box.low.z, p.z)};
        box.high = {std::max(box.high.x, p.x), std::max(box.high.z, p.z)};
    }
    return box;
}

/// Where no sides cross and the blocks at each corner lie one after the other, a block within another shares no corner
/// with it, nor do the blocks that hang together with it: one corner of each such group tells.
void check_hidden(const OutlineNetwork& network, IndexSets& touching)
{
    std::vector<Box> boxes;
    for (const Ring& ring : network.rings) boxes.push_back(box_of(network, ring));
    for (std::size_t i = 0; i < network.rings.size(); ++i) {
        if (touching.first_of(static_cast<int>(i)) != static_cast<int>(i)) continue;
        const dem::Point p = network.nodes[network.rings[i].corners.front()];
        for (std::size_t j = 0; j < network.rings.size(); ++j) {
            const Box& box = boxes[j];
            if (p.x < box.low.x || p.x > box.high.x || p.z < box.low.z || p.z > box.high.z)
                continue;
            if (touching.first_of(static_cast<int>(j)) == static_cast<int>(i) ||
                !contains(network, network.rings[j], p))
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
               counted(floating, "such block", "such blocks") +
               "); close the gaps, or make wall.snap (" + millimetres(network.snap) +
               ") larger than they are");
}

} // namespace

void check_groups(const OutlineNetwork& network)
{
    IndexSets touching = rings_that_share(network, false);
    check_hidden(network, touching);
    check_floating(network);
}

} // namespace app
