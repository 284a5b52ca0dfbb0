#include "app/drawing_scenes.hpp"

#include <catch2/catch.hpp>

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
    CHECK(wall.blocks[2].place == "line 4");
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
    CHECK(why("<use x=\"1\" y=\"2\"/>").starts_with("w.svg:3: at (1, 2) there is a clone"));
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
    CHECK(refusal("w.svg", "<html/>").starts_with("w.svg:1: is not SVG: it begins with <html>"));
    std::string deep;
    for (int i = 0; i < 100'000; ++i) deep += "<g>";
    CHECK(why(deep).find("more than 256 deep") != std::string::npos);
}
