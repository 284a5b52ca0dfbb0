#include "dem/scene/bond_indices.hpp"

#include "dem/scene/touching.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <queue>
#include <stdexcept>
#include <utility>
#include <vector>

namespace dem {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
constexpr double kNoEnd = std::numeric_limits<double>::infinity();

/// Ends of faces. Those that a piece of joint left out lies between are one.
class Ends {
  public:
    std::size_t number_of(Point p)
    {
        const auto cell = [](double x) { return std::llround(x / kCell); };
        const auto cx = cell(p.x), cz = cell(p.z);
        for (auto x = cx - 1; x <= cx + 1; ++x)
            for (auto z = cz - 1; z <= cz + 1; ++z)
                if (const auto at = cells_.find({x, z}); at != cells_.end())
                    for (const std::size_t k : at->second)
                        if (std::hypot(points[k].x - p.x, points[k].z - p.z) < kCell) return k;
        cells_[{cx, cz}].push_back(points.size());
        points.push_back(p);
        return points.size() - 1;
    }

    static constexpr double kCell = 1.01 * kShortestFace; // [m]
    std::vector<Point> points;

  private:
    std::map<std::pair<long long, long long>, std::vector<std::size_t>> cells_;
};

struct Way {
    std::size_t to;
    double length;
};

/// Dijkstra's shortest way through joints.
/// @param begins, arrives what a way that begins or ends at a point has to go besides [m];
/// kNoEnd where it cannot
template <class Begins, class Arrives>
double least_trace(const Layout& layout, Begins begins, Arrives arrives)
{
    Ends ends;
    std::vector<std::vector<Way>> ways;
    for (const Face& f : layout.faces) {
        if (f.kind != FaceKind::bed_joint && f.kind != FaceKind::head_joint) continue;
        const std::size_t a = ends.number_of(f.from), b = ends.number_of(f.to);
        ways.resize(ends.points.size());
        const double length = std::hypot(f.to.x - f.from.x, f.to.z - f.from.z);
        ways[a].push_back({b, length});
        ways[b].push_back({a, length});
    }
    using Place = std::pair<double, std::size_t>;
    std::priority_queue<Place, std::vector<Place>, std::greater<>> open;
    std::vector<double> length(ways.size(), kNoEnd);
    for (std::size_t k = 0; k < ways.size(); ++k) {
        length[k] = begins(ends.points[k]);
        if (length[k] < kNoEnd) open.emplace(length[k], k);
    }
    double least = kNoEnd;
    while (!open.empty()) {
        const auto [so_far, k] = open.top();
        open.pop();
        if (so_far >= least) break;
        if (so_far > length[k]) continue;
        least = std::min(least, so_far + arrives(ends.points[k]));
        for (const Way& w : ways[k])
            if (so_far + w.length < length[w.to])
                open.emplace(length[w.to] = so_far + w.length, w.to);
    }
    return least < kNoEnd ? least : kUnknown;
}

/// Whether a unit lies above the point, or below it.
bool covered(const Layout& layout, Point p, bool above)
{
    for (int b = 0; b < layout.beam; ++b) {
        const std::vector<Point> o = corners_of(layout.blocks[b]);
        for (std::size_t i = 0; i < o.size(); ++i) {
            const Point a = o[i], b = o[(i + 1) % o.size()];
            if ((a.x > p.x) == (b.x > p.x)) continue;
            const double z = a.z + (p.x - a.x) / (b.x - a.x) * (b.z - a.z);
            if (above ? z > p.z + Ends::kCell : z < p.z - Ends::kCell) return true;
        }
    }
    return false;
}

/// Way that a joint that ends at p lacks to a level where walls end, their floor or their top
/// [m]. Where that is uneven, joints end a little before it: less than half a unit from it,
/// with nothing between on one side. The ends of the wall are no such side.
/// @param first, last ends of the wall [m]
double way_to_end(const Layout& layout, Point p, double level, double half_unit, double first,
                  double last)
{
    const double lack = std::abs(level - p.z);
    if (lack < Ends::kCell) return 0.0;
    if (lack > half_unit) return kNoEnd;
    for (const double x : {p.x - Ends::kCell, p.x + Ends::kCell})
        if (x > first && x < last && !covered(layout, {x, p.z}, level > p.z)) return lack;
    return kNoEnd;
}

bool of_rectangles(const Layout& layout)
{
    return std::ranges::all_of(layout.blocks, [](const Block& b) { return b.outline.empty(); });
}

bool share_a_block(const Face& f, const Face& g)
{
    return f.a == g.a || f.a == g.b || f.b == g.a || f.b == g.b;
}

/// Overlaps of each head joint with the head joints that begin above it [m].
std::vector<double> overlaps(const Layout& layout)
{
    std::map<long long, std::vector<const Face*>> beginning; // by level
    const auto level = [](double z) { return std::llround(z / Ends::kCell); };
    for (const Face& f : layout.faces)
        if (f.kind == FaceKind::head_joint)
            beginning[level(std::min(f.from.z, f.to.z))].push_back(&f);
    std::vector<double> found;
    for (const Face& f : layout.faces) {
        if (f.kind != FaceKind::head_joint) continue;
        double least = kNoEnd;
        const long long top = level(std::max(f.from.z, f.to.z));
        for (long long l = top - 1; l <= top + 1; ++l)
            if (const auto at = beginning.find(l); at != beginning.end())
                for (const Face* g : at->second)
                    if (g != &f && !share_a_block(f, *g))
                        least = std::min(least, std::abs(g->from.x - f.from.x));
        if (least < kNoEnd) found.push_back(least);
    }
    return found;
}

} // namespace

BondIndices bond_indices(const Layout& layout)
{
    if (layout.beam < 1 || layout.n_cracks > 0)
        throw std::invalid_argument("bond indices: the layout must have units without cracks");
    BondIndices indices;
    double first = kNoEnd, last = -kNoEnd;
    for (int b = 0; b < layout.beam; ++b) {
        const Block& unit = layout.blocks[b];
        first = std::min(first, unit.x0);
        last = std::max(last, unit.x1);
        indices.mean_length += (unit.x1 - unit.x0) / layout.beam;
        indices.mean_height += (unit.z1 - unit.z0) / layout.beam;
    }
    const auto to = [&](Point p, double level) {
        return way_to_end(layout, p, level, 0.5 * indices.mean_height, first, last);
    };
    indices.trace = least_trace(
        layout, [&](Point p) { return to(p, 0.0); },
        [&](Point p) { return to(p, layout.height); });
    indices.trace_ratio = indices.trace / layout.height;
    const auto there = [](bool at_end) { return at_end ? 0.0 : kNoEnd; };
    const double level_trace = least_trace(
        layout, [&](Point p) { return there(p.x < first + Ends::kCell); },
        [&](Point p) { return there(p.x > last - Ends::kCell); });
    indices.level_trace_ratio = level_trace / (last - first);
    indices.least_overlap = indices.mean_overlap = kUnknown;
    const std::vector<double> found =
        of_rectangles(layout) ? overlaps(layout) : std::vector<double>{};
    if (found.empty()) return indices;
    double sum = 0.0;
    for (const double x : found) sum += x;
    indices.least_overlap = *std::ranges::min_element(found) / indices.mean_height;
    indices.mean_overlap = sum / static_cast<double>(found.size()) / indices.mean_height;
    return indices;
}

} // namespace dem
