#include "app/drawing/outlines/outline_network.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace app {
namespace {

/// Node n was put onto the side from a to b.
struct OnSide {
    int a = 0, n = 0, b = 0;
};

struct Fitting {
    std::vector<dem::Point> drawn; ///< where the nodes were [m]
    std::vector<OnSide> on_sides;
    std::size_t joined = 0, straight = 0;
    double farthest = 0.0; ///< that a corner was moved to another [m]
    double top = 0.0;      ///< the highest level [m]
    std::size_t levelled = 0;
    double lifted = 0.0; ///< the farthest that a corner was moved to the floor or the top [m]
};

[[noreturn]] void refuse_crowd(const OutlineNetwork& network, const TooCrowded& crowd)
{
    refuse(network.frame, 0,
           "has too many corners or sides near " + coordinates(network.frame, crowd.at) +
               "; simplify the drawing there");
}

void refuse_repeated(const OutlineNetwork& network, const Ring& ring)
{
    std::vector<int> sorted = ring.corners;
    std::ranges::sort(sorted);
    const auto twice = std::ranges::adjacent_find(sorted);
    if (twice == sorted.end()) return;
    refuse(network.frame, ring.line,
           "the outline of this block comes within " + snap_text(network) + " of itself at " +
               coordinates(network.frame, network.nodes[*twice]) + "; draw it apart" +
               snap_advice(network, ", or make wall.snap smaller"));
}

/// Each corner once; a block that shrinks to less than a triangle is refused.
void renumber(OutlineNetwork& network, const std::vector<int>& node)
{
    for (Ring& ring : network.rings) {
        std::vector<int> corners;
        const int old = ring.corners.front();
        for (const int c : ring.corners) {
            const int n = node[c];
            if (corners.empty() || corners.back() != n) corners.push_back(n);
        }
        while (corners.size() > 1 && corners.front() == corners.back()) corners.pop_back();
        if (corners.size() < 3) {
            refuse(network.frame, ring.line,
                   "the block at " + coordinates(network.frame, network.nodes[old]) +
                       " has no area, or is smaller than " + snap_text(network) +
                       "; delete it");
        }
        ring.corners = std::move(corners);
        refuse_repeated(network, ring);
    }
}

/// The nodes that rings have, in order.
std::vector<int> used_nodes(const OutlineNetwork& network)
{
    std::vector<int> used;
    for (const Ring& ring : network.rings)
        used.insert(used.end(), ring.corners.begin(), ring.corners.end());
    std::ranges::sort(used);
    used.erase(std::unique(used.begin(), used.end()), used.end());
    return used;
}

void join_corners(OutlineNetwork& network, Fitting& fitting)
{
    const std::vector<int> used = used_nodes(network);
    std::vector<dem::Point> points;
    for (const int n : used) points.push_back(network.nodes[n]);
    const Welded welded = weld(points, network.snap);
    if (welded.farthest > 2.0 * network.snap) {
        refuse(network.frame, 0,
               "corners follow each other at less than " + snap_text(network) + " near " +
                   coordinates(network.frame, points[welded.farthest_point]) + "; " +
                   snap_advice(network, "make wall.snap smaller, or ") +
                   "make the drawing coarser");
    }
    fitting.joined += welded.moved;
    fitting.farthest = std::max(fitting.farthest, welded.farthest);
    std::vector<int> node(network.nodes.size());
    for (std::size_t i = 0; i < used.size(); ++i) node[used[i]] = used[welded.node[i]];
    renumber(network, node);
    const auto now = [&](int n) { return node[n]; };
    for (OnSide& o : fitting.on_sides) o = {now(o.a), now(o.n), now(o.b)};
    std::erase_if(fitting.on_sides,
                  [](const OnSide& o) { return o.a == o.n || o.n == o.b || o.a == o.b; });
}

/// The node of the ring that is farthest from p.
dem::Point farthest_from(const OutlineNetwork& network, const Ring& ring, dem::Point p)
{
    dem::Point found = p;
    double most = 0.0;
    for (const int n : ring.corners) {
        const dem::Point q = network.nodes[n];
        const double away = distance(q, p);
        if (away <= most) continue;
        most = away;
        found = q;
    }
    return found;
}

void refuse_thin(const OutlineNetwork& network)
{
    for (const Ring& ring : network.rings) {
        const dem::Point a = farthest_from(network, ring, network.nodes[ring.corners.front()]);
        const dem::Point b = farthest_from(network, ring, a);
        const bool thin = std::ranges::all_of(ring.corners, [&](int n) {
            return nearest_on_segment(network.nodes[n], a, b).distance <= network.snap;
        });
        if (!thin) continue;
        refuse(network.frame, ring.line,
               "the block from " + coordinates(network.frame, a) + " to " +
                   coordinates(network.frame, b) + " has no area, or is thinner than " +
                   snap_text(network) + "; delete it");
    }
}

/// The last of the sorted heights that one of the first's level has: they follow each other
/// within snap.
double end_of_level(const std::vector<double>& heights, double snap)
{
    double end = heights.front();
    for (const double z : heights) {
        const double step = std::abs(z - end), all = std::abs(z - heights.front());
        if (step > snap || all > 2.0 * snap) break;
        end = z;
    }
    return end;
}

/// The floor and the top may scatter from block to block.
void put_on_floor_and_top(OutlineNetwork& network, Fitting& fitting)
{
    const std::vector<int> used = used_nodes(network);
    std::vector<double> heights;
    for (const int n : used) heights.push_back(network.nodes[n].z);
    std::ranges::sort(heights);
    const double low = end_of_level(heights, network.snap);
    std::ranges::reverse(heights);
    const double high = end_of_level(heights, network.snap);
    fitting.top = heights.front();
    for (const int n : used) {
        double& z = network.nodes[n].z;
        const double level = z <= low ? 0.0 : z >= high ? fitting.top : z;
        const double moved = std::abs(level - z);
        if (moved > kLeastSnap) ++fitting.levelled;
        fitting.lifted = std::max(fitting.lifted, moved);
        z = level;
    }
}

bool put_on_sides(OutlineNetwork& network, Fitting& fitting)
{
    const NetworkSides all = network_sides(network);
    const std::vector<std::vector<int>> found =
        nodes_on_sides(network.nodes, all.sides, network.snap);
    const std::size_t before = fitting.on_sides.size();
    for (std::size_t s = 0; s < found.size(); ++s)
        for (const int n : found[s])
            fitting.on_sides.push_back({all.sides[s].a, n, all.sides[s].b});
    if (fitting.on_sides.size() == before) return false;
    for (Ring& ring : network.rings) {
        std::vector<int> corners;
        for (std::size_t i = 0; i < ring.corners.size(); ++i) {
            const int a = ring.corners[i], b = ring.corners[(i + 1) % ring.corners.size()];
            const Side side{std::min(a, b), std::max(a, b)};
            const auto it = std::ranges::lower_bound(all.sides, side);
            const std::vector<int>& between = found[it - all.sides.begin()];
            corners.push_back(a);
            if (a < b)
                corners.insert(corners.end(), between.begin(), between.end());
            else
                corners.insert(corners.end(), between.rbegin(), between.rend());
        }
        ring.corners = std::move(corners);
        refuse_repeated(network, ring);
    }
    return true;
}

/// Moves the nodes on sides until the sides are straight again, to what the solver can see. A
/// side may end at nodes that move too: the sweeps converge to a line through all of a bed
/// joint.
void straighten_sides(OutlineNetwork& network, const Fitting& fitting)
{
    if (fitting.on_sides.empty()) return;
    const std::size_t most =
        std::min<std::size_t>(20'000, 20'000'000 / fitting.on_sides.size() + 1);
    bool moved = true;
    for (std::size_t sweep = 0; sweep < most && moved; ++sweep) {
        moved = false;
        for (const OnSide& o : fitting.on_sides) {
            const dem::Point a = network.nodes[o.a], b = network.nodes[o.b],
                             p = network.nodes[o.n];
            const auto [share, off] = nearest_on_segment(p, a, b);
            if (off <= kLeastSnap) continue;
            const bool level = p.z == 0.0 || p.z == fitting.top;
            const dem::Point on{a.x + share * (b.x - a.x),
                                level ? p.z : a.z + share * (b.z - a.z)};
            const dem::Point was = fitting.drawn[o.n];
            if (distance(on, was) > 2.0 * network.snap) continue;
            moved |= distance(on, p) > 0.1 * kLeastSnap;
            network.nodes[o.n] = on;
        }
    }
}

/// The reason why a corner moved by more than snap; empty where none did.
std::string beyond_snap(const OutlineNetwork& network, double farthest)
{
    if (!(farthest > network.snap + kLeastSnap)) return "";
    return " (more than " + snap_text(network) +
           ", because corners follow each other in steps up to that)";
}

void note_fitting(OutlineNetwork& network, const Fitting& fitting)
{
    std::set<int> on_sides;
    double farthest = 0.0;
    for (const OnSide& o : fitting.on_sides) {
        const dem::Point was = fitting.drawn[o.n], now = network.nodes[o.n];
        on_sides.insert(o.n);
        farthest = std::max(farthest, distance(now, was));
    }
    if (fitting.joined > 0) {
        network.notes.push_back(counted(fitting.joined, "corner was", "corners were") +
                                " joined to others, at most " + millimetres(fitting.farthest) +
                                " away" + beyond_snap(network, fitting.farthest) + ".");
    }
    if (fitting.levelled > 0) {
        network.notes.push_back(counted(fitting.levelled, "corner was", "corners were") +
                                " put on the level of the lowest or the highest one, at most " +
                                millimetres(fitting.lifted) + " away" +
                                beyond_snap(network, fitting.lifted) + ".");
    }
    if (farthest > kLeastSnap) {
        network.notes.push_back(
            counted(on_sides.size(), "corner lies", "corners lie") +
            " on sides of other blocks; to this end corners were moved by at most " +
            millimetres(farthest) + ".");
    }
    if (fitting.straight > 0) {
        network.notes.push_back(counted(fitting.straight,
                                        "corner on a straight side was removed",
                                        "corners on straight sides were removed") +
                                ".");
    }
}

} // namespace

void fit_corners(OutlineNetwork& network)
{
    constexpr int kMostRounds = 8; // one or two do
    try {
        Fitting fitting;
        join_corners(network, fitting);
        put_on_floor_and_top(network, fitting);
        join_corners(network, fitting); // corners above each other are one there
        refuse_thin(network);
        fitting.straight = straighten(network);
        fitting.drawn = network.nodes;
        for (int round = 0; round < kMostRounds; ++round) {
            const bool put = put_on_sides(network, fitting);
            if (!put) break;
            straighten_sides(network, fitting);
            join_corners(network, fitting);
        }
        note_fitting(network, fitting);
    } catch (const TooCrowded& crowd) {
        refuse_crowd(network, crowd);
    }
}

} // namespace app
