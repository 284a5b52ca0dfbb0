#include "app/output/picture/wall_svg.hpp"

#include "app/output/picture/wall_body.hpp"
#include "app/output/picture/wall_legend.hpp"
#include "app/output/picture/wall_marks.hpp"
#include "app/text/number_text.hpp"
#include "dem/scene/mechanism/snapshot_reading.hpp"
#include "tests/scenes/snapshot_scenes.hpp"
#include "tests/scenes/xml_tree.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <stdexcept>

using Catch::Matchers::Contains;
using Catch::Matchers::VectorContains;
using dem::FaceKind;
using scenes::elements;
using scenes::parse_elements;

namespace {

const app::WallView kView{1.0, 1000.0, {0.0, 2000.0}, 1.0}; // 1 px per mm
const app::MarkSizes kMarks{5e-4, 0.02};

std::size_t faces_open(const dem::Snapshot& wall, double threshold)
{
    return static_cast<std::size_t>(
        std::count_if(wall.faces.begin(), wall.faces.end(), [&](const dem::FaceState& face) {
            return face.kind != FaceKind::unit_crack &&
                   std::any_of(
                       face.contacts.begin(), face.contacts.end(),
                       [&](const dem::ContactState& c) { return c.opening > threshold; });
        }));
}

std::size_t cracks_with_damage(const dem::Snapshot& wall, double low, double high)
{
    return static_cast<std::size_t>(
        std::count_if(wall.faces.begin(), wall.faces.end(), [&](const dem::FaceState& face) {
            const double damage = face.contacts.front().damage;
            return face.kind == FaceKind::unit_crack && damage >= low && damage <= high;
        }));
}

std::string picture(const dem::Snapshot& peak, const dem::Snapshot& end,
                    const app::WallPictureText& text = {})
{
    return app::wall_picture(peak, end, text);
}

} // namespace

TEST_CASE("wall picture: every open joint is one gap, whatever its number of contacts",
          "[app][wall_svg]")
{
    const dem::Snapshot wall = scenes::stair_step_rocking(0.02);
    const auto gaps =
        elements(parse_elements(app::draw_openings(wall, kView, kMarks)), "polygon");
    CHECK(gaps.size() == faces_open(wall, 5e-4));
    CHECK(gaps.size() >= 18);
    for (const auto& gap : gaps) CHECK(scenes::points_of(gap).size() <= 2 * 4);
}

TEST_CASE("wall picture: openings up to the threshold are not marked", "[app][wall_svg]")
{
    const dem::Snapshot wall = scenes::stair_step_rocking(0.02);
    app::MarkSizes marks = kMarks;
    marks.threshold = 0.01;
    const auto gaps =
        elements(parse_elements(app::draw_openings(wall, kView, marks)), "polygon");
    CHECK(gaps.size() == faces_open(wall, 0.01));
    CHECK(gaps.size() < faces_open(wall, 5e-4));
}

TEST_CASE("wall picture: two separate gaps of one joint are drawn apart", "[app][wall_svg]")
{
    dem::Snapshot wall = scenes::wall_at_rest({.points = 6});
    auto& face = wall.faces.at(100);
    face.contacts[0].opening = face.contacts[5].opening = 0.01;
    CHECK(elements(parse_elements(app::draw_openings(wall, kView, kMarks)), "polygon").size() ==
          2);
}

TEST_CASE("wall picture: units cracked through are solid, damaged ones dashed, others unmarked",
          "[app][wall_svg]")
{
    const dem::Snapshot wall = scenes::diagonal_crack(0.01, 0.6);
    const auto marks = parse_elements(app::draw_cracks(wall, kView));
    CHECK(elements(marks, "polygon").size() == cracks_with_damage(wall, 1.0, 1.0));
    CHECK(elements(marks, "polygon").size() >= 2);
    // half of each: the first two of four contacts are damaged, so are the pieces that touch
    // them
    CHECK(elements(marks, "line").size() == 2 * cracks_with_damage(wall, 0.1, 0.9));
    CHECK(elements(marks, "line").size() >= 2);
    CHECK(app::draw_cracks(scenes::stair_step_rocking(0.03), kView).empty());
}

TEST_CASE("wall picture: slip is marked where a joint is closed, wider where it slid more",
          "[app][wall_svg]")
{
    dem::Snapshot wall = scenes::wall_at_rest();
    const auto set = [&](std::size_t face, double slip, double opening) {
        for (dem::ContactState& c : wall.faces.at(face).contacts) {
            c.slip = slip;
            c.opening = opening;
        }
    };
    const auto bed = static_cast<std::size_t>(
        std::find_if(wall.faces.begin(), wall.faces.end(),
                     [](const dem::FaceState& f) { return f.kind == FaceKind::bed_joint; }) -
        wall.faces.begin());
    set(bed, 0.02, 0.0);
    set(bed + 1, -0.01, 0.0);
    set(bed + 2, 0.02, 0.01);  // open: drawn as a gap
    set(bed + 3, 0.0004, 0.0); // below the threshold
    const auto lines = elements(parse_elements(app::draw_slips(wall, kView, kMarks)), "line");
    REQUIRE(lines.size() == 6); // two joints of three pieces
    const double range = app::kSlipWidest - app::kSlipThinnest;
    CHECK(scenes::number_of(lines[0], "stroke-width") == Approx(app::kSlipThinnest + range));
    CHECK(scenes::number_of(lines[5], "stroke-width") ==
          Approx(app::kSlipThinnest + range / 2));
    CHECK(dem::largest_slip(wall, 5e-4) == 0.02);
}

TEST_CASE("wall picture: half-arrows show which side goes where", "[app][wall_svg]")
{
    const double moved = GENERATE(0.01, -0.01); // [m] of the upper half of the wall
    dem::Snapshot wall = scenes::wall_at_rest();
    for (dem::BlockState& block : wall.blocks)
        if (block.course == 0 || block.course > 5)
            for (dem::Point& u : block.displacement) u.x = moved;
    for (dem::FaceState& face : wall.faces)
        for (dem::ContactState& c : face.contacts)
            if (face.kind == FaceKind::bed_joint && std::abs(c.at.z - 0.5) < 1e-9)
                c.slip = 0.01;
    const auto arrows =
        elements(parse_elements(app::draw_slips(wall, kView, kMarks)), "polyline");
    REQUIRE(arrows.size() == 2 * 10);
    for (std::size_t i = 0; i < arrows.size(); i += 2) {
        const auto upper = scenes::points_of(arrows[i]),
                   lower = scenes::points_of(arrows[i + 1]);
        CHECK(upper[0].second < lower[0].second);
        CHECK((upper[1].first > upper[0].first) == (moved > 0.0));
        CHECK((lower[1].first > lower[0].first) == (moved < 0.0));
    }
}

TEST_CASE("wall picture: two halves of a unit look like one stone", "[app][wall_svg]")
{
    const dem::Snapshot wall = scenes::wall_at_rest();
    const auto body = parse_elements(app::draw_blocks(wall, kView));
    const auto stones = elements(body, "polygon");
    REQUIRE(stones.size() == wall.blocks.size());
    for (std::size_t k = 1; k < 100; ++k)
        if (wall.blocks[k].unit == wall.blocks[k - 1].unit)
            CHECK(scenes::attribute(stones[k], "fill") ==
                  scenes::attribute(stones[k - 1], "fill"));

    std::set<std::pair<std::pair<double, double>, std::pair<double, double>>> drawn;
    for (const auto& line : elements(body, "polyline")) {
        const auto points = scenes::points_of(line);
        for (std::size_t i = 1; i < points.size(); ++i)
            drawn.insert(std::minmax(points[i - 1], points[i]));
    }
    for (const dem::FaceState& face : wall.faces) {
        const auto at = [&](std::size_t i) {
            const app::Pixel p = kView.place(face.contacts[i].at);
            return std::pair(std::stod(app::svg_number(p.x)), std::stod(app::svg_number(p.y)));
        };
        if (face.kind != FaceKind::beam_joint)
            CHECK(drawn.contains(std::minmax(at(1), at(2))) ==
                  (face.kind != FaceKind::unit_crack));
    }
}

TEST_CASE("wall picture: thrust is as wide as the compression, and tension has none",
          "[app][wall_svg]")
{
    dem::Snapshot wall = scenes::wall_at_rest();
    for (dem::FaceState& face : wall.faces)
        for (dem::ContactState& c : face.contacts)
            c.sigma = face.kind == FaceKind::bed_joint ? 1e6 : 0.0;
    CHECK(app::draw_thrust(wall, kView, 1e4).empty());
    CHECK(dem::largest_compression(wall) == 0.0);
    auto& face =
        *std::find_if(wall.faces.begin(), wall.faces.end(),
                      [](const dem::FaceState& f) { return f.kind == FaceKind::bed_joint; });
    for (dem::ContactState& c : face.contacts) c.sigma = -5e5; // on 0.1 m x 0.2 m: 10 kN
    CHECK(dem::largest_compression(wall) == Approx(1e4).epsilon(1e-12));
    const auto struts = elements(parse_elements(app::draw_thrust(wall, kView, 4e4)), "line");
    REQUIRE(struts.size() == 2);
    CHECK(scenes::number_of(struts[0], "stroke-width") == Approx(app::kThrustWidest / 4));
}

TEST_CASE("wall picture: the page states displacement, drift, force, factor and thresholds",
          "[app][wall_svg]")
{
    dem::Snapshot peak = scenes::stair_step_rocking(0.009),
                  end = scenes::stair_step_rocking(0.03);
    peak.force = 49712.0;
    app::WallPictureText text;
    text.title = "x < y & z";
    text.vertical_load = "0.50 MPa";
    const auto found = scenes::texts(scenes::parse_xml(picture(peak, end, text)));
    CHECK_THAT(found, VectorContains(std::string("x < y & z")));
    CHECK_THAT(found, VectorContains(std::string("9.0 mm,  drift 0.82 %,  49.7 kN")));
    CHECK(std::count(found.begin(), found.end(), "displacements drawn × 3") == 2);
    CHECK(std::count(found.begin(), found.end(), "0.50 MPa") == 2);
    CHECK_THAT(found, VectorContains(std::string("49.7 kN")));
    CHECK_THAT(found, VectorContains(std::string("joint open > 0.5 mm (drawn to scale)")));
    CHECK_THAT(found, VectorContains(std::string("200 mm")));
}

TEST_CASE("wall picture: the legend rounds to two digits and writes no powers of ten",
          "[app][wall_svg]")
{
    const auto found = scenes::texts(
        parse_elements(app::draw_wall_legend({0, 0}, 900, {2.5e-4, 0.1234}, 137.4e3, 1.0)));
    CHECK_THAT(found, VectorContains(std::string("compression up to 140 kN per face")));
    CHECK_THAT(found, VectorContains(std::string("closed joint slid 0.25 to 120 mm")));
}

TEST_CASE("wall picture: a movement too small for the common factor has its own",
          "[app][wall_svg]")
{
    const auto found = scenes::texts(scenes::parse_xml(
        picture(scenes::stair_step_rocking(0.002), scenes::stair_step_rocking(0.03))));
    CHECK_THAT(found, VectorContains(std::string("displacements drawn × 50")));
    CHECK_THAT(found, VectorContains(std::string("displacements drawn × 3")));
}

TEST_CASE("wall picture: the load arrow points where the load pushes", "[app][wall_svg]")
{
    dem::Snapshot wall = scenes::stair_step_rocking(0.01);
    const auto arrow_x = [&] { // of the force text in the first panel, [px]
        for (const auto& text : elements(scenes::parse_xml(picture(wall, wall)), "text"))
            if (text.data() == "40.0 kN") return scenes::number_of(text, "x");
        return -1.0;
    };
    wall.force = 40e3;
    const double pushed = arrow_x();
    wall.force = -40e3;
    CHECK(pushed > 0.0);
    CHECK(arrow_x() > pushed + 200.0);
}

TEST_CASE("wall picture: whatever the wall did, the picture has a page size and no holes",
          "[app][wall_svg]")
{
    dem::Snapshot apart = scenes::diagonal_crack(0.02, 1.0);
    for (dem::Point& u : apart.blocks.at(99).displacement) u = {300.0, 50.0}; // flew off
    dem::Snapshot bare = scenes::wall_at_rest();
    bare.faces.clear();
    bare.blocks.pop_back(); // no beam
    for (const dem::Snapshot& wall :
         {scenes::wall_at_rest(), apart, bare, scenes::wall_at_rest({.courses = 30}),
          scenes::wall_at_rest({.courses = 1, .half_units = 40})}) {
        const std::string text = picture(wall, wall);
        const auto page = elements(scenes::parse_xml(text), "svg").at(0);
        CHECK(scenes::number_of(page, "width") == 1000);
        CHECK(scenes::number_of(page, "height") > 150);
        CHECK(scenes::number_of(page, "height") < 850);
        const auto corner = scenes::points_of(elements(page, "polygon").at(0));
        CHECK(corner.at(3).first - corner.at(0).first >=
              8.0); // [px] the first half unit is seen
        CHECK(text.find("nan") == std::string::npos);
        CHECK(text.find("inf") == std::string::npos);
    }
}

TEST_CASE("wall picture: marks are smaller where stones are small", "[app][wall_svg]")
{
    const auto widest = [](const dem::Snapshot& wall) { // crack line in the picture [px]
        double width = 0.0;
        for (const auto& group : elements(scenes::parse_xml(picture(wall, wall)), "g"))
            if (scenes::attribute(group, "fill") == app::kCrackColour)
                width = std::max(width, scenes::number_of(group, "stroke-width"));
        return width;
    };
    CHECK(widest(scenes::diagonal_crack(0.01, 1.0)) == 3.0);
    CHECK(widest(scenes::diagonal_crack(0.01, 1.0, {.courses = 30})) < 1.7);
}

TEST_CASE("wall picture: bad walls and settings are refused", "[app][wall_svg]")
{
    const dem::Snapshot wall = scenes::wall_at_rest();
    dem::Snapshot bad = wall;
    bad.blocks[7].displacement[3].x = std::numeric_limits<double>::quiet_NaN();
    CHECK_THROWS_AS(picture(wall, bad), std::invalid_argument);
    CHECK_THROWS_AS(picture(wall, {}), std::invalid_argument);
    CHECK_THROWS_AS(picture(wall, wall, {.load_height = 0.0}), std::invalid_argument);
    CHECK_THROWS_AS(picture(wall, wall, {.mark_above = 0.0}), std::invalid_argument);
}

TEST_CASE("wall picture: a push that ends at its largest force is one panel", "[app][wall_svg]")
{
    dem::Snapshot wall = scenes::stair_step_rocking(0.03);
    wall.force = 40e3;
    const auto panels = [](const std::string& svg) {
        return elements(scenes::parse_xml(svg), "svg").size() - 1; // the page is one, too
    };
    CHECK(panels(picture(wall, wall)) == 1);
    CHECK_THAT(scenes::texts(scenes::parse_xml(picture(wall, wall))),
               VectorContains(std::string("At the end, at or near the largest force")));
    dem::Snapshot almost = wall;
    almost.displacement *= 0.995;
    almost.force *= 1.002;
    CHECK(panels(picture(almost, wall)) == 1);
    CHECK(panels(picture(scenes::stair_step_rocking(0.02), wall)) == 2);
}

TEST_CASE("wall picture: the force stands clear of the wall, and inside its panel",
          "[app][wall_svg]")
{
    dem::Snapshot wall = scenes::wall_at_rest();
    for (const double force : {9e3, 123456e3, -123456e3}) {
        wall.force = force;
        const auto page = scenes::parse_xml(picture(wall, wall));
        double left = 1e9, right = -1e9; // of the stones [px]
        for (const auto& stone : elements(page, "polygon"))
            if (scenes::points_of(stone).size() > 4)
                for (const auto& [x, y] : scenes::points_of(stone)) {
                    left = std::min(left, x);
                    right = std::max(right, x);
                }
        bool found = false;
        for (const auto& text : elements(page, "text")) {
            if (text.data() != app::fixed(std::abs(force) * 1e-3, 1) + " kN") continue;
            found = true;
            const double at = scenes::number_of(text, "x"),
                         wide = app::text_width(text.data(), 12.0);
            if (force > 0.0) {
                CHECK(at <= left - 5.0);
                CHECK(at - wide > 0.0);
            } else {
                CHECK(at >= right + 5.0);
                CHECK(at + wide < 1000.0);
            }
        }
        CHECK(found);
    }
}

TEST_CASE("wall picture: a force that is nothing beside the largest is written as nothing",
          "[app][wall_svg]")
{
    dem::Snapshot peak = scenes::stair_step_rocking(0.01),
                  end = scenes::stair_step_rocking(0.03);
    peak.force = 40e3;
    end.force = -4.2;
    for (const std::string& text : scenes::texts(scenes::parse_xml(picture(peak, end))))
        CHECK(text.find("0.0042") == std::string::npos);
}

TEST_CASE("wall picture: lintels have a colour of their own, which the legend names",
          "[app][wall_svg]")
{
    const dem::Snapshot wall = scenes::wall_at_rest();
    app::WallPictureText text;
    const auto tinted = [&] {
        int n = 0;
        for (const auto& stone :
             elements(scenes::parse_xml(picture(wall, wall, text)), "polygon"))
            n += scenes::attribute(stone, "fill") == app::kKindTints[1] ? 1 : 0;
        return n;
    };
    CHECK(tinted() == 0);
    text.tints.kind.assign(static_cast<std::size_t>(wall.blocks.front().unit), 0);
    text.tints.kind.back() = 1;
    text.tints.name = "lintels";
    CHECK(tinted() >= 1);
    CHECK_THAT(scenes::texts(scenes::parse_xml(picture(wall, wall, text))),
               VectorContains(std::string("lintels")));
}
