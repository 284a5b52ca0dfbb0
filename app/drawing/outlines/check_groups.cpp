#include "app/drawing/outlines/outline_network.hpp"
#include "dem/scene/geometry/polygon.hpp"

#include <algorithm>
#include <limits>
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

/// Distance from the corners of a block to the sides of another [m].
double distance_between(const OutlineNetwork& network, const Ring& corners, const Ring& sides)
{
    const std::vector<dem::Point> outline = outline_of(network, sides);
    double least = std::numeric_limits<double>::infinity();
    for (const int n : corners.corners)
        for (std::size_t i = 0; i < outline.size(); ++i)
            least = std::min(least, nearest_on_segment(network.nodes[n], outline[i],
                                                       outline[(i + 1) % outline.size()])
                                        .distance);
    return least;
}

/// Advice about blocks that stand on nothing: the least way between one of them and the
/// floor, or a block that stands.
std::string narrowest_gap(const OutlineNetwork& network,
                          const std::vector<const Ring*>& floating,
                          const std::vector<const Ring*>& standing)
{
    double least = std::numeric_limits<double>::infinity();
    std::string to = "the floor";
    for (const Ring* ring : floating)
        for (const int n : ring->corners) least = std::min(least, network.nodes[n].z);
    const auto extents = [&](const std::vector<const Ring*>& rings) {
        std::vector<dem::Region> of;
        for (const Ring* ring : rings) of.push_back(dem::extent_of(outline_of(network, *ring)));
        return of;
    };
    const std::vector<dem::Region> a = extents(floating), b = extents(standing);
    for (std::size_t i = 0; i < a.size(); ++i)
        for (std::size_t j = 0; j < b.size(); ++j) {
            if (std::max({a[i].x0 - b[j].x1, b[j].x0 - a[i].x1, a[i].z0 - b[j].z1,
                          b[j].z0 - a[i].z1}) >= least)
                continue;
            const Ring* ring = floating[i];
            const Ring* other = standing[j];
            const double gap = std::min(distance_between(network, *ring, *other),
                                        distance_between(network, *other, *ring));
            if (gap >= least) continue;
            least = gap;
            to = block_name(network, *other);
        }
    if (least == 0.0) return "it touches " + to + " in a point alone: let them share a side";
    return "close the gap of " + millimetres(least) + " to " + to +
           snap_advice(network, ", or make wall.snap (" + millimetres(network.snap) +
                                    ") larger than it is");
}

void check_floating(const OutlineNetwork& network)
{
    IndexSets joined = rings_that_share(network, true);
    std::vector<char> stands(network.rings.size());
    for (std::size_t r = 0; r < network.rings.size(); ++r)
        for (const int n : network.rings[r].corners)
            if (network.nodes[n].z == 0.0) stands[joined.first_of(static_cast<int>(r))] = 1;
    std::vector<const Ring*> floating, standing;
    for (std::size_t r = 0; r < network.rings.size(); ++r)
        (stands[joined.first_of(static_cast<int>(r))] ? standing : floating)
            .push_back(&network.rings[r]);
    if (floating.empty()) return;
    const Ring& first = *floating.front();
    refuse(network.frame, first.line,
           "the block at " + coordinates(network.frame, network.nodes[first.corners.front()]) +
               " stands neither on the floor nor on blocks that do (" +
               counted(floating.size(), "such block", "such blocks") + "); " +
               narrowest_gap(network, floating, standing));
}

} // namespace

void check_groups(const OutlineNetwork& network)
{
    IndexSets touching = rings_that_share(network, false);
    check_hidden(network, touching);
    check_floating(network);
}

} // namespace app
