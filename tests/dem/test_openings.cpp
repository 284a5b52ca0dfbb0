/// Doors and windows in walls in courses.

#include "dem/scene/layout.hpp"

#include <catch2/catch.hpp>

#include <algorithm>

namespace {

/// 3 m x 3 m with a door of 0.75 m x 2 m and a window of 0.5 m x 1 m beside it.
dem::WallGeometry facade()
{
    dem::WallGeometry w;
    w.length = 3.0;
    w.courses = 12;
    w.course_height = 0.25;
    w.unit_length = 0.5;
    w.openings = {{0.5, 0.0, 0.75, 2.0}, {2.0, 1.0, 0.5, 1.0}};
    w.lintel_bearing = 0.25;
    w.lintel = {30e9, 0.2, 2500.0};
    return w;
}

double area(const dem::Layout& l)
{
    double sum = 0.0;
    for (const dem::Block& b : l.blocks) sum += dem::area_of(b);
    return sum;
}

bool free_of(const dem::Block& b, const dem::Opening& o)
{
    return b.x1 < o.x + 1e-9 || b.x0 > o.x + o.width - 1e-9 || b.z1 < o.z + 1e-9 ||
           b.z0 > o.z + o.height - 1e-9;
}

} // namespace

TEST_CASE("openings: no block stands in them, and nothing else of the wall is missing",
          "[dem][openings]")
{
    const dem::WallGeometry w = facade();
    const dem::Layout l = dem::lay_out(w, 0.0);
    for (const dem::Block& b : l.blocks)
        for (const dem::Opening& o : w.openings) CHECK(free_of(b, o));
    CHECK(area(l) == Approx(9.0 - 1.5 - 0.5));
    for (const dem::Face& f : l.faces) {
        const dem::Block &a = l.blocks[f.a], &b = l.blocks[f.b];
        const bool head = f.normal.x == 1.0;
        CHECK((head ? a.x1 == Approx(b.x0) : a.z1 == Approx(b.z0)));
    }
}

TEST_CASE(
    "openings: a lintel reaches over both sides of each, of its own stone, without a crack",
    "[dem][openings]")
{
    dem::WallGeometry w = facade();
    const dem::Layout l = dem::lay_out(w, 0.0);
    REQUIRE(l.stones.size() == 1);
    CHECK(l.stones.front() == w.lintel);
    std::vector<dem::Block> lintels;
    std::ranges::copy_if(l.blocks, std::back_inserter(lintels),
                         [](const dem::Block& b) { return b.material == 1; });
    REQUIRE(lintels.size() == 2);
    CHECK(lintels[0].x0 == Approx(0.25));
    CHECK(lintels[0].x1 == Approx(1.5));
    CHECK(lintels[0].z0 == Approx(2.0));
    CHECK(lintels[1].x0 == Approx(1.75));
    CHECK(lintels[1].x1 == Approx(2.75));
    w.lintel_bearing = 0.0;
    const dem::Layout none = dem::lay_out(w, 0.0);
    CHECK(
        std::ranges::none_of(none.blocks, [](const dem::Block& b) { return b.material != 0; }));
}

TEST_CASE("openings: those that fit no course, leave the wall or overlap are refused",
          "[dem][openings]")
{
    dem::WallGeometry w = facade();
    w.openings = {{0.5, 0.1, 0.5, 0.5}};
    CHECK_THROWS_WITH(dem::lay_out(w, 0.0), Catch::Contains("between two courses"));
    w.openings = {{2.8, 0.0, 0.5, 0.5}};
    CHECK_THROWS_WITH(dem::lay_out(w, 0.0), Catch::Contains("within the wall"));
    w.openings = {{1.0, 2.0, 0.5, 1.0}};
    CHECK_THROWS_WITH(dem::lay_out(w, 0.0), Catch::Contains("below its top course"));
    w.openings = {{1.0, 0.5, 0.5, 1.0}, {1.4, 1.0, 0.5, 1.0}};
    CHECK_THROWS_WITH(dem::lay_out(w, 0.0), Catch::Contains("overlap"));
}
