#include "app/drawing/outlines/outline_network.hpp"
#include "dem/scene/geometry/polygon.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

namespace app {
namespace {

[[noreturn]] void refuse_overlap(const OutlineNetwork& network, int one, int other,
                                 dem::Point where)
{
    const auto [first, second] = std::minmax(one, other);
    const Ring& ring = network.rings[second];
    refuse(network.frame, ring.line,
           "this block overlaps " + block_name(network, network.rings[first]) + " at " +
               coordinates(network.frame, where) + " by more than " + snap_text(network) +
               "; draw them side by side");
}

void check_crossings(const OutlineNetwork& network)
{
    const NetworkSides all = network_sides(network);
    const std::optional<Crossing> crossing = first_crossing(network.nodes, all.sides);
    if (!crossing) return;
    const int one = all.ring[crossing->first];
    const int other = all.ring[crossing->second];
    if (one != other) refuse_overlap(network, one, other, crossing->at);
    refuse(network.frame, network.rings[one].line,
           "the outline of this block crosses itself at " +
               coordinates(network.frame, crossing->at) + "; draw its corners in order");
}

void orient(OutlineNetwork& network)
{
    for (Ring& ring : network.rings) {
        const std::vector<dem::Point> outline = outline_of(network, ring);
        const double area = dem::polygon_area(outline);
        double length = 0.0;
        for (std::size_t i = 0; i < outline.size(); ++i)
            length += distance(outline[i], outline[(i + 1) % outline.size()]);
        if (2.0 * std::abs(area) <= network.snap * length) {
            refuse(network.frame, ring.line,
                   "the block at " + coordinates(network.frame, outline.front()) +
                       " has no area, or is thinner than " + snap_text(network) +
                       "; delete it");
        }
        if (area < 0.0) std::reverse(ring.corners.begin() + 1, ring.corners.end());
    }
}

/// Two blocks on the same side of a side overlap.
void check_shared_sides(const OutlineNetwork& network)
{
    std::map<Side, int> owner;
    for (std::size_t r = 0; r < network.rings.size(); ++r) {
        const Ring& ring = network.rings[r];
        for (std::size_t i = 0; i < ring.corners.size(); ++i) {
            const Side side{ring.corners[i], ring.corners[(i + 1) % ring.corners.size()]};
            const auto [known, is_new] = owner.emplace(side, static_cast<int>(r));
            if (is_new) continue;
            std::vector<int> a = ring.corners, b = network.rings[known->second].corners;
            std::ranges::sort(a);
            std::ranges::sort(b);
            if (a != b)
                refuse_overlap(network, known->second, static_cast<int>(r),
                               network.nodes[side.a]);
            refuse(network.frame, ring.line,
                   "this block is drawn twice: " +
                       block_name(network, network.rings[known->second]) +
                       " has the same corners, such as " +
                       coordinates(network.frame, network.nodes[side.a]) +
                       "; delete one of them");
        }
    }
}

/// Sector that a block covers around one of its corners.
struct Sector {
    double begin = 0.0, width = 0.0; ///< [rad], counter-clockwise
    int ring = 0;
};

double turned(double angle) // into [0, 2 pi)
{
    constexpr double kWhole = 2.0 * std::numbers::pi;
    if (angle < 0.0) angle += kWhole;
    return angle >= kWhole ? 0.0 : angle;
}

double direction(dem::Point from, dem::Point to)
{
    return std::atan2(to.z - from.z, to.x - from.x);
}

/// Blocks that share a corner lie around it one after the other.
void check_sectors(const OutlineNetwork& network)
{
    std::vector<std::vector<Sector>> around(network.nodes.size());
    for (std::size_t r = 0; r < network.rings.size(); ++r) {
        const std::vector<int>& c = network.rings[r].corners;
        for (std::size_t i = 0; i < c.size(); ++i) {
            const dem::Point p = network.nodes[c[i]];
            const double begin = direction(p, network.nodes[c[(i + 1) % c.size()]]);
            const double end = direction(p, network.nodes[c[(i + c.size() - 1) % c.size()]]);
            around[c[i]].push_back({begin, turned(end - begin), static_cast<int>(r)});
        }
    }
    for (std::size_t n = 0; n < around.size(); ++n) {
        std::vector<Sector>& sectors = around[n];
        if (sectors.size() < 2) continue;
        std::ranges::sort(sectors, [](const Sector& a, const Sector& b) {
            return std::pair(a.begin, a.ring) < std::pair(b.begin, b.ring);
        });
        for (std::size_t i = 0; i < sectors.size(); ++i) {
            const Sector& next = sectors[(i + 1) % sectors.size()];
            if (sectors[i].width <= turned(next.begin - sectors[i].begin) + 1e-9) continue;
            refuse_overlap(network, sectors[i].ring, next.ring, network.nodes[n]);
        }
    }
}

} // namespace

void check_outlines(OutlineNetwork& network)
{
    try {
        check_crossings(network);
    } catch (const TooCrowded& crowd) {
        refuse(network.frame, 0,
               "has too many sides near " + coordinates(network.frame, crowd.at) +
                   "; simplify the drawing there");
    }
    orient(network);
    check_shared_sides(network);
    check_sectors(network);
    check_groups(network);
}

} // namespace app
