#include "dem/scene/bond.hpp"
#include "dem/scene/layout.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace {

using dem::Bond;
using dem::WallGeometry;

WallGeometry wall_of(Bond bond, double length)
{
    WallGeometry w;
    w.bond = bond;
    w.length = length;
    return w;
}

/// x of the head joints of a course.
std::vector<double> heads(const WallGeometry& w, int course)
{
    std::vector<double> x;
    for (const dem::CoursePiece& p : dem::bonded_course(w, course))
        if (p.x0 > 0.0) x.push_back(p.x0);
    return x;
}

void check_heads(const WallGeometry& w, int course, const std::vector<double>& expected)
{
    const std::vector<double> x = heads(w, course);
    REQUIRE(x.size() == expected.size());
    for (std::size_t i = 0; i < x.size(); ++i) CHECK(x[i] == Approx(expected[i]));
}

/// Least distance of a head joint from those of the next course.
double least_overlap(const WallGeometry& w)
{
    double least = INFINITY;
    for (int course = 1; course < w.courses; ++course)
        for (const double x : heads(w, course))
            for (const double y : heads(w, course + 1))
                least = std::min(least, std::abs(x - y));
    return least;
}

} // namespace

TEST_CASE("bond: English, courses of headers begin and end with a header and a closer",
          "[dem][bond]")
{
    const WallGeometry w = wall_of(Bond::english, 1.0);
    check_heads(w, 1, {0.2, 0.4, 0.6, 0.8});
    check_heads(w, 2, {0.1, 0.15, 0.25, 0.35, 0.45, 0.55, 0.65, 0.75, 0.85, 0.9});
    CHECK(least_overlap(w) == Approx(0.05)); // half a header
    WallGeometry other = w;
    other.first_course = dem::FirstCourse::shifted;
    CHECK(heads(other, 1) == heads(w, 2));
}

TEST_CASE("bond: Flemish, headers lie above and below the middles of whole units",
          "[dem][bond]")
{
    const WallGeometry w = wall_of(Bond::flemish, 1.1);
    check_heads(w, 1, {0.2, 0.3, 0.5, 0.6, 0.8, 0.9});
    check_heads(w, 2, {0.1, 0.15, 0.35, 0.45, 0.65, 0.75, 0.95, 1.0});
    CHECK(least_overlap(w) == Approx(0.05));
    for (const auto& [of, in] : {std::pair{1, 2}, std::pair{2, 1}})
        for (const dem::CoursePiece& whole : dem::bonded_course(w, of)) {
            if (!whole.whole) continue;
            const auto beside = dem::bonded_course(w, in);
            const bool above = std::ranges::any_of(beside, [&](const dem::CoursePiece& p) {
                return p.x1 - p.x0 == Approx(0.1) && p.x0 + p.x1 == Approx(whole.x0 + whole.x1);
            });
            const bool at_end = whole.x0 == 0.0 || whole.x1 == w.length; // closers move there
            CHECK((above || at_end));
        }
}

TEST_CASE("bond: headers alone are shifted by half of one, and none of them is whole",
          "[dem][bond]")
{
    const WallGeometry w = wall_of(Bond::header, 0.4);
    check_heads(w, 1, {0.1, 0.2, 0.3});
    check_heads(w, 2, {0.05, 0.15, 0.25, 0.35});
    CHECK(dem::lay_out(w, 0.1).n_cracks == 0);
    CHECK(dem::lay_out(wall_of(Bond::english, 0.4), 0.1).n_cracks == 10); // two in five courses
}

TEST_CASE("bond: courses of heights of their own", "[dem][bond]")
{
    WallGeometry w;
    w.course_heights = {0.15, 0.05, 0.10};
    CHECK_THROWS(dem::lay_out(w, 0.1)); // ten courses
    w.courses = 3;
    const dem::Layout l = dem::lay_out(w, 0.1);
    CHECK(l.height == Approx(0.3));
    for (const dem::Block& b : l.blocks) {
        const std::vector<double> top = {0.4, 0.15, 0.2, 0.3};
        CHECK(b.z1 == Approx(top.at(static_cast<std::size_t>(b.course))));
    }
    w.openings = {{0.2, 0.15, 0.4, 0.05}};
    CHECK_NOTHROW(dem::lay_out(w, 0.1));
    w.openings = {{0.2, 0.1, 0.4, 0.1}};
    CHECK_THROWS_WITH(dem::lay_out(w, 0.1), Catch::Contains("between two courses"));
}

TEST_CASE("bond: lengths at random have the variation asked for, and keep the bond",
          "[dem][bond]")
{
    WallGeometry w;
    w.length = 400.0;
    w.courses = 2;
    w.length_cov = 0.15;
    const std::vector<double> x = heads(w, 1);
    double sum = 0.0, squares = 0.0;
    for (std::size_t i = 0; i + 1 < x.size(); ++i) {
        const double l = (x[i + 1] - x[i]) / w.unit_length;
        sum += l;
        squares += l * l;
    }
    const auto n = static_cast<double>(x.size() - 1);
    CHECK(sum / n == Approx(1.0).epsilon(1e-3));
    CHECK(std::sqrt(squares / n - std::pow(sum / n, 2)) == Approx(0.15).epsilon(0.05));
    CHECK(least_overlap(w) > 0.0);
    CHECK(std::ranges::is_sorted(x));
    w.length_cov = dem::most_length_cov(w);
    CHECK(least_overlap(w) > 1e-3);
    w.length_cov *= 1.001;
    CHECK_THROWS_WITH(dem::lay_out(w, 0.0), Catch::Contains("keep their bond"));
}

TEST_CASE("bond: a random course is the same in a longer wall, and another by another seed",
          "[dem][bond]")
{
    WallGeometry w;
    w.length_cov = 0.1;
    WallGeometry longer = w, other = w;
    longer.length = 2.0;
    longer.courses = 12;
    other.seed = 2;
    for (const int course : {1, 2, 10}) {
        const std::vector<double> x = heads(w, course), y = heads(longer, course);
        CHECK(std::equal(x.begin(), x.end(), y.begin()));
        CHECK(heads(other, course) != x);
    }
    CHECK(heads(w, 1) != heads(w, 3));
    CHECK(dem::lay_out(w, 0.1).n_cracks == 45); // short whole units crack too
    // overlaps of half a unit, of which two moves leave 1 mm
    CHECK(dem::most_length_cov(w) == Approx(0.0495 / (std::sqrt(1.5) * 0.2)));
    WallGeometry stack = w;
    stack.bond_offset = 0.0;
    CHECK(dem::most_length_cov(stack) == 0.0);
}

TEST_CASE("bond: the blocks of every bond fill the wall", "[dem][bond]")
{
    WallGeometry w =
        wall_of(GENERATE(Bond::shifted, Bond::english, Bond::flemish, Bond::header),
                GENERATE(1.0, 1.03, 0.3, 0.2));
    w.first_course = GENERATE(dem::FirstCourse::whole, dem::FirstCourse::shifted);
    double area = 0.0;
    for (const dem::Block& b : dem::lay_out(w, 0.0).blocks) {
        CHECK(b.x1 > b.x0);
        area += dem::area_of(b);
    }
    CHECK(area == Approx(w.length));
}
