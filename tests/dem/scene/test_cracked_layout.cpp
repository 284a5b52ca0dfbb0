/// Units divided into pieces: their areas and cracks, the joints' IDs, the stiffness that they
/// share.

#include "dem/scene/crack_pattern.hpp"
#include "dem/scene/drawn_layout.hpp"
#include "dem/scene/geometry/clip.hpp"
#include "dem/scene/geometry/polygon.hpp"
#include "dem/scene/layout.hpp"
#include "dem/scene/piece_count.hpp"
#include "dem/scene/touching.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <vector>

namespace {

using dem::CrackPattern;
using dem::FaceKind;
using dem::Layout;
using dem::Outline;
using dem::Point;
using Kind = CrackPattern::Kind;

const Outline kUnit{{0.0, 0.0}, {0.2, 0.0}, {0.2, 0.1}, {0.0, 0.1}};
/// A U, 3 x 2 with a notch 1 x 1 in the middle of its top.
const Outline kNotched{{0, 0}, {3, 0}, {3, 2}, {2, 2}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};

double area(const std::vector<Outline>& pieces)
{
    return std::accumulate(pieces.begin(), pieces.end(), 0.0, [](double sum, const Outline& o) {
        return sum + dem::polygon_area(o);
    });
}

Layout wall_with(const CrackPattern& pattern, dem::Base base = dem::Base::fixed)
{
    dem::WallGeometry wall;
    wall.base = base;
    wall.cracks.pattern = pattern;
    return dem::lay_out(wall, 0.1);
}

double length(const dem::Face& f) { return std::hypot(f.to.x - f.from.x, f.to.z - f.from.z); }

bool equal(const std::vector<Outline>& a, const std::vector<Outline>& b)
{
    return std::ranges::equal(a, b, [](const Outline& p, const Outline& q) {
        return std::ranges::equal(p, q,
                                  [](Point u, Point v) { return u.x == v.x && u.z == v.z; });
    });
}

/// By kind and ID.
std::map<std::pair<FaceKind, int>, double> lengths(const Layout& l)
{
    std::map<std::pair<FaceKind, int>, double> sum;
    for (const dem::Face& f : l.faces)
        if (f.kind != FaceKind::unit_crack) sum[{f.kind, f.id}] += length(f);
    return sum;
}

} // namespace

TEST_CASE("clip: a line through a notch leaves each part as an outline of its own",
          "[dem][cracks]")
{
    const std::vector<Outline> above = dem::clip(kNotched, {{0, 1.5}, {0, -1}});
    REQUIRE(above.size() == 2);
    CHECK(dem::polygon_area(above[0]) == Approx(0.5));
    CHECK(dem::polygon_area(above[1]) == Approx(0.5));
    const std::vector<Outline> below = dem::clip(kNotched, {{0, 1.5}, {0, 1}});
    REQUIRE(below.size() == 1);
    CHECK(dem::polygon_area(below[0]) == Approx(4.0));
    // Along the floor of the notch.
    CHECK(area(dem::clip(kNotched, {{0, 1}, {0, -1}})) == Approx(2.0));
    CHECK(area(dem::clip(kNotched, {{0, 1}, {0, 1}})) == Approx(3.0));
    // Along a side of the notch: the side is no spike of the part on its right.
    const std::vector<Outline> right = dem::clip(kNotched, {{1, 0}, {-1, 0}});
    REQUIRE(right.size() == 1);
    CHECK(right[0].size() == 6);
    CHECK(dem::polygon_area(right[0]) == Approx(3.0));
    CHECK(area(dem::clip(kNotched, {{1, 0}, {1, 0}})) == Approx(2.0));
    CHECK(equal(dem::clip(kNotched, {{0, 5}, {0, 1}}), {kNotched}));
    CHECK(dem::clip(kNotched, {{0, -5}, {0, 1}}).empty());
}

TEST_CASE("crack pattern: pieces fill their unit", "[dem][cracks]")
{
    struct Case {
        CrackPattern pattern;
        std::size_t pieces;
    };
    const Case c = GENERATE(Case{{Kind::none}, 1}, Case{{Kind::mid}, 2},
                            Case{{Kind::grid, 3, 1}, 3}, Case{{Kind::grid, 4, 4}, 16},
                            Case{{Kind::diagonals}, 4}, Case{{Kind::voronoi, 1, 1, 0.04}, 13});
    const std::vector<Outline> pieces = dem::pieces_of(kUnit, c.pattern, 0.2, 7);
    CHECK(pieces.size() == c.pieces);
    CHECK(dem::piece_count(kUnit, c.pattern, 0.2) == static_cast<double>(c.pieces));
    CHECK(area(pieces) == Approx(0.02).epsilon(1e-9));
    for (const Outline& p : pieces) CHECK(dem::polygon_area(p) > 0.0);
    // Half a unit has pieces of the same width, and none at mid-length.
    const Outline half{{0, 0}, {0.1, 0}, {0.1, 0.1}, {0, 0.1}};
    if (c.pattern.kind == Kind::mid) CHECK(dem::pieces_of(half, c.pattern, 0.2, 7).size() == 1);
    if (c.pieces == 16) CHECK(dem::pieces_of(half, c.pattern, 0.2, 7).size() == 8);
    CrackPattern coarse = c.pattern;
    coarse.size *= 10.0;
    CHECK(area(dem::pieces_of(kNotched, coarse, 3.0, 7)) == Approx(5.0).epsilon(1e-9));
}

TEST_CASE("crack pattern: voronoi cells follow their seed", "[dem][cracks]")
{
    const CrackPattern cells{Kind::voronoi, 1, 1, 0.03};
    const std::vector<Outline> one = dem::pieces_of(kUnit, cells, 0.2, 1);
    CHECK(equal(one, dem::pieces_of(kUnit, cells, 0.2, 1)));
    CHECK_FALSE(equal(one, dem::pieces_of(kUnit, cells, 0.2, 2)));
}

TEST_CASE("cracked layout: joints keep their IDs, lengths and directions", "[dem][cracks]")
{
    const CrackPattern pattern =
        GENERATE(CrackPattern{Kind::grid, 3, 1}, CrackPattern{Kind::grid, 4, 4},
                 CrackPattern{Kind::diagonals}, CrackPattern{Kind::voronoi, 1, 1, 0.05});
    const dem::Base base = GENERATE(dem::Base::fixed, dem::Base::joint);
    const Layout whole = wall_with({Kind::none}, base), l = wall_with(pattern, base);
    CHECK(l.n_joints == whole.n_joints);
    const auto want = lengths(whole), got = lengths(l);
    REQUIRE(got.size() == want.size());
    for (const auto& [id, sum] : want)
        CHECK(std::abs(got.at(id) - sum) < 2 * dem::kShortestFace);
    double sum = 0.0;
    for (int b = 0; b < l.beam; ++b) sum += dem::area_of(l.blocks[b]);
    CHECK(sum == Approx(1.0).epsilon(1e-9));
    for (const dem::Face& f : l.faces) {
        if (f.kind == FaceKind::bed_joint) CHECK(f.normal.z == 1.0);
        if (f.kind == FaceKind::head_joint) CHECK(f.normal.x == 1.0);
        if (f.kind == FaceKind::unit_crack) CHECK(l.blocks[f.a].unit == l.blocks[f.b].unit);
    }
}

TEST_CASE("cracked layout: supports stay where they were", "[dem][cracks]")
{
    const Layout l = wall_with({Kind::grid, 4, 4});
    for (int b = 0; b < l.beam; ++b) {
        const dem::Block& block = l.blocks[b];
        const bool floor = block.z0 == 0.0, right = std::abs(block.x1 - 1.0) < 1e-9;
        if (floor && right)
            CHECK(block.motion == dem::Motion::clamped_bottom_held_right);
        else if (floor)
            CHECK(block.motion == dem::Motion::clamped_bottom);
        else if (right && block.course == 1)
            CHECK(block.motion == dem::Motion::held_right_corner);
        else
            CHECK(block.motion == dem::Motion::free);
    }
}

TEST_CASE("cracked layout: a region has its own pattern, the rest another", "[dem][cracks]")
{
    dem::WallGeometry wall;
    wall.cracks.pattern = {Kind::grid, 2, 2};
    wall.cracks.where = {dem::Region{0.5, 0.0, 1.0, 0.4}};
    const Layout l = dem::lay_out(wall, 0.1);
    std::map<int, int> pieces;
    std::map<int, Point> middle;
    for (int b = 0; b < l.beam; ++b) {
        ++pieces[l.blocks[b].unit];
        middle[l.blocks[b].unit] = dem::centre_of(l.blocks[b]);
    }
    const Layout plain = dem::lay_out(dem::WallGeometry{}, 0.1);
    // 2 whole units and the middle one's right half in odd courses; 2 and a half unit in even
    // ones.
    CHECK(l.n_joints == plain.n_joints);
    int fours = 0;
    for (const auto& [unit, n] : pieces) {
        CHECK((n == 1 || n == 2 || n == 4));
        fours += n == 4;
        if (n == 4) CHECK(middle[unit].z < 0.4);
    }
    CHECK(fours == 8);
    // Cracks at mid-length are the paper's, the others share the stiffness of their unit.
    int own = 0;
    for (const double k : l.crack_stiffness) own += k > 0.0;
    CHECK(own == 8 * 4 + 2);
    CHECK(own < l.n_cracks);
}

TEST_CASE("cracked layout: lintels stay whole", "[dem][cracks]")
{
    dem::WallGeometry wall;
    wall.cracks.pattern = {Kind::grid, 2, 2};
    wall.openings = {{0.4, 0.2, 0.2, 0.2}};
    wall.lintel_bearing = 0.1;
    wall.lintel = {30e9, 0.2, 2500.0};
    const Layout l = dem::lay_out(wall, 0.1);
    CHECK(std::ranges::count_if(l.blocks,
                                [](const dem::Block& b) { return b.material == 1; }) == 1);
}
