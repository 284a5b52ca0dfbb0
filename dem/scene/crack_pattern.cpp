#include "dem/scene/crack_pattern.hpp"

#include "dem/scene/geometry/clip.hpp"
#include "dem/scene/geometry/site_grid.hpp"
#include "dem/scene/piece_count.hpp"

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

/// Cuts strips off the pieces, one after the other: what is left shrinks.
/// @param line_at(i) a point of the line between strips i and i + 1, from 1
/// @param normal unit vector from strip to strip
std::vector<Outline> strips(std::vector<Outline> rest, int n, const auto& line_at, Point normal)
{
    std::vector<Outline> all;
    for (int i = 1; i < n; ++i) {
        const Point at = line_at(i);
        for (Outline& part : clip(rest, {at, normal})) all.push_back(std::move(part));
        rest = clip(rest, {at, {-normal.x, -normal.z}});
    }
    for (Outline& part : rest) all.push_back(std::move(part));
    return all;
}

std::vector<Outline> grid(const Outline& outline, int columns, int rows)
{
    const Region e = extent_of(outline);
    const auto right = [&](int i) { return Point{e.x0 + i * (e.x1 - e.x0) / columns, e.z0}; };
    const auto up = [&](int i) { return Point{e.x0, e.z0 + i * (e.z1 - e.z0) / rows}; };
    return strips(strips({outline}, columns, right, {1.0, 0.0}), rows, up, {0.0, 1.0});
}

std::vector<Outline> diagonals(const Outline& outline)
{
    const Region e = extent_of(outline);
    const double w = e.x1 - e.x0, h = e.z1 - e.z0, d = std::hypot(w, h);
    return halved(halved({outline}, {e.x0, e.z0}, {-h / d, w / d}), {e.x0, e.z1},
                  {h / d, w / d});
}

double apart(Point a, Point b) { return std::hypot(a.x - b.x, a.z - b.z); }

/// Sites of random places that keep apart: of some candidates the one farthest from the others.
std::vector<Point> sites_in(const Outline& outline, std::size_t n, unsigned seed)
{
    constexpr int kCandidates = 20;
    std::mt19937_64 bits(seed);
    const auto uniform = [&] { return static_cast<double>(bits() >> 11U) * 0x1p-53; };
    const Region e = extent_of(outline);
    SiteGrid grid(e, n);
    std::vector<Point> sites;
    while (sites.size() < n) {
        Point best;
        double farthest = -1.0;
        for (int i = 0; i < kCandidates;) {
            const double x = e.x0 + uniform() * (e.x1 - e.x0);
            const double z = e.z0 + uniform() * (e.z1 - e.z0);
            if (!is_inside(outline, {x, z})) continue;
            ++i;
            const double nearest = grid.nearest({x, z}, sites);
            if (nearest <= farthest) continue;
            farthest = nearest;
            best = {x, z};
        }
        grid.add(best, sites.size());
        sites.push_back(best);
    }
    return sites;
}

/// Farthest corner of a cell from its site [m].
double reach_of(const std::vector<Outline>& cell, Point site)
{
    double reach = 0.0;
    for (const Outline& part : cell)
        for (const Point p : part) reach = std::max(reach, apart(p, site));
    return reach;
}

/// Sites are taken from the nearest on; those beyond twice the reach of the cell cannot cut it.
std::vector<Outline> cell_of(const Outline& outline, const std::vector<Point>& sites,
                             const SiteGrid& grid, std::size_t i)
{
    const Point site = sites[i];
    std::vector<Outline> cell{outline};
    double from = -1.0, to = 3.0 * grid.side();
    while (from < 2.0 * reach_of(cell, site)) {
        for (const auto& [d, j] : grid.between(from, to, i, sites)) {
            if (d > 2.0 * reach_of(cell, site)) break;
            const Point other = sites[j];
            cell = clip(cell, {{0.5 * (site.x + other.x), 0.5 * (site.z + other.z)},
                               {(other.x - site.x) / d, (other.z - site.z) / d}});
        }
        from = to;
        to *= 2.0;
    }
    return cell;
}

/// Cells of about this size.
std::size_t cells_in(double area, double size)
{
    return static_cast<std::size_t>(std::max(1LL, std::llround(area / (size * size))));
}

std::vector<Outline> voronoi(const Outline& outline, double size, unsigned seed)
{
    constexpr int kRounds = 3; // in which a site moves to the middle of its cell
    const std::size_t n = cells_in(polygon_area(outline), size);
    std::vector<Point> sites = sites_in(outline, n, seed);
    std::vector<Outline> pieces;
    for (int round = 0; round <= kRounds; ++round) {
        pieces.clear();
        SiteGrid near(extent_of(outline), n);
        for (std::size_t i = 0; i < n; ++i) near.add(sites[i], i);
        std::vector<Point> middles = sites;
        for (std::size_t i = 0; i < sites.size(); ++i) {
            std::vector<Outline> cell = cell_of(outline, sites, near, i);
            if (cell.size() == 1) middles[i] = polygon_centre(cell.front());
            for (Outline& part : cell) pieces.push_back(std::move(part));
        }
        sites = middles;
    }
    return pieces;
}

/// Length over that of a whole unit [-].
double share_of_unit(const Outline& outline, double unit_length)
{
    const Region e = extent_of(outline);
    return unit_length > 0.0 ? (e.x1 - e.x0) / unit_length : 1.0;
}

bool is_whole(double share, double unit_length)
{
    return (share - 1.0) * unit_length > -kRounding;
}

int columns_of(const CrackPattern& pattern, double share)
{
    return std::max(1, static_cast<int>(std::lround(share * pattern.columns)));
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

double piece_count(const Outline& outline, const CrackPattern& pattern, double unit_length)
{
    const double share = share_of_unit(outline, unit_length);
    switch (pattern.kind) {
    case CrackPattern::Kind::none:
        return 1.0;
    case CrackPattern::Kind::mid:
        return is_whole(share, unit_length) ? 2.0 : 1.0;
    case CrackPattern::Kind::grid:
        return static_cast<double>(columns_of(pattern, share)) * pattern.rows;
    case CrackPattern::Kind::diagonals:
        return 4.0;
    case CrackPattern::Kind::voronoi:
        return static_cast<double>(cells_in(polygon_area(outline), pattern.size));
    }
    return 1.0;
}

std::vector<Outline> pieces_of(const Outline& outline, const CrackPattern& pattern,
                               double unit_length, unsigned seed)
{
    const double share = share_of_unit(outline, unit_length);
    std::vector<Outline> pieces{outline};
    switch (pattern.kind) {
    case CrackPattern::Kind::none:
        break;
    case CrackPattern::Kind::mid:
        if (is_whole(share, unit_length)) pieces = grid(outline, 2, 1);
        break;
    case CrackPattern::Kind::grid:
        pieces = grid(outline, columns_of(pattern, share), pattern.rows);
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
