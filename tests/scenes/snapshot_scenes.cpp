#include "tests/scenes/snapshot_scenes.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

namespace scenes {

namespace {

using dem::BlockState;
using dem::ContactState;
using dem::FaceKind;
using dem::FaceState;
using dem::Point;
using dem::Snapshot;

/// Points from a to b, both included, without the last: sides chain into an outline.
void add_side(std::vector<Point>& outline, Point a, Point b, int intervals)
{
    for (int i = 0; i < intervals; ++i) {
        const double s = static_cast<double>(i) / intervals;
        outline.push_back({a.x + s * (b.x - a.x), a.z + s * (b.z - a.z)});
    }
}

BlockState rectangle(Point low, Point high, int along, int up)
{
    BlockState block;
    add_side(block.outline, low, {high.x, low.z}, along);
    add_side(block.outline, {high.x, low.z}, high, up);
    add_side(block.outline, high, {low.x, high.z}, along);
    add_side(block.outline, {low.x, high.z}, low, up);
    block.displacement.resize(block.outline.size());
    return block;
}

FaceState face(FaceKind kind, int id, int a, int b, Point from, Point to, Point normal,
               const SnapshotWall& wall)
{
    FaceState f{.kind = kind,
                .id = id,
                .block_a = a,
                .block_b = b,
                .normal = normal,
                .acting = normal,
                .contacts = {}};
    const int intervals = wall.points - 1;
    const double area = std::hypot(to.x - from.x, to.z - from.z) * wall.thickness / intervals;
    for (int i = 0; i <= intervals; ++i) {
        const double s = static_cast<double>(i) / intervals;
        ContactState c;
        c.at = {from.x + s * (to.x - from.x), from.z + s * (to.z - from.z)};
        c.area = i == 0 || i == intervals ? area / 2 : area;
        f.contacts.push_back(c);
    }
    return f;
}

int block_index(const SnapshotWall& wall, int row, int column)
{
    return row * wall.half_units + column;
}

/// Odd courses: units of columns 01 23 45 ...; even courses: 0 12 34 ... and a half unit at the
/// end.
bool same_unit(int row, int left_column) { return (left_column % 2 == 0) == (row % 2 == 0); }

void add_blocks(Snapshot& s, const SnapshotWall& wall)
{
    const double l = wall.half_length, h = wall.course_height;
    int unit = 0;
    for (int row = 0; row < wall.courses; ++row) {
        for (int column = 0; column < wall.half_units; ++column) {
            if (column == 0 || !same_unit(row, column - 1)) ++unit;
            BlockState b = rectangle({column * l, row * h}, {(column + 1) * l, (row + 1) * h},
                                     wall.points - 1, wall.points - 1);
            b.course = row + 1;
            b.unit = unit;
            s.blocks.push_back(b);
        }
    }
    const double top = wall.courses * h;
    s.blocks.push_back(rectangle({0.0, top}, {wall.half_units * l, top + h},
                                 wall.half_units * (wall.points - 1), 1));
}

void add_faces(Snapshot& s, const SnapshotWall& wall)
{
    const double l = wall.half_length, h = wall.course_height;
    int joint = 0, crack = 0;
    for (int row = 0; row < wall.courses; ++row)
        for (int column = 0; column + 1 < wall.half_units; ++column) {
            const bool in_unit = same_unit(row, column);
            const Point low{(column + 1) * l, row * h}, high{(column + 1) * l, (row + 1) * h};
            s.faces.push_back(face(in_unit ? FaceKind::unit_crack : FaceKind::head_joint,
                                   in_unit ? ++crack : ++joint, block_index(wall, row, column),
                                   block_index(wall, row, column + 1), low, high, {1, 0},
                                   wall));
        }
    for (int row = 0; row <= wall.courses; ++row)
        for (int column = 0; column < wall.half_units; ++column) {
            const bool base = row == 0, beam = row == wall.courses;
            const FaceKind kind = base   ? FaceKind::base_joint
                                  : beam ? FaceKind::beam_joint
                                         : FaceKind::bed_joint;
            const int below = base ? -1 : block_index(wall, row - 1, column);
            const int above = block_index(wall, row, beam ? 0 : column); // the beam comes last
            s.faces.push_back(face(kind, base || beam ? 0 : ++joint, below, above,
                                   {column * l, row * h}, {(column + 1) * l, row * h}, {0, 1},
                                   wall));
        }
}

Point displacement_of(const Snapshot& s, int block, Point at)
{
    if (block < 0) return {};
    const BlockState& b = s.blocks[static_cast<std::size_t>(block)];
    for (std::size_t i = 0; i < b.outline.size(); ++i)
        if (std::hypot(b.outline[i].x - at.x, b.outline[i].z - at.z) < 1e-9)
            return b.displacement[i];
    return {};
}

/// Openings and slips from the displacements; compression along a strut from the top middle to
/// the toe.
void fill_contacts(Snapshot& s, const SnapshotWall& wall, double strut_share)
{
    const double length = wall.half_units * wall.half_length;
    const double height = wall.courses * wall.course_height;
    const double mean = wall.vertical_load / (length * wall.thickness);
    for (FaceState& f : s.faces)
        for (ContactState& c : f.contacts) {
            const Point a = displacement_of(s, f.block_a, c.at),
                        b = displacement_of(s, f.block_b, c.at);
            const Point d{b.x - a.x, b.z - a.z}, t{f.normal.z, -f.normal.x};
            c.opening = d.x * f.normal.x + d.z * f.normal.z;
            c.slip = d.x * t.x + d.z * t.z;
            c.sigma = c.tau = 0.0;
            if (c.opening > 1e-7) continue; // no stress across a gap
            const double centre = length * (0.9 - 0.45 * c.at.z / height);
            const double width = 0.14 * length;
            const double bump = std::exp(-std::pow((c.at.x - centre) / width, 2)) / 0.25;
            const double level = (1.0 - strut_share) + strut_share * bump;
            c.sigma = -mean * level * (f.normal.z > 0.5 ? 1.0 : 0.3);
            c.opening = c.sigma / 8e9;
            c.tau = std::abs(c.slip) > 1e-7 ? std::copysign(0.6 * c.sigma, c.slip) : 0.0;
        }
}

/// Moves each block by motion(block centre, unit centre, point).
void move(Snapshot& s, const std::function<Point(Point, Point, Point)>& motion)
{
    const auto centre = [](const BlockState& b) {
        const auto [l, r] = std::minmax_element(b.outline.begin(), b.outline.end(),
                                                [](Point p, Point q) { return p.x < q.x; });
        const auto [d, u] = std::minmax_element(b.outline.begin(), b.outline.end(),
                                                [](Point p, Point q) { return p.z < q.z; });
        return Point{(l->x + r->x) / 2, (d->z + u->z) / 2};
    };
    for (BlockState& b : s.blocks) {
        Point unit_centre{};
        int halves = 0;
        for (const BlockState& other : s.blocks)
            if (other.unit == b.unit) {
                const Point c = centre(other);
                unit_centre = {unit_centre.x + c.x, unit_centre.z + c.z};
                ++halves;
            }
        unit_centre = {unit_centre.x / halves, unit_centre.z / halves};
        for (std::size_t i = 0; i < b.outline.size(); ++i)
            b.displacement[i] = motion(centre(b), unit_centre, b.outline[i]);
    }
}

} // namespace

Snapshot wall_at_rest(const SnapshotWall& wall)
{
    Snapshot s;
    add_blocks(s, wall);
    add_faces(s, wall);
    const int beam = wall.courses * wall.half_units;
    for (FaceState& f : s.faces)
        if (f.kind == FaceKind::beam_joint) f.block_b = beam;
    fill_contacts(s, wall, 0.0);
    return s;
}

Snapshot stair_step_rocking(double displacement, const SnapshotWall& wall)
{
    Snapshot s = wall_at_rest(wall);
    const double length = wall.half_units * wall.half_length;
    const double load_height = (wall.courses + 1) * wall.course_height;
    const double slope = wall.course_height / wall.half_length;
    const double theta = displacement / load_height;
    move(s, [&](Point, Point unit, Point p) -> Point {
        // a unit turns with the upper part if its centre lies above the staircase
        const bool turns = unit.z > slope * (length - unit.x) + 0.1 * wall.course_height;
        return turns ? Point{theta * p.z, theta * (length - p.x)} : Point{};
    });
    fill_contacts(s, wall, 0.95);
    s.displacement = displacement;
    s.force = wall.vertical_load * 0.85 * length / 2 / load_height;
    return s;
}

Snapshot diagonal_crack(double displacement, double share, const SnapshotWall& wall)
{
    Snapshot s = wall_at_rest(wall);
    const double length = wall.half_units * wall.half_length;
    const double height = wall.courses * wall.course_height;
    const double slide = 0.8 * displacement;
    const double theta = (displacement - slide) / (height + wall.course_height);
    // > 0 above the diagonal from the top middle to the toe: one column in two courses, so that
    // it meets cracks and head joints in turn
    const auto above = [&](Point p) { return p.x - length * (1.0 - 0.5 * p.z / height); };
    move(s, [&](Point block, Point, Point p) -> Point {
        // blocks, not units: the diagonal cuts through units; the first course stays
        const bool slides =
            block.z > wall.course_height && (block.z > share * height || above(block) > 0.0);
        return slides ? Point{slide + theta * p.z, theta * (length - p.x)} : Point{};
    });
    fill_contacts(s, wall, 0.9);
    for (FaceState& f : s.faces) {
        if (f.kind != FaceKind::unit_crack) continue;
        const std::size_t n = f.contacts.size();
        const Point middle{f.contacts.front().at.x,
                           (f.contacts.front().at.z + f.contacts.back().at.z) / 2};
        const bool torn = f.contacts.front().opening > 1e-6;
        const bool next = !torn && std::abs(above(middle)) < 0.5 * wall.half_length &&
                          middle.z > share * height;
        for (std::size_t i = 0; i < n; ++i)
            f.contacts[i].damage = torn ? 1.0 : next && i < n / 2 ? 0.5 : 0.0;
    }
    s.displacement = displacement;
    s.force = 0.5 * wall.vertical_load;
    return s;
}

} // namespace scenes
