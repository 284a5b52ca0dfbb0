#include "dem/scene/layout.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <vector>

namespace {

using dem::Block;
using dem::Face;
using dem::FaceKind;
using dem::FirstCourse;
using dem::Layout;
using dem::WallGeometry;

constexpr double kBeam = 0.1; // height [m]
constexpr double kRounding = 1e-12;

WallGeometry paper() { return {}; }

int count(const Layout& l, FaceKind kind)
{
    return static_cast<int>(std::count_if(l.faces.begin(), l.faces.end(),
                                          [kind](const Face& f) { return f.kind == kind; }));
}

bool is_vertical(const Face& f)
{
    return f.kind == FaceKind::head_joint || f.kind == FaceKind::unit_crack;
}

double length(const Face& f) { return std::hypot(f.to.x - f.from.x, f.to.z - f.from.z); }

/// Blocks of a course, 0: the beam.
std::vector<Block> course_of(const Layout& l, int course)
{
    std::vector<Block> blocks;
    for (const Block& b : l.blocks)
        if (b.course == course) blocks.push_back(b);
    return blocks;
}

/// Any bond, any length, with and without cracks.
WallGeometry some_wall()
{
    WallGeometry w;
    w.length = GENERATE(1.0, 0.77, 1.03, 0.2);
    w.courses = GENERATE(1, 2, 5);
    w.bond_offset = GENERATE(0.0, 0.25, 1.0 / 3, 0.5, 0.8);
    w.first_course = GENERATE(FirstCourse::whole, FirstCourse::shifted);
    w.cracks.pattern.kind =
        GENERATE(dem::CrackPattern::Kind::mid, dem::CrackPattern::Kind::none);
    w.base = GENERATE(dem::Base::fixed, dem::Base::joint);
    return w;
}

struct Counts {
    int blocks, cracks, heads, beds;
};

Counts counts_of(const Layout& l)
{
    return {static_cast<int>(l.blocks.size()) - 1, count(l, FaceKind::unit_crack),
            count(l, FaceKind::head_joint), count(l, FaceKind::bed_joint)};
}

/// Running bond by half a unit, a length of n whole units.
Counts running_bond(int n, int courses, FirstCourse first)
{
    const int shifted = first == FirstCourse::whole ? courses / 2 : courses - courses / 2,
              whole = courses - shifted;
    return {2 * n * courses, whole * n + shifted * (n - 1), whole * (n - 1) + shifted * n,
            (courses - 1) * 2 * n};
}

} // namespace

TEST_CASE("layout: the wall of the paper has 100 blocks, 45 unit cracks and 135 joints",
          "[dem][layout]")
{
    const Layout l = dem::lay_out(paper(), kBeam);
    CHECK(l.blocks.size() == 101);
    CHECK(l.n_cracks == 45);
    CHECK(l.n_joints == 135);
    CHECK(count(l, FaceKind::head_joint) == 45);
    CHECK(count(l, FaceKind::bed_joint) == 90);
    CHECK(count(l, FaceKind::beam_joint) == 10);
    CHECK(count(l, FaceKind::base_joint) == 0); // the first course is clamped
    WallGeometry lifting = paper();
    lifting.base = dem::Base::joint;
    CHECK(count(dem::lay_out(lifting, kBeam), FaceKind::base_joint) == 10);
}

TEST_CASE("layout: counts of a running bond follow from units and courses", "[dem][layout]")
{
    // Lengths as one writes them: 3 x 0.3 is below 0.9, 3 x 0.2 above 0.6.
    const auto [n, unit, length] = GENERATE(table<int, double, double>({{1, 0.2, 0.2},
                                                                        {2, 0.2, 0.4},
                                                                        {3, 0.2, 0.6},
                                                                        {3, 0.3, 0.9},
                                                                        {5, 0.2, 1.0},
                                                                        {7, 0.1, 0.7},
                                                                        {8, 0.3, 2.4}}));
    const int courses = GENERATE(1, 2, 7, 10);
    const FirstCourse first = GENERATE(FirstCourse::whole, FirstCourse::shifted);
    WallGeometry w;
    w.unit_length = unit;
    w.length = length;
    w.courses = courses;
    w.first_course = first;
    const Layout l = dem::lay_out(w, kBeam);
    const Counts c = counts_of(l), expected = running_bond(n, courses, first);
    CHECK(c.blocks == expected.blocks);
    CHECK(c.cracks == expected.cracks);
    CHECK(c.heads == expected.heads);
    CHECK(c.beds == expected.beds);
    CHECK(l.n_cracks == c.cracks);
    CHECK(l.n_joints == c.heads + c.beds);
}

TEST_CASE("layout: a stack bond repeats its course", "[dem][layout]")
{
    const int n = 4, courses = GENERATE(1, 6);
    WallGeometry w;
    w.length = n * w.unit_length;
    w.courses = courses;
    w.bond_offset = 0.0;
    w.first_course = GENERATE(FirstCourse::whole, FirstCourse::shifted);
    const Counts c = counts_of(dem::lay_out(w, kBeam));
    CHECK(c.blocks == 2 * n * courses);
    CHECK(c.cracks == n * courses);
    CHECK(c.heads == (n - 1) * courses);
    CHECK(c.beds == 2 * n * (courses - 1));
}

TEST_CASE("layout: without cracks a unit is one block, and beds are cut where units meet",
          "[dem][layout]")
{
    const int n = 5, courses = 4;
    WallGeometry w;
    w.courses = courses;
    w.cracks.pattern.kind = dem::CrackPattern::Kind::none;
    const Counts c = counts_of(dem::lay_out(w, kBeam));
    CHECK(c.blocks == courses / 2 * (n + n + 1));
    CHECK(c.cracks == 0);
    CHECK(c.heads == courses / 2 * (n - 1 + n));
    CHECK(c.beds == (courses - 1) * 2 * n);
}

TEST_CASE("layout: courses are tiled by their blocks, from end to end", "[dem][layout]")
{
    const WallGeometry w = some_wall();
    const Layout l = dem::lay_out(w, kBeam);
    for (int c = 1; c <= w.courses; ++c) {
        const std::vector<Block> blocks = course_of(l, c);
        CHECK(blocks.front().x0 == 0.0);
        CHECK(blocks.back().x1 == w.length);
        for (std::size_t i = 0; i < blocks.size(); ++i) {
            if (i > 0) CHECK(blocks[i].x0 == blocks[i - 1].x1);
            CHECK(blocks[i].x1 - blocks[i].x0 > 1e-6);
            CHECK(blocks[i].x1 - blocks[i].x0 < w.unit_length + kRounding);
            CHECK(blocks[i].z0 == Approx((c - 1) * w.course_height).margin(kRounding));
            CHECK(blocks[i].z1 == Approx(c * w.course_height));
        }
    }
    const Block& beam = l.blocks[l.beam];
    CHECK(l.beam + 1 == static_cast<int>(l.blocks.size()));
    CHECK(beam.course == 0);
    CHECK(beam.unit == 0);
    CHECK(beam.x0 == 0.0);
    CHECK(beam.x1 == w.length);
    CHECK(beam.z0 == Approx(w.courses * w.course_height));
    CHECK(beam.z1 - beam.z0 == Approx(kBeam));
}

TEST_CASE("layout: units sit where the bond puts them; whole ones are two equal blocks",
          "[dem][layout]")
{
    const WallGeometry w = some_wall();
    const Layout l = dem::lay_out(w, kBeam);
    std::map<int, std::vector<Block>> units;
    for (const Block& b : l.blocks)
        if (b.unit > 0) units[b.unit].push_back(b);
    CHECK(units.rbegin()->first ==
          static_cast<int>(units.size())); // numbered from 1 without gaps
    for (const auto& [number, blocks] : units) {
        const double x0 = blocks.front().x0, x1 = blocks.back().x1;
        const bool whole = x1 - x0 > w.unit_length - 1e-9;
        REQUIRE(blocks.size() ==
                (whole && w.cracks.pattern.kind == dem::CrackPattern::Kind::mid ? 2u : 1u));
        if (blocks.size() == 2) {
            CHECK(blocks[0].course == blocks[1].course);
            CHECK(blocks[0].x1 - blocks[0].x0 == Approx(0.5 * w.unit_length).epsilon(1e-12));
        }
        const bool shifted =
            (blocks.front().course % 2 == 0) == (w.first_course == FirstCourse::whole);
        const double phase =
            (x0 - (shifted ? w.bond_offset * w.unit_length : 0.0)) / w.unit_length;
        CHECK((x0 == 0.0 || std::abs(phase - std::round(phase)) < 1e-9));
    }
}

TEST_CASE("layout: every vertical boundary between blocks is one face, over the whole height",
          "[dem][layout]")
{
    const WallGeometry w = some_wall();
    const Layout l = dem::lay_out(w, kBeam);
    std::size_t boundaries = 0, faces = 0;
    for (int c = 1; c <= w.courses; ++c) boundaries += course_of(l, c).size() - 1;
    for (const Face& f : l.faces) {
        if (!is_vertical(f)) continue;
        ++faces;
        const Block &a = l.blocks[f.a], &b = l.blocks[f.b];
        CHECK(f.b == f.a + 1);
        CHECK(a.course == b.course);
        CHECK((a.x1 == b.x0 && f.from.x == b.x0 && f.to.x == b.x0));
        CHECK((f.from.z == b.z0 && f.to.z == b.z1));
        CHECK((f.kind == FaceKind::unit_crack) == (a.unit == b.unit));
    }
    CHECK(faces == boundaries); // one face each: none is there twice
}

TEST_CASE("layout: bed faces of an interface cover it once, each between the blocks it names",
          "[dem][layout]")
{
    const WallGeometry w = some_wall();
    const Layout l = dem::lay_out(w, kBeam);
    std::map<int, double> covered, reached; // by the course below; the ground: 0
    for (const Face& f : l.faces) {
        if (is_vertical(f)) continue;
        const int below = f.a == dem::kGround ? 0 : l.blocks[f.a].course;
        const Block& b = l.blocks[f.b];
        CHECK(f.from.z == f.to.z);
        CHECK(f.from.z == b.z0);
        CHECK(b.course == (below == w.courses ? 0 : below + 1));
        CHECK((f.from.x >= b.x0 && f.to.x <= b.x1));
        if (f.a != dem::kGround) {
            CHECK((f.from.x >= l.blocks[f.a].x0 && f.to.x <= l.blocks[f.a].x1));
            CHECK(l.blocks[f.a].z1 == Approx(f.from.z));
        }
        CHECK(f.from.x ==
              Approx(reached[below]).margin(kRounding)); // goes on where the last one ended
        CHECK(f.kind == (below == 0           ? FaceKind::base_joint
                         : below == w.courses ? FaceKind::beam_joint
                                              : FaceKind::bed_joint));
        reached[below] = f.to.x;
        covered[below] += length(f);
    }
    CHECK(covered.size() ==
          static_cast<std::size_t>(w.courses) + (w.base == dem::Base::joint ? 1 : 0));
    for (const auto& [course, sum] : covered) CHECK(sum == Approx(w.length).epsilon(1e-12));
}

TEST_CASE(
    "layout: IDs run from 1 without gaps, course by course, head joints before the beds above",
    "[dem][layout]")
{
    const WallGeometry w = some_wall();
    const Layout l = dem::lay_out(w, kBeam);
    std::vector<std::tuple<int, int, double>> joints, cracks; // course, head or bed, x
    for (const Face& f : l.faces) {
        if (f.kind == FaceKind::base_joint || f.kind == FaceKind::beam_joint) {
            CHECK(f.id == 0);
            continue;
        }
        auto& list = f.kind == FaceKind::unit_crack ? cracks : joints;
        list.emplace_back(l.blocks[f.a].course, f.kind == FaceKind::bed_joint, f.from.x);
        CHECK(f.id == static_cast<int>(list.size())); // in the order of the faces
    }
    CHECK(l.n_joints == static_cast<int>(joints.size()));
    CHECK(l.n_cracks == static_cast<int>(cracks.size()));
    CHECK(std::is_sorted(joints.begin(), joints.end()));
    CHECK(std::is_sorted(cracks.begin(), cracks.end()));
}

TEST_CASE("layout: IDs of the paper's wall", "[dem][layout]")
{
    const Layout l = dem::lay_out(paper(), kBeam);
    const auto joint = [&l](int id) {
        return *std::find_if(l.faces.begin(), l.faces.end(), [id](const Face& f) {
            return f.id == id &&
                   (f.kind == FaceKind::head_joint || f.kind == FaceKind::bed_joint);
        });
    };
    CHECK(joint(1).kind == FaceKind::head_joint); // 4 in the first course
    CHECK(joint(1).from.x == Approx(0.2));
    CHECK(joint(4).from.x == Approx(0.8));
    CHECK(joint(5).kind == FaceKind::bed_joint); // 10 above it
    CHECK(joint(5).from.x == 0.0);
    CHECK(joint(14).to.x == 1.0);
    CHECK(joint(15).kind == FaceKind::head_joint); // 5 in the second
    CHECK(joint(15).from.x == Approx(0.1));
    CHECK(joint(15).from.z == Approx(0.1));
    CHECK(joint(135).kind ==
          FaceKind::head_joint); // the last of the top course: the beam's faces have no ID
    CHECK(joint(135).to.z == Approx(1.0));
}

TEST_CASE("layout: a wall shorter than its shifted piece has that piece alone, cut to length",
          "[dem][layout]")
{
    WallGeometry w;
    w.bond_offset = 0.8; // a piece of 0.16 m
    w.length = GENERATE(0.16, 0.15, 0.05);
    w.courses = 2;
    const Layout l = dem::lay_out(w, kBeam);
    for (int c = 1; c <= 2; ++c) {
        REQUIRE(course_of(l, c).size() == 1);
        CHECK(course_of(l, c).front().x1 == w.length);
    }
}
