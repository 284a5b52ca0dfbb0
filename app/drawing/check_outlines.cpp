#include "app/drawing/outline_network.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <utility>

namespace app {
namespace {

dem::Point position(const OutlineNetwork& network, int n)
{
    return network.nodes[static_cast<std::size_t>(n)];
}

const Ring& ring_at(const OutlineNetwork& network, int r)
{
    return network.rings[static_cast<std::size_t>(r)];
}

/// "the block of line 12", or of its first corner where the file has no lines.
std::string named(const OutlineNetwork& network, const Ring& ring)
{
    if (ring.line > 0) return "the block of line " + std::to_string(ring.line);
    return "the block at " +
           coordinates(network.frame, position(network, ring.corners.front()));
}

[[noreturn]] void refuse_overlap(const OutlineNetwork& network, int one, int other,
                                 dem::Point where)
{
    const auto [first, second] = std::minmax(one, other);
    const Ring& ring = ring_at(network, second);
    refuse(network.frame, ring.line,
           "this block overlaps " + named(network, ring_at(network, first)) + " at " +
               coordinates(network.frame, where) + " by more than wall.snap (" +
               millimetres(network.snap) + "); draw them side by side");
}

void check_crossings(const OutlineNetwork& network)
{
    const NetworkSides all = network_sides(network);
    const std::optional<Crossing> crossing = first_crossing(network.nodes, all.sides);
    if (!crossing) return;
    const int one = all.ring[static_cast<std::size_t>(crossing->first)];
    const int other = all.ring[static_cast<std::size_t>(crossing->second)];
    if (one != other) refuse_overlap(network, one, other, crossing->at);
    refuse(network.frame, ring_at(network, one).line,
           "the outline of this block crosses itself at " +
               coordinates(network.frame, crossing->at) + "; draw its corners in order");
}

/// Signed area [m2] and length [m] of a ring.
std::pair<double, double> area_and_length(const OutlineNetwork& network, const Ring& ring)
{
    double twice = 0.0, length = 0.0;
    const dem::Point o = position(network, ring.corners.front());
    for (std::size_t i = 0; i < ring.corners.size(); ++i) {
        const dem::Point a = position(network, ring.corners[i]);
        const dem::Point b = position(network, ring.corners[(i + 1) % ring.corners.size()]);
        twice += (a.x - o.x) * (b.z - o.z) - (a.z - o.z) * (b.x - o.x);
        length += std::hypot(b.x - a.x, b.z - a.z);
    }
    return {twice / 2.0, length};
}

void orient(OutlineNetwork& network)
{
    for (Ring& ring : network.rings) {
        const auto [area, length] = area_and_length(network, ring);
        if (2.0 * std::abs(area) <= network.snap * length) {
            refuse(network.frame, ring.line,
                   "the block at " +
                       coordinates(network.frame, position(network, ring.corners.front())) +
                       " has no area, or is thinner than wall.snap (" +
                       millimetres(network.snap) + "); delete it");
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
            std::vector<int> a = ring.corners, b = ring_at(network, known->second).corners;
            std::sort(a.begin(), a.end());
            std::sort(b.begin(), b.end());
            if (a != b)
                refuse_overlap(network, known->second, static_cast<int>(r),
                               position(network, side.a));
            refuse(network.frame, ring.line,
                   "this block is drawn twice: " +
                       named(network, ring_at(network, known->second)) +
                       " has the same corners, such as " +
                       coordinates(network.frame, position(network, side.a)) +
                       "; delete one of them");
        }
    }
}

/// What a block covers around one of its corners.
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
            const dem::Point p = position(network, c[i]);
            const double begin = direction(p, position(network, c[(i + 1) % c.size()]));
            const double end =
                direction(p, position(network, c[(i + c.size() - 1) % c.size()]));
            around[static_cast<std::size_t>(c[i])].push_back(
                {begin, turned(end - begin), static_cast<int>(r)});
        }
    }
    for (std::size_t n = 0; n < around.size(); ++n) {
        std::vector<Sector>& sectors = around[n];
        if (sectors.size() < 2) continue;
        std::sort(sectors.begin(), sectors.end(), [](const Sector& a, const Sector& b) {
            return std::pair(a.begin, a.ring) < std::pair(b.begin, b.ring);
        });
        for (std::size_t i = 0; i < sectors.size(); ++i) {
            const Sector& next = sectors[(i + 1) % sectors.size()];
            if (sectors[i].width <= turned(next.begin - sectors[i].begin) + 1e-9) continue;
            refuse_overlap(network, sectors[i].ring, next.ring, network.nodes[n]);
        }
    }
}

bool contains(const OutlineNetwork& network, const Ring& ring, dem::Point p)
{
    bool inside = false;
    for (std::size_t i = 0; i < ring.corners.size(); ++i) {
        const dem::Point a = position(network, ring.corners[i]);
        const dem::Point b = position(network, ring.corners[(i + 1) % ring.corners.size()]);
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
    Box box{position(network, ring.corners.front()), position(network, ring.corners.front())};
    for (const int n : ring.corners) {
        const dem::Point p = position(network, n);
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
        const dem::Point p = position(network, network.rings[i].corners.front());
        for (std::size_t j = 0; j < network.rings.size(); ++j) {
            const Box& box = boxes[j];
            if (p.x < box.low.x || p.x > box.high.x || p.z < box.low.z || p.z > box.high.z)
                continue;
            if (touching.root(static_cast<int>(j)) == static_cast<int>(i) ||
                !contains(network, network.rings[j], p))
                continue;
            refuse(network.frame, network.rings[i].line,
                   "this block lies within " + named(network, network.rings[j]) + ", at " +
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
            if (position(network, n).z == 0.0)
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
               coordinates(network.frame, position(network, first->corners.front())) +
               " stands neither on the floor nor on blocks that do (" +
               counted(floating, "such block", "such blocks") +
               "); close the gaps, or make wall.snap (" + millimetres(network.snap) +
               ") larger than they are");
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
    RingSets touching = rings_that_share(network, false);
    check_hidden(network, touching);
    check_floating(network);
}

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
            const std::vector<int>& own = rings[static_cast<std::size_t>(node)];
            if (std::find(own.begin(), own.end(), all.ring[s]) != own.end()) continue;
            if (std::exchange(counted_node[static_cast<std::size_t>(node)], 1)) continue;
            double share = 0.0;
            widest =
                std::max(widest, distance_to_segment(position(network, node),
                                                     position(network, all.sides[s].a),
                                                     position(network, all.sides[s].b), share));
            if (++n == 1) first = position(network, node);
        }
    if (n == 0) return;
    network.notes.push_back(
        counted(n, "corner lies", "corners lie") + " near a side of another block, up to " +
        millimetres(widest) + " away, and do not touch it, such as that at " +
        coordinates(network.frame, first) + "; a larger wall.snap would close these gaps.");
}

} // namespace app
