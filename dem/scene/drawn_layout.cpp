#include "dem/scene/drawn_layout.hpp"

#include "dem/scene/cracked_layout.hpp"
#include "dem/scene/geometry/polygon.hpp"
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

/// Mean over the units by area.
template <class Extent> double mean_extent(const DrawnWall& wall, Extent extent)
{
    double sum = 0.0, area = 0.0;
    for (const DrawnUnit& u : wall.units) {
        const double own = polygon_area(u.outline);
        sum += own * extent(block_of(u.outline));
        area += own;
    }
    return sum / area;
}

/// Units from the bottom to the top and from left to right.
void add_blocks(const DrawnWall& wall, Layout& layout)
{
    struct Unit {
        Point centre;
        Block block;
    };
    std::vector<Unit> units;
    for (const DrawnUnit& u : wall.units) {
        Unit unit{polygon_centre(u.outline), block_of(u.outline)};
        unit.block.material = u.material;
        unit.block.layer = u.layer;
        unit.block.course =
            1 + static_cast<int>(std::floor(unit.centre.z / layout.course_height));
        units.push_back(std::move(unit));
    }
    std::ranges::stable_sort(units, [](const Unit& a, const Unit& b) {
        return std::tie(a.block.course, a.centre.x, a.centre.z) <
               std::tie(b.block.course, b.centre.x, b.centre.z);
    });
    for (Unit& u : units) {
        u.block.unit = static_cast<int>(layout.blocks.size()) + 1;
        layout.height = std::max(layout.height, u.block.z1);
        layout.blocks.push_back(std::move(u.block));
    }
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
    layout.lintels = wall.lintels;
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
    return with_cracks(std::move(layout), wall.cracks, wall.unit_length);
}

} // namespace dem
