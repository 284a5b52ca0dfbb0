#include "tests/app/drawing/drawing_scenes.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <utility>

using scenes::area;
using scenes::drawing_of;
using scenes::dxf_line;
using scenes::dxf_text;
using scenes::lwpolyline;
using scenes::rectangle;

TEST_CASE(
    "dxf drawing: polylines closed by flag, by a repeated corner or within snap, with layers",
    "[app][dxf_drawing]")
{
    const app::Drawing drawing = drawing_of(
        "w.dxf",
        dxf_text(lwpolyline(scenes::rectangle(0, 0, 300, 100), true, "stone") +
                 lwpolyline({300, 0, 600, 0, 600, 100, 300, 100, 300, 0}, false, "brick") +
                 lwpolyline({0, 100, 600, 100, 600, 200, 0, 200, 0, 100.4}, false) +
                 "0\nPOLYLINE\n8\nold\n66\n1\n70\n1\n0\nVERTEX\n10\n0\n20\n200\n0\nVERTEX\n10\n"
                 "600\n20\n200\n"
                 "0\nVERTEX\n10\n300\n20\n300\n0\nSEQEND\n0\nTEXT\n1\nwall\n0\nPOINT\n10\n5\n20"
                 "\n5\n0\nTEXT\n1\nb\n"),
        {.unit = 1e-3});
    REQUIRE(drawing.blocks.size() == 4);
    CHECK(area(drawing) == Approx(0.03 + 0.03 + 0.06 + 0.03).epsilon(1e-12));
    CHECK(drawing.blocks[0].layer == "stone");
    CHECK(drawing.blocks[1].layer == "brick");
    CHECK(drawing.blocks[3].layer == "old");
    CHECK(scenes::notes(drawing, "1 POINT, 2 TEXT"));
    CHECK(scenes::common_sides(drawing) == 4); // the upper one has two below it
}

TEST_CASE("dxf drawing: lines close around blocks, shared or drawn twice", "[app][dxf_drawing]")
{
    const std::string frame = dxf_line(0, 0, 4, 0) + dxf_line(4, 0, 4, 2) +
                              dxf_line(4, 2, 0, 2) + dxf_line(0, 2, 0, 0);
    const app::Drawing shared =
        drawing_of("w.dxf", dxf_text(frame + dxf_line(0, 1, 4, 1, "bed") +
                                     dxf_line(2, 0, 2, 1) + dxf_line(1, 1, 1, 2)));
    CHECK(shared.blocks.size() == 4);
    CHECK(area(shared) == 8.0);
    CHECK(scenes::notes(shared, "7 lines enclose 4 blocks"));

    const app::Drawing apart =
        drawing_of("w.dxf", dxf_text(frame + dxf_line(4, 0, 5, 0) + dxf_line(5, 0, 5, 2) +
                                     dxf_line(5, 2, 4, 2) + dxf_line(4, 2, 4, 0)));
    CHECK(apart.blocks.size() == 2);
    CHECK(area(apart) == 10.0);
}

TEST_CASE(
    "dxf drawing: units that the file states are compared, the paper space is passed over",
    "[app][dxf_drawing]")
{
    const std::string block = lwpolyline(scenes::rectangle(0, 0, 2, 1));
    const std::string text =
        "0\nSECTION\n2\nHEADER\n9\n$INSUNITS\n70\n4\n9\n$X\n70\n6\n0\nENDSEC\n" +
        dxf_text(block + "0\nLINE\n67\n1\n10\n0\n20\n0\n11\n5\n21\n5\n");
    const app::Drawing drawing = drawing_of("w.dxf", text, {.unit = 1.0});
    CHECK(scenes::notes(drawing, "its unit is mm; it was read with a unit of 1000 mm"));
    CHECK(scenes::notes(drawing, "1 entity of the paper space"));
    CHECK(area(drawing) == 2.0);
    CHECK_FALSE(scenes::notes(drawing_of("w.dxf", dxf_text(block)), "its unit"));
}

TEST_CASE("dxf drawing: an entity seen from behind is mirrored", "[app][dxf_drawing]")
{
    const app::Drawing drawing = drawing_of(
        "w.dxf", dxf_text(lwpolyline(scenes::rectangle(0, 0, 1, 1)) +
                          lwpolyline({0, 0, 1, 0, 1, 1}) + "210\n0\n220\n0\n230\n-1\n"));
    REQUIRE(drawing.blocks.size() == 2); // at x in [0, 1] and [-1, 0]
    CHECK(scenes::common_sides(drawing) == 0);
    double right = 0.0;
    for (const dem::Point& p : drawing.blocks[0].outline) right = std::max(right, p.x);
    CHECK(right == 2.0);
}

TEST_CASE("dxf drawing: a portal drawn by others reads unedited", "[app][dxf_drawing]")
{
    // Drawings of other programs are not part of this repository: their folder is named by the
    // environment.
    const char* folder = std::getenv("DRYSTONE_DRAWINGS");
    if (folder == nullptr) return;
    const app::Drawing drawing =
        app::read_drawing(std::filesystem::path(folder) / "Portal.dxf", {.unit = 1e-3});
    CHECK(drawing.blocks.size() == 41);
    CHECK(area(drawing) == Approx(3.4068).epsilon(1e-4));
    CHECK(drawing.notes.empty());
    CHECK(scenes::common_sides(drawing) == 87);
}

TEST_CASE("dxf drawing: layers that are off or frozen and invisible entities are not built",
          "[app][dxf_drawing]")
{
    const std::string shown = lwpolyline(rectangle(0, 0, 2, 1), true, "wall"),
                      other = lwpolyline(rectangle(0, 1, 2, 2), true, "Infill");
    const auto file = [&](int flags, int colour, const std::string& more) {
        return drawing_of(
            "w.dxf",
            "0\nSECTION\n2\nTABLES\n0\nTABLE\n2\nLAYER\n70\n1\n0\nLAYER\n2\nINFILL\n70\n" +
                std::to_string(flags) + "\n62\n" + std::to_string(colour) +
                "\n0\nENDTAB\n0\nENDSEC\n" + dxf_text(shown + more),
            {.unit = 1.0});
    };
    CHECK(file(0, 7, other).blocks.size() == 2);
    CHECK(file(4, 7, other).blocks.size() == 2); // locked
    const std::string arc = "0\nARC\n8\nInfill\n10\n1\n20\n1\n40\n1\n50\n0\n51\n90\n";
    const std::string old =
        "0\nPOLYLINE\n8\nInfill\n66\n1\n70\n1\n0\nVERTEX\n8\nInfill\n10\n0\n"
        "20\n1\n0\nSEQEND\n";
    for (const auto& [flags, colour] : {std::pair{0, -7}, {1, 7}}) {
        const app::Drawing wall = file(flags, colour, other + arc + old);
        CHECK(wall.blocks.size() == 1);
        CHECK(scenes::notes(wall, "1 hidden layer (Infill) with 3 shapes was ignored"));
    }
    const app::Drawing invisible = file(0, 7, other + "60\n1\n");
    CHECK(invisible.blocks.size() == 1);
    CHECK(scenes::notes(invisible, "1 hidden shape was ignored"));
}

TEST_CASE(
    "dxf drawing: the unit of the file is taken where none is given, and the given one wins",
    "[app][dxf_drawing]")
{
    const auto wall = [](int code, bool given) {
        return drawing_of("w.dxf",
                          "0\nSECTION\n2\nHEADER\n9\n$INSUNITS\n70\n" + std::to_string(code) +
                              "\n0\nENDSEC\n" + dxf_text(lwpolyline(rectangle(0, 0, 200, 100))),
                          {.unit = 1e-3, .unit_given = given});
    };
    CHECK(scenes::area(wall(0, false)) == Approx(0.02));
    CHECK(scenes::area(wall(5, false)) == Approx(2.0));
    CHECK(scenes::area(wall(14, false)) == Approx(200.0));
    CHECK(scenes::notes(wall(5, false),
                        "The file says that its unit is cm; the wall is 2 x 1 m. "
                        "Set wall.length_unit to override."));
    CHECK(scenes::notes(wall(0, false), "states no unit of length"));
    CHECK(scenes::area(wall(14, true)) == Approx(0.02));
    CHECK(scenes::notes(wall(14, true), "unit is dm; it was read with a unit of 1 mm"));
}

TEST_CASE(
    "dxf drawing: stones of four lines each, off by as much as people draw, are all there",
    "[app][dxf_drawing]")
{
    const std::vector<scenes::Outline> stones = scenes::running_bond(5, 4);
    for (unsigned seed = 0; seed < 20; ++seed) {
        INFO(seed);
        unsigned state = seed;
        const auto off = [&] { // [mm], up to 0.3 to either side
            state = state * 1664525U + 1013904223U;
            return 0.6 * (static_cast<double>(state >> 8) / 16777216.0 - 0.5);
        };
        std::string lines;
        for (scenes::Outline o : stones) {
            for (double& coordinate : o) coordinate += off();
            for (std::size_t k = 0; k < 8; k += 2)
                lines += dxf_line(o[k], o[k + 1], o[(k + 2) % 8], o[(k + 3) % 8]);
        }
        const app::DrawingOptions snap{.unit = 1e-3, .snap = 5e-4};
        const std::string why = scenes::refusal("w.dxf", dxf_text(lines), snap);
        if (why != "read") { // lines that cross by more than snap
            CHECK(why.find("make wall.snap (0.5 mm) larger") != std::string::npos);
            continue;
        }
        const app::Drawing wall = drawing_of("w.dxf", dxf_text(lines), snap);
        CHECK(wall.blocks.size() == stones.size());
        CHECK(area(wall) == Approx(0.4).epsilon(0.005));
    }
}

TEST_CASE("dxf drawing: a strip between lines is a gap up to twice wall.snap, a stone beyond",
          "[app][dxf_drawing]")
{
    const auto strip = [](double width) { // between two stones of four lines each
        std::string lines;
        for (const double left : {0.0, 200.0 + width}) {
            lines += dxf_line(left, 0, left + 200, 0) +
                     dxf_line(left + 200, 0, left + 200, 100) +
                     dxf_line(left + 200, 100, left, 100) + dxf_line(left, 100, left, 0);
        }
        lines += dxf_line(200, 0, 200 + width, 0) + dxf_line(200, 100, 200 + width, 100);
        return drawing_of("w.dxf", dxf_text(lines), {.unit = 1e-3, .snap = 5e-4});
    };
    CHECK(strip(0.9).blocks.size() == 2);
    CHECK(scenes::notes(strip(0.9),
                        "1 area between lines, at most 1 mm wide, was taken as a gap"));
    CHECK(strip(1.2).blocks.size() == 3);
}

TEST_CASE("dxf drawing: an outline that runs on over its own first sides is read without that",
          "[app][dxf_drawing]")
{
    const auto read = [](const scenes::Outline& corners, bool closed) {
        return drawing_of("w.dxf", dxf_text(lwpolyline(corners, closed)), {.unit = 1e-3});
    };
    const scenes::Outline plain = {0, 0, 56, 0, 56, 100, 0, 100};
    for (const bool closed : {false, true})
        for (const scenes::Outline& rest : {scenes::Outline{0, 0, 56, 0},
                                            {0, 0, 56, 0, 56, 100},
                                            {0, 0, 30, 0},
                                            {0, 0.3, 30, 0, 56, 0, 56, 40}}) {
            scenes::Outline corners = plain;
            corners.insert(corners.end(), rest.begin(), rest.end());
            const app::Drawing wall = read(corners, closed);
            REQUIRE(wall.blocks.size() == 1);
            CHECK(wall.blocks.front().outline.size() == 4);
            CHECK(area(wall) == Approx(0.0056).epsilon(1e-12));
            CHECK(scenes::notes(wall, "1 outline runs on over its own first sides"));
        }
    CHECK(read({0, 0, 56, 0, 56, 100, 0, 100, 0, 0}, false).notes.empty());
    // back over the last side, or beyond the first one: no such outline
    for (const scenes::Outline& corners :
         {scenes::Outline{0, 0, 56, 0, 56, 100, 0, 100, 0, 0, 0, 50},
          {0, 0, 56, 0, 56, 100, 0, 100, 0, 0, 80, 0}})
        CHECK(scenes::refusal("w.dxf", dxf_text(lwpolyline(corners, false)), {.unit = 1e-3})
                  .starts_with("w.dxf:6: this outline is open"));
}

TEST_CASE(
    "dxf drawing: an open outline of four corners is closed if wall.close_outlines says so",
    "[app][dxf_drawing]")
{
    const std::string block = lwpolyline(rectangle(0, 0, 300, 100));
    const std::string open = lwpolyline({300, 0, 600, 0, 600, 100, 300, 100}, false);
    const std::string two = lwpolyline({300, 0, 600, 0, 600, 100}, false);
    app::DrawingOptions options{.unit = 1e-3};
    CHECK_THAT(scenes::refusal("w.dxf", dxf_text(block + open), options),
               Catch::StartsWith("w.dxf:30: this outline is open") &&
                   Catch::Contains("100 mm apart") &&
                   Catch::Contains("wall.close_outlines = yes would close it"));
    CHECK_THAT(scenes::refusal("w.dxf", dxf_text(block + two), options),
               Catch::Contains("is open") && !Catch::Contains("close_outlines"));
    options.close_outlines = true;
    const app::Drawing wall = drawing_of("w.dxf", dxf_text(block + open), options);
    CHECK(wall.blocks.size() == 2);
    CHECK(area(wall) == Approx(0.06));
    CHECK(scenes::notes(wall, "1 outline was open and was closed by a straight side "
                              "(wall.close_outlines); the gap was 100 mm, of line 30."));
    CHECK_THAT(scenes::refusal("w.dxf", dxf_text(block + two), options),
               Catch::Contains("is open"));
}

TEST_CASE("dxf drawing: an entity without a layer is on layer 0, hidden if that is off",
          "[app][dxf_drawing]")
{
    const std::string bare =
        "0\nLWPOLYLINE\n90\n4\n70\n1\n10\n0\n20\n1\n10\n2\n20\n1\n10\n2\n20\n2\n"
        "10\n0\n20\n2\n";
    const auto file = [&](int colour) {
        return drawing_of("w.dxf",
                          "0\nSECTION\n2\nTABLES\n0\nLAYER\n2\n0\n70\n0\n62\n" +
                              std::to_string(colour) + "\n0\nENDSEC\n" +
                              dxf_text(lwpolyline(rectangle(0, 0, 2, 1), true, "wall") + bare),
                          {.unit = 1.0});
    };
    CHECK(file(7).blocks.size() == 2);
    CHECK(file(-7).blocks.size() == 1);
    CHECK(scenes::notes(file(-7), "1 hidden layer (0) with 1 shape was ignored"));
}

TEST_CASE(
    "dxf drawing: bulges of no height are straight sides, and a byte order mark is no code",
    "[app][dxf_drawing]")
{
    const auto file = [&](const std::string& bulge) {
        return dxf_text(lwpolyline(rectangle(0, 0, 2, 1)) + "42\n" + bulge + "\n");
    };
    CHECK(area(drawing_of("w.dxf", "\xef\xbb\xbf" + file("-1e-12"), {.unit = 1.0})) == 2.0);
}

TEST_CASE("dxf drawing: a file without a unit of length says what it was read in",
          "[app][dxf_drawing]")
{
    const std::string text = dxf_text(lwpolyline(rectangle(0, 0, 200, 100)));
    CHECK(scenes::notes(drawing_of("w.dxf", text, {.unit = 1e-3, .unit_given = false}),
                        "one unit was read as 1 mm, and the wall is 0.2 x 0.1 m."));
    CHECK(drawing_of("w.dxf", text, {.unit = 1e-2}).notes.empty());
}

TEST_CASE("dxf drawing: names of layers are read as people see them", "[app][dxf_drawing]")
{
    const auto layer = [](const std::string& name) {
        return drawing_of("w.dxf", dxf_text(lwpolyline(rectangle(0, 0, 2, 1), true, name)))
            .blocks.front()
            .layer;
    };
    CHECK(layer("S\\U+00FCd") == "S\u00fcd");
    CHECK(layer("\\U+77F3\\U+5899") == "\u77f3\u5899");
    CHECK(layer("\\U+D83E\\U+DDF1") == "\U0001f9f1"); // two units of UTF-16
    CHECK(layer("S\u00fcd") == "S\u00fcd");           // UTF-8
    CHECK(layer("S\xfc"
                "d\x80") == "S\u00fcd\u20ac"); // ANSI_1252
    // what is no escape stays
    for (const char* plain :
         {"a\\U+00F", "\\U+00FG", "\\U00FC", "\\U+D83E", "\\U+DDF1\\U+D83E", "a\\", "50%%d"})
        CHECK(layer(plain) == plain);
    // one name, whichever way it is written
    const std::string tables =
        "0\nSECTION\n2\nTABLES\n0\nLAYER\n2\nf\\U+00FCr\n70\n1\n62\n7\n0\n"
        "ENDSEC\n";
    CHECK(drawing_of("w.dxf",
                     tables + dxf_text(lwpolyline(rectangle(0, 0, 2, 1)) +
                                       lwpolyline(rectangle(0, 1, 2, 2), true, "f\xfcr")),
                     {.unit = 1.0})
              .blocks.size() == 1);
}

TEST_CASE("dxf drawing: the frame of the sheet is no stone", "[app][dxf_drawing]")
{
    const app::Drawing drawing =
        drawing_of("w.dxf", dxf_text(lwpolyline(rectangle(-1, -1, 5, 4), true, "frame") +
                                     lwpolyline(rectangle(0, 0, 2, 1)) +
                                     lwpolyline(rectangle(0, 1, 2, 2))));
    CHECK(drawing.blocks.size() == 2);
    CHECK(scenes::notes(drawing, "goes around all stones"));
}

TEST_CASE("dxf drawing: lines divide an outline into stones", "[app][dxf_drawing]")
{
    const std::string lines =
        dxf_line(0, 1, 4, 1) + dxf_line(2, 0, 2, 1) + dxf_line(1, 1, 1, 2, "head");
    const app::Drawing drawing =
        drawing_of("w.dxf", dxf_text(lwpolyline(rectangle(0, 0, 4, 2), true, "wall") + lines));
    CHECK(drawing.blocks.size() == 4);
    CHECK(area(drawing) == 8.0);
    CHECK(scenes::common_sides(drawing) == 5);
    CHECK(scenes::notes(drawing, "is divided by lines"));
    const app::Drawing polylines = drawing_of(
        "w.dxf", dxf_text(lwpolyline(rectangle(0, 0, 4, 2)) + lwpolyline({0, 1, 4, 1}, false) +
                          lwpolyline({2, 0, 2, 1}, false) + lwpolyline({1, 1, 1, 2}, false)));
    CHECK(polylines.blocks.size() == 4);
    // in the frame of a sheet, and beside a stone of its own that shares a line's place
    const std::string beside = lwpolyline(rectangle(4, 0, 5, 2)) + dxf_line(4, 0, 4, 2);
    const app::Drawing framed = drawing_of(
        "w.dxf", dxf_text(lwpolyline(rectangle(-1, -1, 6, 4)) +
                          lwpolyline(rectangle(0, 0, 4, 2), true, "wall") + lines + beside));
    CHECK(framed.blocks.size() == 5);
    CHECK(area(framed) == 10.0);
}

TEST_CASE("dxf drawing: joints drawn through each other are cut where they cross",
          "[app][dxf_drawing]")
{
    std::string lines;
    for (const double at : {0.0, 1.0, 2.0, 3.0})
        lines += dxf_line(0, at, 3, at) + dxf_line(at, 0, at, 3);
    const app::Drawing drawing = drawing_of("w.dxf", dxf_text(lines));
    CHECK(drawing.blocks.size() == 9);
    CHECK(area(drawing) == Approx(9.0));
    CHECK(scenes::common_sides(drawing) == 12);
    CHECK(scenes::notes(drawing, "4 crossings of two lines: both were cut there."));
}

TEST_CASE("dxf drawing: arcs are straight pieces within half of wall.snap, the same from both "
          "sides",
          "[app][dxf_drawing]")
{
    // a quarter of a ring, 1 to 1.3 m, of two voussoirs, and stone between it and a corner
    const double c = std::sqrt(0.5);
    const auto corner = [](double x, double y, double bulge) {
        return "10\n" + std::to_string(x) + "\n20\n" + std::to_string(y) + "\n42\n" +
               std::to_string(bulge) + "\n";
    };
    const auto outline = [](const std::string& corners) {
        return "0\nLWPOLYLINE\n8\n0\n70\n1\n" + corners;
    };
    const double r = 1.3;
    const app::DrawingOptions metres{.unit = 1.0};
    const double quarter = std::acos(-1.0) / 4.0;
    const auto bulge = [&](double angle) { return std::tan(angle / 4.0); };
    const std::string ring = outline(corner(1, 0, 0) + corner(r, 0, bulge(quarter)) +
                                     corner(r * c, r * c, 0) + corner(c, c, -bulge(quarter))) +
                             outline(corner(c, c, 0) + corner(r * c, r * c, bulge(quarter)) +
                                     corner(0, r, 0) + corner(0, 1, -bulge(quarter)));
    const std::string spandrel =
        outline(corner(r, 0, 0) + corner(r, r, 0) + corner(0, r, -bulge(2 * quarter)));
    const app::Drawing drawing = drawing_of("w.dxf", dxf_text(ring + spandrel), metres);
    REQUIRE(drawing.blocks.size() == 3);
    CHECK(area(drawing) == Approx(r * r - std::acos(-1.0) / 4.0).epsilon(1e-3));
    CHECK(scenes::common_sides(drawing) > 20); // the spandrel has the corners of the ring
    CHECK(scenes::notes(drawing, "5 arcs became straight pieces, at most 0.25 mm off"));
    // seen from behind: x to the left, arcs the other way round
    const std::string behind =
        outline(corner(-1, 0, 0) + corner(-r, 0, -bulge(quarter)) + corner(-r * c, r * c, 0) +
                corner(-c, c, bulge(quarter)) + "230\n-1\n") +
        outline(corner(c, c, 0) + corner(r * c, r * c, bulge(quarter)) + corner(0, r, 0) +
                corner(0, 1, -bulge(quarter)));
    const app::Drawing turned = drawing_of("w.dxf", dxf_text(behind + spandrel), metres);
    CHECK(area(turned) == Approx(area(drawing)).epsilon(1e-9));
    CHECK(scenes::common_sides(turned) == scenes::common_sides(drawing));
    // the same ring of lines and arcs
    const auto arc = [](double radius, double from, double to) {
        return "0\nARC\n8\n0\n10\n0\n20\n0\n40\n" + std::to_string(radius) + "\n50\n" +
               std::to_string(from) + "\n51\n" + std::to_string(to) + "\n";
    };
    const std::string from_behind = arc(r, 90, 180) + "230\n-1\n"; // x to the left
    const app::Drawing lines =
        drawing_of("w.dxf",
                   dxf_text(arc(1.0, 0, 90) + from_behind + dxf_line(1, 0, r, 0) +
                            dxf_line(c, c, r * c, r * c) + dxf_line(0, 1, 0, r)),
                   metres);
    CHECK(lines.blocks.size() == 2);
    CHECK(area(lines) == Approx(quarter * (r * r - 1.0)).epsilon(1e-3));
}
