#include "dem/scene/mechanism/piers.hpp"

#include "dem/scene/touching.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

namespace dem {
namespace {

double top_of(const Opening& o) { return o.z + o.height; }
bool crosses(const Opening& o, double z) { return o.z < z && z < top_of(o); }

/// The level that most of the openings cross: the middle of the lowest such stretch.
double busiest_level(const std::vector<Opening>& openings)
{
    std::vector<double> ends;
    for (const Opening& o : openings) {
        ends.push_back(o.z);
        ends.push_back(top_of(o));
    }
    std::ranges::sort(ends);
    double level = 0.0, height = 0.0;
    std::ptrdiff_t most = 0;
    for (std::size_t i = 1; i < ends.size(); ++i) {
        constexpr double kThin = 1e-3; // [m]
        if (ends[i] - ends[i - 1] < kThin) continue;
        const double z = 0.5 * (ends[i] + ends[i - 1]);
        const auto n =
            std::ranges::count_if(openings, [z](const Opening& o) { return crosses(o, z); });
        if (n < most || (n == most && ends[i] - ends[i - 1] <= height)) continue;
        most = n;
        level = z;
        height = ends[i] - ends[i - 1];
    }
    return level;
}

/// The piers at a level, between openings that it crosses.
/// @param row sorted from left to right
void add_storey(const std::vector<Opening>& row, double cut, const Region& wall,
                std::vector<Pier>& piers)
{
    constexpr double kNarrow = 1e-3; // [m]: an opening at the end of the wall leaves no pier
    double from = wall.x0, bottom = wall.z0, top = wall.z1;
    const auto add = [&](double to, double low, double high) {
        if (to - from > kNarrow)
            piers.push_back({{from, std::max(bottom, low), to, std::min(top, high)}, cut, 0});
    };
    for (const Opening& o : row) {
        add(o.x, o.z, top_of(o));
        from = o.x + o.width;
        bottom = o.z;
        top = top_of(o);
    }
    add(wall.x1, wall.z0, wall.z1);
}

Spandrel spandrel_above(const Opening& o, std::span<const Opening> all, const Region& wall)
{
    double top = wall.z1;
    for (const Opening& other : all)
        if (other.z > top_of(o) - kTouching && other.x < o.x + o.width &&
            o.x < other.x + other.width)
            top = std::min(top, other.z);
    return {{o.x, top_of(o), o.x + o.width, top}, o.x + 0.5 * o.width};
}

int block_at(const Layout& layout, Point at)
{
    for (std::size_t b = 0; b < layout.blocks.size(); ++b) {
        const Block& block = layout.blocks[b];
        if (at.x < block.x0 || at.x > block.x1 || at.z < block.z0 || at.z > block.z1) continue;
        if (is_inside(corners_of(block), at)) return static_cast<int>(b);
    }
    return kGround;
}

/// Displacement of a point that moves with the outline of a block as one body [m].
Point displacement(const BlockState& block, Point at)
{
    const auto n = static_cast<double>(block.outline.size());
    Point middle, moved;
    for (std::size_t p = 0; p < block.outline.size(); ++p) {
        middle = {middle.x + block.outline[p].x / n, middle.z + block.outline[p].z / n};
        moved = {moved.x + block.displacement[p].x / n, moved.z + block.displacement[p].z / n};
    }
    double turn = 0.0, along = 0.0;
    for (std::size_t p = 0; p < block.outline.size(); ++p) {
        const Point arm{block.outline[p].x - middle.x, block.outline[p].z - middle.z};
        const Point now{arm.x + block.displacement[p].x - moved.x,
                        arm.z + block.displacement[p].z - moved.z};
        turn += arm.z * now.x - arm.x * now.z;
        along += arm.x * now.x + arm.z * now.z;
    }
    const double size = std::hypot(turn, along), s = turn / size, c = along / size;
    const Point arm{at.x - middle.x, at.z - middle.z};
    return {moved.x + (c - 1.0) * arm.x + s * arm.z, moved.z + (c - 1.0) * arm.z - s * arm.x};
}

/// Sum of the forces that side 1 exerts on side 0 through contacts at places that count, and
/// their moment about `about`, clockwise.
struct SideForce {
    double x = 0.0, z = 0.0, moment = 0.0; ///< [N] [N m]
};

template <class Counts>
SideForce between_sides(const Snapshot& wall, const std::vector<char>& side, Point about,
                        Counts counts)
{
    SideForce sum;
    for (const FaceState& f : wall.faces) {
        const bool a = f.block_a >= 0 && side[static_cast<std::size_t>(f.block_a)] != 0,
                   b = side[static_cast<std::size_t>(f.block_b)] != 0;
        if (a == b) continue;
        const double sign = b ? 1.0 : -1.0; // stresses are those of b on a
        for (const ContactState& c : f.contacts) {
            if (!counts(f.kind, c.at)) continue;
            const double x = sign * c.area *
                             (c.mean_sigma * f.acting.x + c.mean_tau * f.acting.z),
                         z = sign * c.area *
                             (c.mean_sigma * f.acting.z - c.mean_tau * f.acting.x);
            sum.x += x;
            sum.z += z;
            sum.moment += (c.at.z - about.z) * x - (c.at.x - about.x) * z;
        }
    }
    return sum;
}

} // namespace

Piers piers_of(std::span<const Opening> openings, const Region& wall)
{
    Piers all;
    std::vector<Opening> left(openings.begin(), openings.end());
    while (!left.empty()) {
        const double cut = busiest_level(left);
        std::vector<Opening> row;
        for (const Opening& o : left)
            if (crosses(o, cut)) row.push_back(o);
        if (row.empty()) break; // openings without height
        std::erase_if(left, [&](const Opening& o) { return crosses(o, cut); });
        // One that an earlier storey has taken divides this one as well.
        for (const Opening& o : openings)
            if (crosses(o, cut) && std::ranges::find(row, o) == row.end()) row.push_back(o);
        std::ranges::sort(row, {}, &Opening::x);
        add_storey(row, cut, wall, all.piers);
    }
    std::ranges::stable_sort(all.piers, {}, &Pier::cut);
    int storey = 0;
    for (std::size_t i = 0; i < all.piers.size(); ++i) {
        if (i == 0 || all.piers[i].cut != all.piers[i - 1].cut) ++storey;
        all.piers[i].storey = storey;
    }
    for (const Opening& o : openings)
        if (top_of(o) < wall.z1 - kTouching)
            all.spandrels.push_back(spandrel_above(o, openings, wall));
    return all;
}

PierProbe::PierProbe(const Layout& layout, Piers piers) : piers_(std::move(piers))
{
    constexpr int kPlaces = 9;       // across an end
    constexpr double kInside = 2e-3; // [m] beyond its ends
    for (const Pier& p : piers_.piers) {
        PierParts parts;
        for (const Block& b : layout.blocks) {
            const Point middle = centre_of(b);
            parts.above.push_back(middle.z > p.cut);
            parts.within.push_back(middle.x > p.at.x0 && middle.x < p.at.x1 &&
                                   middle.z > p.at.z0 && middle.z < p.at.z1);
        }
        for (int i = 0; i < kPlaces; ++i) {
            const double x = p.at.x0 + (p.at.x1 - p.at.x0) * (i + 0.5) / kPlaces;
            const int under = block_at(layout, {x, p.at.z0 - kInside}),
                      over = block_at(layout, {x, p.at.z1 + kInside});
            parts.bottom.push_back({under, {x, p.at.z0}});
            if (over != kGround) parts.top.push_back({over, {x, p.at.z1}});
        }
        parts_.push_back(std::move(parts));
    }
    for (const Block& b : layout.blocks) off_floor_.push_back(b.z0 > kTouching);
    for (const Spandrel& s : piers_.spandrels) {
        SpandrelParts parts;
        for (const Block& b : layout.blocks) parts.right.push_back(centre_of(b).x > s.cut);
        for (int i = 0; i < kPlaces; ++i) {
            const double z = s.at.z0 + (s.at.z1 - s.at.z0) * (i + 0.5) / kPlaces;
            for (const auto& [x, beyond, places] :
                 {std::tuple(s.at.x0, -kInside, &parts.first_end),
                  std::tuple(s.at.x1, kInside, &parts.other)})
                if (const int block = block_at(layout, {x + beyond, z}); block != kGround)
                    places->push_back({block, {x, z}});
        }
        spandrels_.push_back(std::move(parts));
    }
}

/// Mean of the places, of which those on the ground stand still [m].
double PierProbe::movement(const std::vector<Place>& places, const Snapshot& wall,
                           double Point::*along)
{
    double sum = 0.0;
    for (const Place& p : places)
        if (p.block != kGround)
            sum += displacement(wall.blocks[static_cast<std::size_t>(p.block)], p.at).*along;
    return places.empty() ? 0.0 : sum / static_cast<double>(places.size());
}

PierState PierProbe::pier(std::size_t i, const Snapshot& wall) const
{
    const Pier& p = piers_.piers.at(i);
    const PierParts& parts = parts_.at(i);
    const Point middle{0.5 * (p.at.x0 + p.at.x1), p.cut};
    const SideForce f = between_sides(wall, parts.above, middle, [&](FaceKind, Point at) {
        return at.x >= p.at.x0 - kTouching && at.x <= p.at.x1 + kTouching;
    });
    return {{-f.z, f.x, f.moment},
            movement(parts.top, wall, &Point::x) - movement(parts.bottom, wall, &Point::x)};
}

SpandrelState PierProbe::spandrel(std::size_t i, const Snapshot& wall) const
{
    const Spandrel& s = piers_.spandrels.at(i);
    const Point middle{s.cut, 0.5 * (s.at.z0 + s.at.z1)};
    const SpandrelParts& parts = spandrels_.at(i);
    const SideForce f = between_sides(wall, parts.right, middle, [&](FaceKind kind, Point at) {
        return kind != FaceKind::beam_joint && at.z >= s.at.z0 - kTouching &&
               at.z <= s.at.z1 + kTouching;
    });
    return {{-f.x, -f.z, f.moment},
            movement(parts.first_end, wall, &Point::z) -
                movement(parts.other, wall, &Point::z)};
}

double PierProbe::base_shear(const Snapshot& wall) const
{
    return between_sides(wall, off_floor_, {}, [](FaceKind, Point) { return true; }).x;
}

Snapshot PierProbe::alone(std::size_t i, const Snapshot& wall) const
{
    const PierParts& parts = parts_.at(i);
    const Pier& p = piers_.piers.at(i);
    Snapshot s;
    s.displacement = pier(i, wall).displacement;
    const double foot = movement(parts.bottom, wall, &Point::x);
    std::vector<int> place(wall.blocks.size(), kGround);
    for (std::size_t b = 0; b < wall.blocks.size(); ++b) {
        if (parts.within[b] == 0) continue;
        place[b] = static_cast<int>(s.blocks.size());
        BlockState block = wall.blocks[b];
        for (Point& at : block.outline) at.z -= p.at.z0;
        for (Point& u : block.displacement) u.x -= foot;
        s.blocks.push_back(std::move(block));
    }
    for (const FaceState& f : wall.faces) {
        const int a = f.block_a < 0 ? kGround : place[static_cast<std::size_t>(f.block_a)],
                  b = place[static_cast<std::size_t>(f.block_b)];
        if (a == kGround && b == kGround) continue;
        if (f.kind == FaceKind::unit_crack && (a == kGround || b == kGround)) continue;
        s.faces.push_back(f);
        s.faces.back().block_a = a;
        s.faces.back().block_b = b;
    }
    return s;
}

double PierProbe::weight_above(std::size_t i, const Layout& layout, const Elastic& stone,
                               double gravity) const
{
    double weight = 0.0;
    for (std::size_t b = 0; b < layout.blocks.size(); ++b)
        if (parts_.at(i).above[b] != 0 && static_cast<int>(b) != layout.beam)
            weight += area_of(layout.blocks[b]) * layout.thickness * gravity *
                      stone_of(layout, static_cast<int>(b), stone, stone).density;
    return weight;
}

} // namespace dem
