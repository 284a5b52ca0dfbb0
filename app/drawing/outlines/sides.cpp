#include "app/drawing/outlines/sides.hpp"

#include "app/drawing/outlines/plane_grid.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <utility>

namespace app {
namespace {

constexpr std::size_t kMostPairs = 200'000'000; // about a second

/// Twice the signed area of the triangle a, b, c.
double turn(dem::Point a, dem::Point b, dem::Point c)
{
    return (b.x - a.x) * (c.z - a.z) - (b.z - a.z) * (c.x - a.x);
}

struct Celled {
    std::int64_t column = 0, row = 0;
    int point = 0;
    friend auto operator<=>(const Celled&, const Celled&) = default;
};

/// Unites the points of one cell with those of the cell at this offset, where they are within
/// snap.
void unite_neighbours(IndexSets& sets, std::span<const dem::Point> points,
                      std::span<const Celled> all, const Celled& from, std::int64_t right,
                      std::int64_t up, double snap, std::size_t& pairs)
{
    const Celled key{from.column + right, from.row + up,
                     right == 0 && up == 0 ? from.point + 1 : 0};
    for (auto it = std::ranges::lower_bound(all, key);
         it != all.end() && it->column == key.column && it->row == key.row; ++it) {
        const dem::Point p = points[from.point];
        if (++pairs > kMostPairs) throw TooCrowded(p);
        if (distance(p, points[it->point]) <= snap) sets.unite(from.point, it->point);
    }
}

/// Indices of the points that differ from all points before them; the others are united with
/// the first of their kind.
std::vector<int> distinct_points(IndexSets& sets, std::span<const dem::Point> points)
{
    std::vector<int> order(points.size()), distinct;
    std::iota(order.begin(), order.end(), 0);
    const auto key = [&](int i) {
        const dem::Point& p = points[i];
        return std::pair(p.x, p.z);
    };
    std::ranges::sort(
        order, [&](int i, int j) { return std::pair(key(i), i) < std::pair(key(j), j); });
    for (std::size_t i = 0; i < order.size(); ++i) {
        if (!distinct.empty() && key(distinct.back()) == key(order[i])) {
            sets.unite(distinct.back(), order[i]);
        } else {
            distinct.push_back(order[i]);
        }
    }
    return distinct;
}

} // namespace

Welded weld(std::span<const dem::Point> points, double snap)
{
    IndexSets sets(points.size());
    std::vector<Celled> cells;
    const double size = std::max(snap, 1e-9);
    for (const int i : distinct_points(sets, points)) {
        const dem::Point& p = points[i];
        cells.push_back({static_cast<std::int64_t>(std::floor(p.x / size)),
                         static_cast<std::int64_t>(std::floor(p.z / size)), i});
    }
    std::ranges::sort(cells);
    std::size_t pairs = 0;
    constexpr std::pair<int, int> kAhead[] = {{0, 0}, {0, 1}, {1, -1}, {1, 0}, {1, 1}};
    for (const Celled& from : cells)
        for (const auto& [right, up] : kAhead)
            unite_neighbours(sets, points, cells, from, right, up, snap, pairs);
    Welded welded;
    for (std::size_t i = 0; i < points.size(); ++i) {
        welded.node.push_back(sets.first_of(static_cast<int>(i)));
        const double moved = distance(points[i], points[welded.node[i]]);
        if (moved > 1e-9) ++welded.moved;
        if (moved <= welded.farthest) continue;
        welded.farthest = moved;
        welded.farthest_point = i;
    }
    return welded;
}

double distance(dem::Point a, dem::Point b) { return std::hypot(b.x - a.x, b.z - a.z); }

OnSegment nearest_on_segment(dem::Point p, dem::Point a, dem::Point b)
{
    const double dx = b.x - a.x, dz = b.z - a.z, length2 = dx * dx + dz * dz;
    const double share =
        length2 > 0.0 ? std::clamp(((p.x - a.x) * dx + (p.z - a.z) * dz) / length2, 0.0, 1.0)
                      : 0.0;
    return {share, distance(p, {a.x + share * dx, a.z + share * dz})};
}

std::vector<std::vector<int>> nodes_on_sides(std::span<const dem::Point> nodes,
                                             std::span<const Side> sides, double snap)
{
    const PlaneGrid grid(nodes);
    std::vector<char> used(nodes.size());
    for (const Side& side : sides) used[side.a] = used[side.b] = 1;
    std::vector<std::pair<std::size_t, int>> entries;
    for (std::size_t i = 0; i < nodes.size(); ++i)
        if (used[i]) entries.emplace_back(grid.cell_of(nodes[i]), static_cast<int>(i));
    const CellLists lists(grid.cells(), entries);
    std::vector<std::vector<int>> found(sides.size());
    std::vector<std::pair<double, int>> on_side;
    std::size_t pairs = 0;
    for (std::size_t s = 0; s < sides.size(); ++s) {
        const dem::Point a = nodes[sides[s].a], b = nodes[sides[s].b];
        on_side.clear();
        grid.visit_segment(a, b, snap, [&](std::size_t cell) {
            pairs += 1 + lists[cell].size();
            if (pairs > kMostPairs) throw TooCrowded(a);
            for (const int n : lists[cell]) {
                if (n == sides[s].a || n == sides[s].b) continue;
                const OnSegment on = nearest_on_segment(nodes[n], a, b);
                if (on.distance <= snap) on_side.emplace_back(on.share, n);
            }
        });
        std::ranges::sort(on_side);
        for (const auto& [share, n] : on_side) found[s].push_back(n);
    }
    return found;
}

std::vector<Crossing> all_crossings(std::span<const dem::Point> nodes,
                                    std::span<const Side> sides)
{
    const PlaneGrid grid(nodes);
    const auto at = [&](int i) { return nodes[i]; };
    std::vector<std::pair<std::size_t, int>> entries;
    for (std::size_t s = 0; s < sides.size(); ++s) {
        grid.visit_segment(at(sides[s].a), at(sides[s].b), 0.0, [&](std::size_t cell) {
            if (entries.size() >= kMostPairs / 4) throw TooCrowded(at(sides[s].a));
            entries.emplace_back(cell, static_cast<int>(s));
        });
    }
    const CellLists lists(grid.cells(), entries);
    std::vector<Crossing> found;
    std::size_t pairs = 0;
    const auto compare = [&](int i, int j) {
        const Side &s = sides[i], &t = sides[j];
        if (++pairs > kMostPairs || found.size() > 1'000'000) throw TooCrowded(at(s.a));
        if (s.a == t.a || s.a == t.b || s.b == t.a || s.b == t.b) return;
        const double ta = turn(at(s.a), at(s.b), at(t.a)), tb = turn(at(s.a), at(s.b), at(t.b));
        const double sa = turn(at(t.a), at(t.b), at(s.a)), sb = turn(at(t.a), at(t.b), at(s.b));
        if ((ta > 0.0) == (tb > 0.0) || (sa > 0.0) == (sb > 0.0)) return;
        const double share = ta / (ta - tb);
        const dem::Point a = at(t.a), b = at(t.b);
        found.push_back({i, j, {a.x + share * (b.x - a.x), a.z + share * (b.z - a.z)}});
    };
    for (std::size_t cell = 0; cell < lists.cells(); ++cell) {
        const std::span<const int> here = lists[cell];
        for (std::size_t i = 0; i < here.size(); ++i)
            for (std::size_t j = i + 1; j < here.size(); ++j) compare(here[i], here[j]);
    }
    const auto key = [](const Crossing& c) { return std::pair(c.first, c.second); };
    std::ranges::sort(found, [&](const auto& c, const auto& d) { return key(c) < key(d); });
    found.erase(std::unique(found.begin(), found.end(),
                            [&](const auto& c, const auto& d) { return key(c) == key(d); }),
                found.end());
    return found;
}

std::optional<Crossing> first_crossing(std::span<const dem::Point> nodes,
                                       std::span<const Side> sides)
{
    const std::vector<Crossing> all = all_crossings(nodes, sides);
    if (all.empty()) return {};
    return all.front();
}

} // namespace app
