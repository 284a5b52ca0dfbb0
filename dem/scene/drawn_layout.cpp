#include "dem/scene/drawn_layout.hpp"

#include "dem/scene/polygon.hpp"
#include "dem/scene/touching.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <tuple>
#include <utility>

namespace dem {

namespace {

void require(bool ok, const char* what)
{
    if (!ok) throw std::invalid_argument(what);
}

bool near(double a, double b) { return std::abs(a - b) < kTouching; }

/// Whether an outline is an upright rectangle; then its block needs no outline.
bool is_rectangle(const Block& b)
{
    if (!near(polygon_area(b.outline), (b.x1 - b.x0) * (b.z1 - b.z0))) return false;
    return std::ranges::all_of(b.outline, [&](Point p) {
        return (near(p.x, b.x0) || near(p.x, b.x1)) && (near(p.z, b.z0) || near(p.z, b.z1));
    });
}

Block block_of(std::vector<Point> outline, int material)
{
    Block b;
    const auto [left, right] = std::ranges::minmax(outline, {}, &Point::x);
    const auto [low, high] = std::ranges::minmax(outline, {}, &Point::z);
    b.x0 = left.x;
    b.x1 = right.x;
    b.z0 = low.z;
    b.z1 = high.z;
    b.material = material;
    b.outline = std::move(outline);
    if (is_rectangle(b)) b.outline.clear();
    return b;
}

/// Part of an outline on one side of a vertical line.
std::vector<Point> part(const std::vector<Point>& outline, double x, bool right)
{
    std::vector<Point> kept;
    const auto stays = [&](Point p) {
        return right ? p.x > x + kTouching : p.x < x - kTouching;
    };
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const Point a = outline[i], b = outline[(i + 1) % outline.size()];
        if (stays(a) || near(a.x, x)) kept.push_back(a);
        if ((a.x < x - kTouching && b.x > x + kTouching) ||
            (b.x < x - kTouching && a.x > x + kTouching))
            kept.push_back({x, a.z + (b.z - a.z) * (x - a.x) / (b.x - a.x)});
    }
    return kept;
}

/// How often a vertical line crosses an outline; a corner on the line counts as one crossing.
int crossings(const std::vector<Point>& outline, double x)
{
    int n = 0;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const Point a = outline[i], b = outline[(i + 1) % outline.size()];
        n += near(a.x, x);
        n += (a.x < x - kTouching && b.x > x + kTouching) ||
             (b.x < x - kTouching && a.x > x + kTouching);
    }
    return n;
}

struct UnitPiece {
    Block block;
    Point centre; ///< of the unit
};

std::vector<UnitPiece> pieces_of(const DrawnWall& wall, const DrawnUnit& unit)
{
    const Point centre = polygon_centre(unit.outline);
    Block whole = block_of(unit.outline, unit.material);
    const double middle = 0.5 * (whole.x0 + whole.x1);
    const bool cut = wall.cracks_in_units && wall.unit_length > 0.0 &&
                     whole.x1 - whole.x0 > wall.unit_length - kTouching &&
                     crossings(unit.outline, middle) == 2;
    if (!cut) return {{std::move(whole), centre}};
    return {{block_of(part(unit.outline, middle, false), unit.material), centre},
            {block_of(part(unit.outline, middle, true), unit.material), centre}};
}

/// Mean over the units by area.
template <class Extent> double mean_extent(const DrawnWall& wall, Extent extent)
{
    double sum = 0.0, area = 0.0;
    for (const DrawnUnit& u : wall.units) {
        const double own = polygon_area(u.outline);
        sum += own * extent(block_of(u.outline, 0));
        area += own;
    }
    return sum / area;
}

/// Units from the bottom to the top and from left to right; the pieces of one are neighbours.
void add_blocks(const DrawnWall& wall, Layout& layout)
{
    struct Unit {
        int course;
        double x, z;
        std::vector<UnitPiece> pieces;
    };
    std::vector<Unit> units;
    for (const DrawnUnit& u : wall.units) {
        Unit unit{0, 0.0, 0.0, pieces_of(wall, u)};
        const Point centre = unit.pieces.front().centre;
        unit.course = 1 + static_cast<int>(std::floor(centre.z / layout.course_height));
        unit.x = centre.x;
        unit.z = centre.z;
        units.push_back(std::move(unit));
    }
    std::ranges::stable_sort(units, [](const Unit& a, const Unit& b) {
        return std::tie(a.course, a.x, a.z) < std::tie(b.course, b.x, b.z);
    });
    int number = 0;
    for (Unit& u : units) {
        ++number;
        for (UnitPiece& piece : u.pieces) {
            Block& b = piece.block;
            b.course = u.course;
            b.unit = number;
            layout.height = std::max(layout.height, b.z1);
            layout.blocks.push_back(std::move(b));
        }
    }
}

/// The sides of a block at a level z, as x from and to; `up` for its upper sides.
std::vector<std::pair<double, double>> level_sides(const Block& b, double z, bool up)
{
    std::vector<std::pair<double, double>> sides;
    const std::vector<Point> corners = corners_of(b);
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Point p = corners[i], q = corners[(i + 1) % corners.size()];
        if (near(p.z, z) && near(q.z, z) && (up ? q.x < p.x : q.x > p.x))
            sides.emplace_back(std::min(p.x, q.x), std::max(p.x, q.x));
    }
    return sides;
}

void add_beam(double height, Layout& layout)
{
    double x0 = INFINITY, x1 = -INFINITY;
    for (const Block& b : layout.blocks)
        for (const auto& [from, to] : level_sides(b, layout.height, true)) {
            x0 = std::min(x0, from);
            x1 = std::max(x1, to);
        }
    require(x1 > x0, "a beam needs a level side at the top of the wall to lie on");
    layout.length = x1 - x0;
    Block beam;
    beam.x0 = x0;
    beam.x1 = x1;
    beam.z0 = layout.height;
    beam.z1 = layout.height + height;
    layout.blocks.push_back(beam);
}

/// Blocks on the floor are held there, or stand on a joint.
void add_base(Base base, Layout& layout)
{
    bool stands = false;
    for (int b = 0; b < layout.beam; ++b)
        for (const auto& [from, to] : level_sides(layout.blocks[b], 0.0, false)) {
            if (to - from < kShortestFace) continue;
            stands = true;
            if (base == Base::fixed)
                layout.blocks[b].motion = Motion::clamped_bottom;
            else
                layout.faces.push_back(
                    {FaceKind::base_joint, 0, kGround, b, {from, 0.0}, {to, 0.0}, {0.0, 1.0}});
        }
    require(stands, "nothing stands on the floor: no outline has a level side at the bottom");
}

void add_joints(Layout& layout)
{
    std::vector<Touch> touches = touching(layout.blocks);
    const auto order = [](const Touch& t) {
        const auto micron = [](double x) { return std::llround(x * 1e6); };
        return std::tuple(micron(0.5 * (t.from.z + t.to.z)), micron(0.5 * (t.from.x + t.to.x)),
                          t.a, t.b);
    };
    std::ranges::sort(touches, {}, order);
    for (const Touch& t : touches) {
        Face f;
        f.a = t.a;
        f.b = t.b;
        f.from = t.from;
        f.to = t.to;
        f.normal = t.normal;
        if (t.a == layout.beam || t.b == layout.beam) {
            f.kind = FaceKind::beam_joint;
        } else if (layout.blocks[t.a].unit == layout.blocks[t.b].unit) {
            f.kind = FaceKind::unit_crack;
            f.id = ++layout.n_cracks;
        } else {
            const bool level = std::abs(t.normal.z) >= std::abs(t.normal.x);
            f.kind = level ? FaceKind::bed_joint : FaceKind::head_joint;
            f.id = ++layout.n_joints;
        }
        layout.faces.push_back(f);
    }
}

} // namespace

Layout drawn_layout(const DrawnWall& wall, double beam_height)
{
    require(!wall.units.empty(), "a wall needs at least one outline");
    require(wall.thickness > 0.0, "a wall needs a positive thickness");
    for (const DrawnUnit& u : wall.units)
        require(u.outline.size() >= 3 && polygon_area(u.outline) > 0.0,
                "an outline needs three corners that run counter-clockwise");
    Layout layout;
    layout.coursed = false;
    layout.thickness = wall.thickness;
    layout.stones = wall.stones;
    layout.course_height = mean_extent(wall, [](const Block& b) { return b.z1 - b.z0; });
    const double unit = wall.unit_length > 0.0
                            ? wall.unit_length
                            : mean_extent(wall, [](const Block& b) { return b.x1 - b.x0; });
    layout.half_unit = 0.5 * unit;
    add_blocks(wall, layout);
    layout.beam = static_cast<int>(layout.blocks.size());
    double first = INFINITY, last = -INFINITY;
    for (const Block& b : layout.blocks) {
        first = std::min(first, b.x0);
        last = std::max(last, b.x1);
    }
    layout.length = last - first;
    layout.courses =
        std::max(1, static_cast<int>(std::lround(layout.height / layout.course_height)));
    if (beam_height > 0.0) add_beam(beam_height, layout);
    add_base(wall.base, layout);
    add_joints(layout);
    return layout;
}

} // namespace dem
