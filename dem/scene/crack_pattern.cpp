#include "dem/scene/crack_pattern.hpp"

#include "dem/scene/clip.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <tuple>
#include <utility>

namespace dem {

namespace {

constexpr double kRounding = 1e-6; // [m]

/// Both sides of a line, of all the pieces.
std::vector<Outline> halved(const std::vector<Outline>& pieces, Point at, Point normal)
{
    std::vector<Outline> all = clip(pieces, {at, normal});
    for (Outline& part : clip(pieces, {at, {-normal.x, -normal.z}}))
        all.push_back(std::move(part));
    return all;
}

std::vector<Outline> grid(const Outline& outline, int columns, int rows)
{
    const Region e = extent_of(outline);
    std::vector<Outline> pieces{outline};
    for (int i = 1; i < columns; ++i)
        pieces = halved(pieces, {e.x0 + i * (e.x1 - e.x0) / columns, e.z0}, {1.0, 0.0});
    for (int i = 1; i < rows; ++i)
        pieces = halved(pieces, {e.x0, e.z0 + i * (e.z1 - e.z0) / rows}, {0.0, 1.0});
    return pieces;
}

std::vector<Outline> diagonals(const Outline& outline)
{
    const Region e = extent_of(outline);
    const double w = e.x1 - e.x0, h = e.z1 - e.z0, d = std::hypot(w, h);
    return halved(halved({outline}, {e.x0, e.z0}, {-h / d, w / d}), {e.x0, e.z1},
                  {h / d, w / d});
}

/// Sites of random places that keep apart: of some candidates the one farthest from the others.
std::vector<Point> sites_in(const Outline& outline, std::size_t n, unsigned seed)
{
    constexpr int kCandidates = 20;
    std::mt19937_64 bits(seed);
    const auto uniform = [&] { return static_cast<double>(bits() >> 11U) * 0x1p-53; };
    const Region e = extent_of(outline);
    std::vector<Point> sites;
    while (sites.size() < n) {
        Point best;
        double farthest = -1.0;
        for (int i = 0; i < kCandidates;) {
            const double x = e.x0 + uniform() * (e.x1 - e.x0);
            const double z = e.z0 + uniform() * (e.z1 - e.z0);
            if (!is_inside(outline, {x, z})) continue;
            ++i;
            double nearest = INFINITY;
            for (const Point s : sites)
                nearest = std::min(nearest, std::hypot(x - s.x, z - s.z));
            if (nearest <= farthest) continue;
            farthest = nearest;
            best = {x, z};
        }
        sites.push_back(best);
    }
    return sites;
}

/// Farthest corner of a cell from its site [m].
double reach_of(const std::vector<Outline>& cell, Point site)
{
    double reach = 0.0;
    for (const Outline& part : cell)
        for (const Point p : part)
            reach = std::max(reach, std::hypot(p.x - site.x, p.z - site.z));
    return reach;
}

/// Sites are taken from the nearest on; those beyond twice the reach of the cell cannot cut it.
std::vector<Outline> cell_of(const Outline& outline, const std::vector<Point>& sites,
                             std::size_t i)
{
    const Point site = sites[i];
    std::vector<std::pair<double, std::size_t>> others;
    for (std::size_t j = 0; j < sites.size(); ++j)
        if (j != i)
            others.emplace_back(std::hypot(sites[j].x - site.x, sites[j].z - site.z), j);
    std::ranges::sort(others);
    std::vector<Outline> cell{outline};
    for (const auto& [d, j] : others) {
        if (d > 2.0 * reach_of(cell, site)) break;
        const Point other = sites[j];
        cell = clip(cell, {{0.5 * (site.x + other.x), 0.5 * (site.z + other.z)},
                           {(other.x - site.x) / d, (other.z - site.z) / d}});
    }
    return cell;
}

std::vector<Outline> voronoi(const Outline& outline, double size, unsigned seed)
{
    constexpr int kRounds = 3; // in which a site moves to the middle of its cell
    const auto n = static_cast<std::size_t>(
        std::max(1L, std::lround(polygon_area(outline) / (size * size))));
    std::vector<Point> sites = sites_in(outline, n, seed);
    std::vector<Outline> pieces;
    for (int round = 0; round <= kRounds; ++round) {
        pieces.clear();
        std::vector<Point> middles = sites;
        for (std::size_t i = 0; i < sites.size(); ++i) {
            std::vector<Outline> cell = cell_of(outline, sites, i);
            if (cell.size() == 1) middles[i] = polygon_centre(cell.front());
            for (Outline& part : cell) pieces.push_back(std::move(part));
        }
        sites = middles;
    }
    return pieces;
}

} // namespace

const CrackPattern& pattern_at(const UnitCracks& cracks, Point middle)
{
    const auto holds = [middle](const Region& r) {
        return middle.x > r.x0 && middle.x < r.x1 && middle.z > r.z0 && middle.z < r.z1;
    };
    const bool within = cracks.where.empty() || std::ranges::any_of(cracks.where, holds);
    return within ? cracks.pattern : cracks.elsewhere;
}

bool shares_stiffness(const CrackPattern& p)
{
    using Kind = CrackPattern::Kind;
    return p.kind == Kind::diagonals || p.kind == Kind::voronoi ||
           (p.kind == Kind::grid && p.rows > 1);
}

std::vector<Outline> pieces_of(const Outline& outline, const CrackPattern& pattern,
                               double unit_length, unsigned seed)
{
    const Region e = extent_of(outline);
    const double share = unit_length > 0.0 ? (e.x1 - e.x0) / unit_length : 1.0;
    std::vector<Outline> pieces{outline};
    switch (pattern.kind) {
    case CrackPattern::Kind::none:
        break;
    case CrackPattern::Kind::mid:
        if ((share - 1.0) * unit_length > -kRounding) pieces = grid(outline, 2, 1);
        break;
    case CrackPattern::Kind::grid:
        pieces =
            grid(outline, std::max(1, static_cast<int>(std::lround(share * pattern.columns))),
                 pattern.rows);
        break;
    case CrackPattern::Kind::diagonals:
        pieces = diagonals(outline);
        break;
    case CrackPattern::Kind::voronoi:
        pieces = voronoi(outline, pattern.size, seed);
        break;
    }
    std::ranges::stable_sort(pieces, {}, [](const Outline& piece) {
        const Point c = polygon_centre(piece);
        return std::tuple(std::llround(c.z / kRounding), std::llround(c.x / kRounding));
    });
    return pieces;
}

} // namespace dem
