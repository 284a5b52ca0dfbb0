#include "dem/scene/layout.hpp"

#include "dem/scene/bond.hpp"
#include "dem/scene/cracked_layout.hpp"
#include "dem/scene/geometry/polygon.hpp"
#include "dem/scene/lintels.hpp"
#include "dem/scene/standing.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <stdexcept>
#include <string>
#include <utility>

namespace dem {

namespace {

void check_bond(const WallGeometry& wall)
{
    if (!(wall.bond_offset >= 0 && wall.bond_offset < 1))
        throw std::invalid_argument("bond offset must be in [0, 1) unit lengths");
    if (!(wall.header_length > 0)) throw std::invalid_argument("headers need a length");
    const std::size_t heights = wall.course_heights.size();
    if (heights > 0 && heights != static_cast<std::size_t>(wall.courses))
        throw std::invalid_argument("each course needs a height of its own, or none");
    if (!std::ranges::all_of(wall.course_heights, [](double h) { return h > 0; }))
        throw std::invalid_argument("the height of a course must be positive");
    if (wall.length_cov != 0.0 && !(wall.length_cov > 0.0 && wall.bond == Bond::shifted &&
                                    wall.length_cov <= most_length_cov(wall)))
        throw std::invalid_argument("units of random lengths must keep their bond");
}

/// Whether a height is that of the floor, or of the top of a course.
bool is_level(const WallGeometry& wall, double z)
{
    for (int c = 0; c <= wall.courses; ++c)
        if (std::abs(top_of_course(wall, c) - z) < kSmallestPiece) return true;
    return false;
}

std::string metres(double length)
{
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.6g m", length);
    return text.data();
}

/// "opening 2 (0.4 m, 0 m, 0.6 m, 1.2 m)": its number from 1, x, z, width and height.
std::string name_of(const WallGeometry& wall, const Opening& o)
{
    return "opening " + std::to_string(&o - wall.openings.data() + 1) + " (" + metres(o.x) +
           ", " + metres(o.z) + ", " + metres(o.width) + ", " + metres(o.height) + ")";
}

/// The floor or top of a course below a height that is neither, and that above.
std::string nearest_levels(const WallGeometry& wall, double z)
{
    int c = 1;
    while (c < wall.courses - 1 && top_of_course(wall, c) < z) ++c;
    return metres(top_of_course(wall, c - 1)) + " or " + metres(top_of_course(wall, c));
}

void check_level(const WallGeometry& wall, const Opening& o, double z, const char* what)
{
    if (!is_level(wall, z))
        throw std::invalid_argument(
            name_of(wall, o) + " must begin and end between two courses; it " + what +
            " at z = " + metres(z) + ": " + nearest_levels(wall, z) + " would fit");
}

void check(const WallGeometry& wall)
{
    if (!(wall.courses >= 1 && wall.length > 0 && wall.thickness > 0 &&
          wall.course_height > 0 && wall.unit_length > 0))
        throw std::invalid_argument("a wall needs positive sizes and at least one course");
    check_bond(wall);
    const double last = top_of_course(wall, wall.courses - 1);
    for (const Opening& o : wall.openings) {
        if (!(o.width > 0 && o.height > 0 && o.x > -kSmallestPiece &&
              o.x + o.width < wall.length + kSmallestPiece && o.z > -kSmallestPiece &&
              o.z + o.height < last + kSmallestPiece))
            throw std::invalid_argument(
                name_of(wall, o) + " must lie within the wall, from x = 0 to " +
                metres(wall.length) + ", and below its top course, from z = 0 to " +
                metres(last));
        check_level(wall, o, o.z, "begins");
        check_level(wall, o, o.z + o.height, "ends");
        for (const Opening& p : wall.openings)
            if (&p != &o && o.x < p.x + p.width - kSmallestPiece &&
                p.x < o.x + o.width - kSmallestPiece && o.z < p.z + p.height - kSmallestPiece &&
                p.z < o.z + o.height - kSmallestPiece)
                throw std::invalid_argument("two openings overlap");
    }
}

Block rectangle(double x0, double x1, double z0, double z1, int course, int unit)
{
    Block b;
    b.x0 = x0;
    b.x1 = x1;
    b.z0 = z0;
    b.z1 = z1;
    b.course = course;
    b.unit = unit;
    return b;
}

Motion support_of(const WallGeometry& wall, const Block& b)
{
    const bool left = wall.toe_at_left;
    const bool toe = wall.toe == Toe::held && (left ? b.x0 == 0.0 : b.x1 == wall.length);
    if (wall.base == Base::fixed)
        return !toe   ? Motion::clamped_bottom
               : left ? Motion::clamped_bottom_held_left
                      : Motion::clamped_bottom_held_right;
    return !toe ? Motion::free : left ? Motion::held_left_corner : Motion::held_right_corner;
}

/// Takes [from, to] out of the pieces of a course.
std::vector<CoursePiece> without(const std::vector<CoursePiece>& pieces, double from, double to)
{
    std::vector<CoursePiece> left;
    for (const CoursePiece& p : pieces) {
        const bool apart = p.x1 < from + kSmallestPiece || p.x0 > to - kSmallestPiece;
        if (apart) left.push_back(p);
        if (!apart && from - p.x0 > kSmallestPiece)
            left.push_back({p.x0, from, false, p.material});
        if (!apart && p.x1 - to > kSmallestPiece) left.push_back({to, p.x1, false, p.material});
    }
    return left;
}

bool equal_lengths(double a, double b) { return std::abs(a - b) < kSmallestPiece; }

/// The pieces of a course that openings and lintels leave, and these lintels.
std::vector<CoursePiece> pieces_of(const WallGeometry& wall, int course)
{
    const double z0 = top_of_course(wall, course - 1), z1 = top_of_course(wall, course);
    std::vector<CoursePiece> pieces = bonded_course(wall, course);
    for (const Lintel& l : lintels_of(wall, course)) {
        pieces = without(pieces, l.x0, l.x1);
        pieces.push_back({l.x0, l.x1, false, 1});
    }
    for (const Opening& o : wall.openings)
        if (o.z < z0 + kSmallestPiece && o.z + o.height > z1 - kSmallestPiece)
            pieces = without(pieces, o.x, o.x + o.width);
    std::ranges::sort(pieces, {}, &CoursePiece::x0);
    if (wall.length_cov > 0.0) join_slivers(pieces);
    return pieces;
}

void add_course(const WallGeometry& wall, int course, int& unit, Layout& layout)
{
    const double z0 = top_of_course(wall, course - 1), z1 = top_of_course(wall, course);
    for (const CoursePiece& p : pieces_of(wall, course)) {
        ++unit;
        const double middle = 0.5 * (p.x0 + p.x1);
        const CrackPattern& cracks = pattern_at(wall.cracks, {middle, 0.5 * (z0 + z1)});
        if (p.whole && cracks.kind == CrackPattern::Kind::mid) {
            layout.blocks.push_back(rectangle(p.x0, middle, z0, z1, course, unit));
            layout.blocks.push_back(rectangle(middle, p.x1, z0, z1, course, unit));
        } else {
            layout.blocks.push_back(rectangle(p.x0, p.x1, z0, z1, course, unit));
        }
        layout.blocks.back().material = p.material;
    }
}

/// Cracks and head joints between neighbours of one course.
void add_vertical_faces(int first, int last, Layout& layout)
{
    for (int b = first + 1; b < last; ++b) {
        const Block& right = layout.blocks[b];
        if (!equal_lengths(layout.blocks[b - 1].x1, right.x0))
            continue; // an opening between them
        const bool same_unit = layout.blocks[b - 1].unit == right.unit;
        const int id = same_unit ? ++layout.n_cracks : ++layout.n_joints;
        layout.faces.push_back({same_unit ? FaceKind::unit_crack : FaceKind::head_joint,
                                id,
                                b - 1,
                                b,
                                {right.x0, right.z0},
                                {right.x0, right.z1},
                                {1.0, 0.0}});
    }
}

/// Overlaps of the blocks [a0, a1) below with the blocks [b0, b1) above, at height z.
void add_bed_faces(int a0, int a1, int b0, int b1, FaceKind kind, Layout& layout)
{
    for (int a = a0, b = b0; a < a1 && b < b1;) {
        const Block &below = layout.blocks[a], &above = layout.blocks[b];
        const double x0 = std::max(below.x0, above.x0), x1 = std::min(below.x1, above.x1);
        if (x1 - x0 > kShortestFace) {
            const int id = kind == FaceKind::bed_joint ? ++layout.n_joints : 0;
            layout.faces.push_back(
                {kind, id, a, b, {x0, above.z0}, {x1, above.z0}, {0.0, 1.0}});
        }
        if (below.x1 < above.x1 + kSmallestPiece) ++a;
        if (above.x1 < below.x1 + kSmallestPiece) ++b;
    }
}

/// Whether an outline is the upright rectangle of its extent. Its sides may have the corners of
/// neighbours on them.
bool is_rectangle(const std::vector<Point>& outline, const Block& b)
{
    const auto near = [](double p, double q) { return std::abs(p - q) < kTouching; };
    const auto at_x = [&](Point p) { return near(p.x, b.x0) || near(p.x, b.x1); };
    const auto at_z = [&](Point p) { return near(p.z, b.z0) || near(p.z, b.z1); };
    const auto has_corner = [&](double x, double z) {
        return std::ranges::any_of(outline,
                                   [&](Point p) { return near(p.x, x) && near(p.z, z); });
    };
    return near(polygon_area(outline), (b.x1 - b.x0) * (b.z1 - b.z0)) &&
           std::ranges::all_of(outline, [&](Point p) { return at_x(p) || at_z(p); }) &&
           has_corner(b.x0, b.z0) && has_corner(b.x1, b.z0) && has_corner(b.x1, b.z1) &&
           has_corner(b.x0, b.z1);
}

void add_base_faces(int last, Layout& layout)
{
    for (int b = 0; b < last; ++b) {
        const Block& block = layout.blocks[b];
        layout.faces.push_back({FaceKind::base_joint,
                                0,
                                kGround,
                                b,
                                {block.x0, 0.0},
                                {block.x1, 0.0},
                                {0.0, 1.0}});
    }
}

} // namespace

Block block_of(std::vector<Point> outline)
{
    const Region e = extent_of(outline);
    Block b;
    b.x0 = e.x0;
    b.x1 = e.x1;
    b.z0 = e.z0;
    b.z1 = e.z1;
    if (!is_rectangle(outline, b)) b.outline = std::move(outline);
    return b;
}

double own_stiffness(const Layout& layout, std::size_t crack)
{
    return layout.crack_stiffness.empty() ? 0.0 : layout.crack_stiffness.at(crack);
}

Elastic between_cracks(const Elastic& unit, double rigidity)
{
    const double stiffer = rigidity / (rigidity - 1.0);
    return {stiffer * unit.young_modulus, stiffer * unit.poisson_ratio, unit.density};
}

double area_of(const Block& b)
{
    if (b.outline.empty()) return (b.x1 - b.x0) * (b.z1 - b.z0);
    return polygon_area(b.outline);
}

Point centre_of(const Block& b)
{
    if (b.outline.empty()) return {0.5 * (b.x0 + b.x1), 0.5 * (b.z0 + b.z1)};
    return polygon_centre(b.outline);
}

const Elastic& stone_of(const Layout& layout, int block, const Elastic& wall,
                        const Elastic& beam)
{
    if (block == layout.beam) return beam;
    const int material = layout.blocks[static_cast<std::size_t>(block)].material;
    return material == 0 ? wall : layout.stones[static_cast<std::size_t>(material - 1)];
}

Layout lay_out(const WallGeometry& wall, double beam_height)
{
    check(wall);
    Layout layout;
    layout.thickness = wall.thickness;
    layout.length = wall.length;
    layout.height = top_of_course(wall, wall.courses);
    layout.courses = wall.courses;
    layout.course_height = wall.course_height;
    layout.half_unit = 0.5 * wall.unit_length;
    if (!wall.openings.empty()) layout.stones = {wall.lintel};
    layout.lintels = 1;
    std::vector<int> first{0}; // first block of each course, and one past the last
    int unit = 0;
    for (int course = 1; course <= wall.courses; ++course) {
        add_course(wall, course, unit, layout);
        first.push_back(static_cast<int>(layout.blocks.size()));
    }
    for (int b = 0; b < first[1]; ++b)
        layout.blocks[b].motion = support_of(wall, layout.blocks[b]);
    const double top = layout.height;
    layout.beam = static_cast<int>(layout.blocks.size());
    if (beam_height > 0.0)
        layout.blocks.push_back(rectangle(0.0, wall.length, top, top + beam_height, 0, 0));

    if (wall.base == Base::joint) add_base_faces(first[1], layout);
    for (int c = 0; c < wall.courses; ++c) {
        add_vertical_faces(first[c], first[c + 1], layout);
        const bool last = c + 1 == wall.courses;
        if (last && beam_height == 0.0) break;
        add_bed_faces(first[c], first[c + 1], first[c + 1],
                      last ? layout.beam + 1 : first[c + 2],
                      last ? FaceKind::beam_joint : FaceKind::bed_joint, layout);
    }
    if (!wall.openings.empty()) check_standing(layout);
    return with_cracks(std::move(layout), wall.cracks, wall.unit_length);
}

} // namespace dem
