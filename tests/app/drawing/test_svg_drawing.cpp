#include "tests/app/drawing/drawing_scenes.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <string>

using scenes::area;
using scenes::drawing_of;
using scenes::refusal;

namespace {

std::string svg_text(const std::string& shapes)
{
    return "<?xml version=\"1.0\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\">\n" + shapes +
           "\n</svg>\n";
}

double left_of(const app::DrawnBlock& block)
{
    return std::ranges::min(block.outline, {}, &dem::Point::x).x;
}

} // namespace

TEST_CASE(
    "svg drawing: paths, polygons, polylines, rectangles and lines are blocks, y downwards",
    "[app][svg_drawing]")
{
    const app::Drawing wall =
        drawing_of("w.svg", svg_text(R"x(<path d="M0 2h1v-1H0z m 1 0 l1,0 0-1-1 0Z"/>
        <polygon points="2,2 3,2 3,1 2,1"/>
        <polyline points="3 2 4 2 4 1 3 1 3 2"/>
        <rect x="0" width="4" height="1"/>
        <line x1="0" y1="0" x2="4" y2="0"/><line x1="4" y1="0" x2="2" y2="-1"/><line x1="2" y1="-1" x2="0" y2="0"/>
        <text x="1" y="1">wall<tspan>of</tspan></text><title>t</title>)x"));
    REQUIRE(wall.blocks.size() == 6);
    CHECK(area(wall) == Approx(4.0 + 4.0 + 2.0).epsilon(1e-12));
    CHECK(scenes::common_sides(wall) == 3 + 4 + 1);
    CHECK(wall.blocks[0].outline[0].z == 0.0); // y = 2 is the floor
    CHECK(scenes::notes(wall, "1 text"));
}

TEST_CASE("svg drawing: transforms of groups and shapes are applied, and groups are layers",
          "[app][svg_drawing]")
{
    const app::Drawing wall =
        drawing_of("w.svg", svg_text(R"x(<g id="g1" transform="translate(10, 20) scale(2)">
        <g xmlns:inkscape="i" inkscape:label="bricks" transform="rotate(45) rotate(45)"><rect id="r" width="1" height="2"/></g>
        <rect width="1" height="1" transform="matrix(1 0 0 1 0 0)"/></g>
        <rect x="12" y="20" width="1" height="2" transform="rotate(180 12.5 21) skewX(0)"/>)x"));
    REQUIRE(wall.blocks.size() == 3);
    CHECK(area(wall.blocks[0]) ==
          Approx(8.0).epsilon(1e-12)); // x from 6 to 10, y from 20 to 22
    CHECK(wall.blocks[0].layer == "bricks");
    CHECK(wall.blocks[1].layer == "g1");
    CHECK(wall.blocks[2].layer.empty());
    CHECK(scenes::common_sides(wall) == 2);
    CHECK(area(wall) == Approx(14.0).epsilon(1e-12));
}

TEST_CASE("svg drawing: the size of the page tells its unit", "[app][svg_drawing]")
{
    const std::string page =
        R"x(<svg width="500mm" height="1m" viewBox="0 0 1000 500"><rect width="1000" height="500"/></svg>)x";
    CHECK(scenes::notes(drawing_of("w.svg", page, {.unit = 1e-3}),
                        "its unit is 0.5 mm; it was read with a unit of 1 mm"));
    CHECK_FALSE(scenes::notes(drawing_of("w.svg", page, {.unit = 5e-4}), "its unit"));
}

TEST_CASE("svg drawing: what has no straight outline is refused with line and coordinates",
          "[app][svg_drawing]")
{
    const auto why = [](const std::string& shapes) {
        return refusal("w.svg", svg_text(shapes));
    };
    CHECK(why("<path d=\"M0 0 L3 4 C 5 5 6 6 7 7 Z\"/>")
              .starts_with("w.svg:3: a path has a curve (C) that begins at (3, 4)"));
    CHECK(why("\n<circle cx=\"3\" cy=\"4\" r=\"1\"/>")
              .starts_with("w.svg:4: at (3, 4) there is a circle"));
    CHECK(why("<rect width=\"3\" height=\"4\" rx=\"1\"/>")
              .starts_with("w.svg:3: the rectangle at (0, 0) has rounded corners"));
    CHECK(why("<rect width=\"3mm\" height=\"4\"/>").starts_with("w.svg:3: width is \"3mm\""));
    CHECK(why("<polyline points=\"0,0 1,0 1,1\"/>")
              .starts_with(
                  "w.svg:3: this outline is open: it begins at (0, 0) and ends at (1, 1)"));
    CHECK(why("<g transform=\"turn(3)\"/>")
              .starts_with("w.svg:3: the transform \"turn\" with 1 number is unknown"));
    CHECK(
        why("<path d=\"M0 0 L1 nan\"/>").starts_with("w.svg:3: expected a number at \"nan\""));
    CHECK(why("<path d=\"M0 0 X\"/>").starts_with("w.svg:3: a path has the command \"X\""));
    CHECK(why("<g>").starts_with("w.svg:4: is not XML (mismatched tag)"));
    CHECK(why("").starts_with("w.svg: holds no closed outline"));
    CHECK(
        refusal("w.svg", "<html/>").starts_with("w.svg:1: is not SVG: it begins with <html>"));
    std::string deep;
    for (int i = 0; i < 100'000; ++i) deep += "<g>";
    CHECK(why(deep).find("more than 256 deep") != std::string::npos);
}

TEST_CASE("svg drawing: clones are read at their places, also of groups, symbols and clones",
          "[app][svg_drawing]")
{
    const app::Drawing wall = drawing_of("w.svg", svg_text(R"x(
        <use href="#later" y="1"/>
        <defs><g id="course"><rect width="1" height="1"/><rect x="1" width="1" height="1"/></g>
        <symbol id="mark"><rect width="2" height="1" transform="translate(0, 2)"/></symbol></defs>
        <g id="upper"><use href="#course"/></g>
        <use xmlns:xlink="l" xlink:href=" #again " transform="translate(2) scale(1, 2)"/>
        <g display="none"><use id="again" href="#course"/></g>
        <use href="#mark"/>
        <g transform="translate(-2, 0)"><rect id="later" x="2" y="1" width="2" height="1"/></g>)x"));
    REQUIRE(wall.blocks.size() == 7);
    CHECK(area(wall.blocks[0]) == Approx(2.0).epsilon(1e-12));
    CHECK(left_of(wall.blocks[0]) == 2.0);   // without the group around its original
    CHECK(wall.blocks[1].layer == "course"); // the innermost group
    CHECK(area(wall.blocks[3]) == Approx(2.0).epsilon(1e-12));
    CHECK(left_of(wall.blocks[5]) == 0.0);
    CHECK(area(wall) == Approx(2.0 + 2.0 + 4.0 + 2.0 + 2.0).epsilon(1e-12));
    CHECK(scenes::notes(wall, "hidden"));
}

TEST_CASE("svg drawing: clones of what is not there, of themselves or without end are refused",
          "[app][svg_drawing]")
{
    const auto why = [](const std::string& shapes) {
        return refusal("w.svg", svg_text(shapes));
    };
    CHECK(why("<use x=\"1\"/>")
              .starts_with("w.svg:3: a clone (use) does not name an element of this file"));
    CHECK_THAT(why("<use href=\"stones.svg#a\"/>"), Catch::Contains("of this file; unlink it"));
    CHECK_THAT(why("<use href=\"#a\"/>"),
               Catch::Contains("repeats \"#a\", which is not there"));
    CHECK_THAT(why("<g id=\"a\">\n<use href=\"#a\"/></g>"),
               Catch::Contains("w.svg:4: a clone (use) repeats itself"));
    CHECK_THAT(why("<symbol id=\"a\" viewBox=\"0 0 1 1\"/><use href=\"#a\"/>"),
               Catch::Contains("a symbol that has a viewBox"));
    std::string laughs = "<defs><g id=\"g0\"><text/></g>";
    for (int i = 1; i < 20; ++i) {
        const std::string clone = "<use href=\"#g" + std::to_string(i - 1) + "\"/>";
        laughs += "<g id=\"g" + std::to_string(i) + "\">" + clone + clone + clone + "</g>";
    }
    CHECK_THAT(why(laughs + "</defs><use href=\"#g19\"/>"),
               Catch::Contains("repeat more than 100000 elements"));
}

TEST_CASE("svg drawing: a curve whose control points are on its chord is a straight side",
          "[app][svg_drawing]")
{
    const app::Drawing wall =
        drawing_of("w.svg", svg_text(R"x(<path d="M0 0C0.3 0 0.7 0 1 0S2 0 3 0 q 0 0.5 0 1 t 0 1
            c -1 0.0005 -1 0 -3 0 T 0 0 Z"/>)x"));
    REQUIRE(wall.blocks.size() == 1);
    CHECK(area(wall) == Approx(6.0).epsilon(1e-12));
    const auto refused = [](const std::string& d) {
        CHECK_THAT(refusal("w.svg", svg_text("<path d=\"M0 0 h4 v2 " + d + " z\"/>")),
                   Catch::Contains("a path has a curve"));
    };
    refused("C 3 2.01 1 2 0 2"); // beside the chord
    refused("C 5 2 1 2 0 2");    // before its begin
    refused("Q -1 2 0 2");       // behind its end
    refused("c 0 0 -0.5 0 -1 0 s -0.5 1 -3 0");
    refused("c 0 0 -0.5 0 -1 0 s -2 0 -2 1"); // S begins along the last one
    refused("q -1 0 -2 0 t -2 1");
    refused("A 1 1 0 0 0 0 2");
}

TEST_CASE("svg drawing: what is not shown is not built, whichever way it is hidden",
          "[app][svg_drawing]")
{
    const std::string shown = R"(<rect width="2" height="1"/>)",
                      other = R"(<rect y="1" width="2" height="1")";
    const auto svg = [&](const std::string& more) {
        return drawing_of("w.svg",
                          "<svg xmlns='s' viewBox='0 0 2 2'>" + shown + more + "</svg>",
                          {.unit = 1.0});
    };
    CHECK(svg(other + "/>").blocks.size() == 2);
    for (const char* hidden : {R"(display="none")", R"(style="fill:#aaa; display : none")",
                               R"(visibility="hidden")", R"(style="visibility:collapse")"}) {
        INFO(hidden);
        const app::Drawing alone = svg(other + " " + hidden + "/>");
        CHECK(alone.blocks.size() == 1);
        CHECK(scenes::notes(alone, "1 hidden shape was ignored"));
        const app::Drawing group = svg("<g id='infill' " + std::string(hidden) + "><g>" +
                                       other + "/><circle r='1'/></g><text/></g>");
        CHECK(group.blocks.size() == 1);
        CHECK(scenes::notes(group, "1 hidden layer (infill) with 2 shapes was ignored"));
    }
    const std::string sheet =
        "<style>/* .a */ .b, .st1 { display: none; } rect{cursor:move}</style>";
    CHECK(svg("<defs>" + sheet + "</defs>" + other + " class='a st1'/>").blocks.size() == 1);
    CHECK(svg(sheet + other + " class='a'/>").blocks.size() == 2);
    CHECK(svg(sheet + other + " class='b' style='display:inline'/>").blocks.size() == 2);
    // what lies within may be visible again, but not displayed again
    CHECK(
        svg("<g visibility='hidden'>" + other + " visibility='visible'/></g>").blocks.size() ==
        2);
    CHECK(svg("<g display='none'>" + other + " display='inline'/></g>").blocks.size() == 1);
}

TEST_CASE("svg drawing: the transform of a style moves as that of an attribute does",
          "[app][svg_drawing]")
{
    const auto svg = [&](const std::string& attributes) {
        return "<svg xmlns='s' viewBox='0 0 2 2'><rect width='1' height='1'/><rect width='1' "
               "height='1' " +
               attributes + "/></svg>";
    };
    for (const char* moved :
         {"transform='translate(1, 0)'", "style='transform: translate(1px,0)'",
          "transform='translate(9, 9)' style='transform:translate(1px, 0px) rotate(0deg)'"}) {
        INFO(moved);
        CHECK(scenes::common_sides(drawing_of("w.svg", svg(moved), {.unit = 1.0})) == 1);
    }
    for (const char* refused :
         {"style='transform: translate(50%, 0)'", "style='transform: rotate(0.1turn)'",
          "style='transform: rotate(90deg); transform-origin: 50% 50%'"})
        CHECK_THAT(scenes::refusal("w.svg", svg(refused), {.unit = 1.0}),
                   Catch::Contains("apply the transforms in the drawing program"));
}

TEST_CASE("svg drawing: a file that states a length is read in it where no unit is given",
          "[app][svg_drawing]")
{
    const auto wall = [](const std::string& width, bool given) {
        return drawing_of(
            "w.svg",
            "<svg xmlns='s' width='" + width +
                "' viewBox='0 0 2000 1000'><rect width='2000' height='1000'/></svg>",
            {.unit = 1e-3, .unit_given = given});
    };
    const auto length = [](const app::Drawing& d) {
        return std::sqrt(2.0 * area(d)); // twice as long as high
    };
    CHECK(length(wall("200cm", false)) == Approx(2.0));
    CHECK(length(wall("2in", false)) == Approx(0.0508));
    CHECK(length(wall("720pt", false)) == Approx(0.254));
    CHECK(scenes::notes(wall("400cm", false),
                        "; the wall is 4 x 2 m. Set wall.length_unit to override."));
    CHECK(length(wall("400cm", true)) == Approx(2.0));
    CHECK(scenes::notes(wall("400cm", true), "unit is 2 mm; it was read with a unit of 1 mm"));
    CHECK(length(wall("2000px", false)) == Approx(2.0));
    CHECK(scenes::notes(wall("2000px", false), "px, which are not lengths"));
}

TEST_CASE("svg drawing: a path that runs on over its first sides, and one that is open",
          "[app][svg_drawing]")
{
    const auto svg = [](const std::string& path) {
        return "<svg xmlns=\"http://www.w3.org/2000/svg\">\n<path d=\"" + path + "\"/>\n</svg>";
    };
    const app::DrawingOptions options{.unit = 1e-3};
    const app::Drawing wall =
        scenes::drawing_of("w.svg", svg("M 0 0 H 56 V 100 H 0 V 0 H 56"), options);
    REQUIRE(wall.blocks.size() == 1);
    CHECK(scenes::area(wall) == Approx(0.0056));
    CHECK(scenes::notes(wall, "1 outline runs on over its own first sides once it has closed "
                              "(line 2)"));
    const std::string open = svg("M 0 0 H 56 V 100 H 0");
    CHECK_THAT(scenes::refusal("w.svg", open, options),
               Catch::StartsWith("w.svg:2: this outline is open") &&
                   Catch::Contains("wall.close_outlines"));
    CHECK(scenes::drawing_of("w.svg", open, {.unit = 1e-3, .close_outlines = true})
              .blocks.size() == 1);
}
