#include "app/drawing/outline_network.hpp"

#include <algorithm>
#include <map>
#include <numeric>

namespace app {
namespace {

dem::Point node_at(const OutlineNetwork& network, int n)
{
    return network.nodes[static_cast<std::size_t>(n)];
}

bool contains(const OutlineNetwork& network, const Ring& ring, dem::Point p)
{
    bool inside = false;
    for (std::size_t i = 0; i < ring.corners.size(); ++i) {
        const dem::Point a = node_at(network, ring.corners[i]);
        const dem::Point b = node_at(network, ring.corners[(i + 1) % ring.corners.size()]);
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
    Box box{node_at(network, ring.corners.front()), node_at(network, ring.corners.front())};
    for (const int n : ring.corners) {
        const dem::Point p = node_at(network, n);
        box.low = {std::min(box.low.x, p.x), std::min(box.low.z, p.z)};
        box.high = {std::max(box.high.x, p.x), std::max(box.high.z, p.z)};
    }
    return box;
}

/// Sets of rings: that of each ring is named by its first.
struct RingSets {
    std::vector<int> parent;
    explicit RingSets(std::size_t n) : parent(n) { std::iota(parent.begin(), parent.end(), 0); }
    int root(int i)
    {
        while (parent[static_cast<std::size_t>(i)] != i) {
            int& up = parent[static_cast<std::size_t>(i)];
            i = up = parent[static_cast<std::size_t>(up)];
        }
        return i;
    }
    void unite(int i, int j)
    {
        const int a = root(i), b = root(j);
        parent[static_cast<std::size_t>(std::max(a, b))] = std::min(a, b);
    }
};

/// Where no sides cross and the blocks at each corner lie one after the other, a block within another shares no corner
/// with it, nor do the blocks that hang together with it: one corner of each such group tells.
void check_hidden(const OutlineNetwork& network, RingSets& touching)
{
    std::vector<Box> boxes;
    for (const Ring& ring : network.rings) boxes.push_back(box_of(network, ring));
    for (std::size_t i = 0; i < network.rings.size(); ++i) {
        if (touching.root(static_cast<int>(i)) != static_cast<int>(i)) continue;
        const dem::Point p = node_at(network, network.rings[i].corners.front());
        for (std::size_t j = 0; j < network.rings.size(); ++j) {
            const Box& box = boxes[j];
            if (p.x < box.low.x || p.x > box.high.x || p.z < box.low.z || p.z > box.high.z)
                continue;
            if (touching.root(static_cast<int>(j)) == static_cast<int>(i) ||
                !contains(network, network.rings[j], p))
                continue;
            refuse(network.frame, network.rings[i].line,
                   "this block lies within " + block_name(network, network.rings[j]) + ", at " +
                       coordinates(network.frame, p) +
                       "; delete one of them, or draw the outer one around it");
        }
    }
}

RingSets rings_that_share(const OutlineNetwork& network, bool sides)
{
    RingSets sets(network.rings.size());
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
    RingSets joined = rings_that_share(network, true);
    std::vector<char> stands(network.rings.size());
    for (std::size_t r = 0; r < network.rings.size(); ++r)
        for (const int n : network.rings[r].corners)
            if (node_at(network, n).z == 0.0)
                stands[static_cast<std::size_t>(joined.root(static_cast<int>(r)))] = 1;
    std::size_t floating = 0;
    const Ring* first = nullptr;
    for (std::size_t r = 0; r < network.rings.size(); ++r) {
        if (stands[static_cast<std::size_t>(joined.root(static_cast<int>(r)))]) continue;
        if (++floating == 1) first = &network.rings[r];
    }
    if (!first) return;
    refuse(network.frame, first->line,
           "the block at " +
               coordinates(network.frame, node_at(network, first->corners.front())) +
               " stands neither on the floor nor on blocks that do (" +
               counted(floating, "such block", "such blocks") + "); close the gaps" +
               snap_advice(network, ", or make wall.snap (" + millimetres(network.snap) +
                                        ") larger than they are"));
}

} // namespace

void check_groups(const OutlineNetwork& network)
{
    RingSets touching = rings_that_share(network, false);
    check_hidden(network, touching);
    check_floating(network);
}

} // namespace app
