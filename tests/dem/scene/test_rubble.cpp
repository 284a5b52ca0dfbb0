#include "dem/scene/rubble.hpp"

#include "dem/scene/drawn_layout.hpp"
#include "dem/scene/geometry/polygon.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>
#include <vector>

namespace {

double length(dem::Point p, dem::Point q) { return std::hypot(q.x - p.x, q.z - p.z); }

double perimeter(const dem::Outline& o)
{
    double sum = 0.0;
    for (std::size_t i = 0; i < o.size(); ++i) sum += length(o[i], o[(i + 1) % o.size()]);
    return sum;
}

dem::DrawnWall drawn(const std::vector<dem::Outline>& stones)
{
    dem::DrawnWall wall;
    for (const dem::Outline& o : stones) wall.units.push_back({o, 0});
    return wall;
}

} // namespace

TEST_CASE("rubble: stones fill the wall and touch along whole sides, whatever the seed",
          "[dem][rubble]")
{
    dem::Rubble wall{.length = 1.2, .height = 1.0};
    for (wall.seed = 1; wall.seed <= 30; ++wall.seed) {
        INFO(wall.seed);
        const std::vector<dem::Outline> stones = dem::rubble(wall);
        CHECK(stones.size() > 55); // of 60, the least of which may be closed to points
        double area = 0.0, sides = 0.0;
        for (const dem::Outline& o : stones) {
            const double own = dem::polygon_area(o);
            CHECK(own > 0.05 * 0.02);
            area += own;
            sides += perimeter(o);
            std::set<std::pair<double, double>> corners;
            for (const dem::Point p : o) corners.emplace(p.x, p.z);
            CHECK(corners.size() == o.size());
        }
        CHECK(area == Approx(1.2).epsilon(1e-12));
        double joints = 0.0;
        for (const dem::Face& f : dem::drawn_layout(drawn(stones), 0.0).faces)
            joints += length(f.from, f.to);
        CHECK(2.0 * joints + 2.0 * (1.2 + 1.0) == Approx(sides).epsilon(1e-9));
    }
}

TEST_CASE("rubble: stones are as long and as high as asked for, and no side is a sliver",
          "[dem][rubble]")
{
    const double high = GENERATE(0.05, 0.1, 0.2);
    const std::vector<dem::Outline> stones =
        dem::rubble({.length = 3.0, .height = 15.0 * high, .stone_height = high});
    double wide = 0.0, tall = 0.0;
    for (const dem::Outline& o : stones) {
        const auto [left, right] = std::ranges::minmax(o, {}, &dem::Point::x);
        const auto [low, top] = std::ranges::minmax(o, {}, &dem::Point::z);
        wide += right.x - left.x;
        tall += top.z - low.z;
        for (std::size_t i = 0; i < o.size(); ++i)
            CHECK(length(o[i], o[(i + 1) % o.size()]) > 0.05 * high);
    }
    CHECK(stones.size() == Approx(225).epsilon(0.02));
    CHECK(wide / tall == Approx(0.2 / high).epsilon(0.06));
}

TEST_CASE("rubble: one seed, one wall", "[dem][rubble]")
{
    const auto corner = [](unsigned seed) { return dem::rubble({.seed = seed}).at(7).at(0).x; };
    CHECK(corner(3) == corner(3));
    CHECK(corner(3) != corner(4));
    CHECK_THROWS(dem::rubble({.stone_height = 0.0}));
}
