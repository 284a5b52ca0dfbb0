#include "tests/app/drawing/drawing_scenes.hpp"

#include <catch2/catch.hpp>

#include <string>
#include <vector>

using scenes::dxf_line;
using scenes::dxf_text;
using scenes::json_text;
using scenes::lwpolyline;
using scenes::rectangle;
using scenes::refusal;

namespace {

struct Bad {
    std::string name, text, begin; ///< of the message
    std::string has;               ///< in the message too
};

void check(const std::vector<Bad>& all, const app::DrawingOptions& options = {})
{
    for (const Bad& bad : all) {
        const std::string why = refusal(bad.name, bad.text, options);
        INFO(why);
        CHECK(why.starts_with(bad.begin));
        CHECK(why.find(bad.has) != std::string::npos);
    }
}

} // namespace

TEST_CASE("bad drawing: outlines that are no blocks are refused with their place",
          "[app][bad_drawing]")
{
    check({{"w.json", json_text({rectangle(0, 0, 1, 1), {1, 0, 2, 0, 1.2, 1, 2, 1}}),
            "w.json:3: the outline of this block crosses itself at (1.5555556, 0.55555556)",
            "in order"},
           {"w.json", json_text({rectangle(0, 0, 1, 1), {1, 0, 2, 1}}),
            "w.json:3: ", "has no area"},
           {"w.json", json_text({rectangle(0, 0, 1, 1), {1, 0, 1, 1, 1, 0.5}}),
            "w.json:3: the block from (1, 1) to (1, 0)", "has no area"},
           {"w.json", json_text({rectangle(0, 0, 1, 1), rectangle(1, 0, 1.0004, 1)}),
            "w.json:3: ", "wall.snap"},
           {"w.json", json_text({rectangle(5, 5, 6, 6), rectangle(5.9, 5.5, 7, 7)}),
            "w.json:3: this block overlaps the block of line 2 at (",
            "by more than wall.snap (0.5 mm)"},
           {"w.json", json_text({rectangle(0, 0, 2, 1), rectangle(1, 0, 3, 1)}),
            "w.json:3: this block overlaps", "(1, 0)"},
           {"w.json", json_text({rectangle(0, 0, 2, 2), {2, 0, 2, 2, 1, 1}}),
            "w.json:3: this block overlaps", "line 2"},
           {"w.json", json_text({rectangle(0, 0, 2, 2), {2, 0, 1.5, 1, 1, 0.5}}),
            "w.json:3: this block overlaps the block of line 2 at (2, 0)", "side by side"},
           {"w.json", json_text({rectangle(0, 0, 1, 1), rectangle(0, 0, 1, 1)}),
            "w.json:3: this block is drawn twice", "(0, 0)"},
           {"w.json", json_text({rectangle(0, 0, 3, 3), rectangle(1, 1, 2, 2)}),
            "w.json:3: this block lies within the block of line 2, at (1, 1)", "delete one"},
           {"w.json", json_text({rectangle(1, 1, 2, 2), rectangle(0, 0, 3, 3)}),
            "w.json:2: this block lies within the block of line 3, at (1, 1)", "delete one"},
           {"w.json", json_text({rectangle(0, 0, 1, 1), rectangle(0, 1.01, 1, 2)}),
            "w.json:3: the block at (0, 1.01) stands neither",
            "1 such block); close the gap of 10 mm to the block of line 2, or make wall.snap"},
           {"w.json", json_text({rectangle(0, 0, 1, 1), rectangle(1.5, 0.003, 2, 1)}),
            "w.json:3: the block at (1.5, 0.003) stands neither",
            "close the gap of 3 mm to the floor"},
           {"w.json", json_text({rectangle(0, 0, 1, 1), rectangle(1, 1, 2, 2)}),
            "w.json:3: the block at (1, 1) stands neither",
            "it touches the block of line 2 in a point alone: let them share a side"},
           {"w.json", json_text({{0, 0, 1, 0, 1, 1, 0.0003, 0.5, 0, 1}, {0, 0.5, 0, 1, -1, 1}}),
            "w.json:", "of itself at"}});
}

TEST_CASE("bad drawing: sizes that speak of another unit name the one that fits",
          "[app][bad_drawing]")
{
    check({{"w.json", json_text({rectangle(0, 0, 1000, 1000)}),
            "w.json: the wall is 1000 x 1000 m, from (0, 0) to (1000, 1000)",
            "wall.length_unit = mm"},
           {"w.json", json_text({rectangle(0, 0, 240, 110)}),
            "w.json: ", "wall.length_unit = cm or in would fit"},
           {"w.json", json_text({rectangle(0, 0, 1e8, 10)}),
            "w.json: ", "draw it in its true size"}});
    check({{"w.json", json_text({rectangle(0, 0, 2, 3)}), "w.json: the wall is 0.002 x 0.003 m",
            "wall.length_unit = m or ft"}},
          {.unit = 1e-3});
}

TEST_CASE("bad drawing: what JSON cannot be is refused with its line", "[app][bad_drawing]")
{
    check(
        {{"w.json", "", "w.json: is empty", ""},
         {"w.json", "{\"blocks\": []}", "w.json: holds no blocks", "[[[x, y]"},
         {"w.json", "{\n\"blocks\": [[[0, 0], [1, 0],", "w.json:2: is not JSON",
          "unexpected end of input"},
         {"w.json", "{\"blocks\": [\n[[0, 0], [1], [1, 1]]]}",
          "w.json:2: a corner is not [x, y]", ""},
         {"w.json", "{\"blocks\": [\n[[0, 0], [1e999, 0], [1, 1]]]}", "w.json:2: is not JSON",
          "number overflow"},
         {"w.json", "{\"blocks\": [\n[[0, 0], [1e10, 0], [1, 1]]]}",
          "w.json:2: a coordinate is not a number between", ""},
         {"w.json", std::string(100'000, '['), "w.json:1: lists are nested", ""},
         {"w.json", R"({"vertex": {"0": {"x": 0}}, "face": {"0": [0, 1, 2]}})",
          "w.json:1: a face of a mesh names a vertex", ""},
         {"w.json",
          R"({"vertices": [[0,0,0],[1,0.5,0],[1,1,1],[0,1,0.5]], "faces": [[0,1,2],[0,2,3]]})",
          "w.json:1: a mesh is neither flat", "prism"}});
}

TEST_CASE(
    "bad drawing: what DXF can say and a wall cannot have is refused with line and coordinates",
    "[app][bad_drawing]")
{
    const std::string block = lwpolyline(rectangle(0, 0, 1, 1));
    check(
        {{"w.dxf", dxf_text(""), "w.dxf: holds no closed outline", "polyline"},
         {"w.dxf", dxf_text("0\nHATCH\n8\nstone\n"), "w.dxf: holds no closed outline", "HATCH"},
         {"w.dxf", dxf_text(lwpolyline({0, 0, 1, 0, 1, 1, 0, 1}, false)),
          "w.dxf:6: this outline is open: it begins at (0, 0)",
          "ends at (0, 1), 1000 mm apart"},
         {"w.dxf", dxf_text(block + "0\nARC\n8\n0\n10\n2\n20\n3\n40\n0\n50\n0\n51\n90\n"),
          "w.dxf:30: an arc has no radius", ""},
         {"w.dxf", dxf_text("0\nCIRCLE\n10\n2\n20\n3\n40\n1\n"),
          "w.dxf:6: at (2, 3) there is a circle", ""},
         {"w.dxf", dxf_text("0\nELLIPSE\n10\n2\n20\n3\n"),
          "w.dxf:6: at (2, 3) there is an ellipse", ""},
         {"w.dxf", dxf_text("0\nSPLINE\n10\n2\n20\n3\n"),
          "w.dxf:6: at (2, 3) there is a spline", ""},
         {"w.dxf", dxf_text(block + "0\nMPOLYGON\n10\n2\n20\n3\n"),
          "w.dxf:30: at (2, 3) there is a polygon with a hatch", "EXPLODE"},
         {"w.dxf", dxf_text("0\nINSERT\n2\ndoor\n10\n2\n20\n3\n"),
          "w.dxf:6: at (2, 3) the block \"door\" is inserted, which the file does not",
          "explode"},
         {"w.dxf", dxf_text("0\nPOLYLINE\n70\n4\n0\nSEQEND\n"),
          "w.dxf:6: a polyline is smoothed", ""},
         {"w.dxf", dxf_text(block + "210\n1\n220\n0\n230\n0\n"),
          "w.dxf:6: LWPOLYLINE is not drawn in the x-y plane", ""},
         {"w.dxf", dxf_text("0\nLINE\n10\n0\n20\n0\n30\n1\n11\n1\n21\n1\n31\n5\n"),
          "w.dxf:6: lines of the wall have different z", ""},
         {"w.dxf",
          dxf_text(dxf_line(0, 0, 1, 0) + dxf_line(1, 0, 1, 1) + dxf_line(1, 1, 0, 0) +
                   dxf_line(1, 1, 2, 2)),
          "w.dxf:42: this line ends at (2, 2)", "no other begins"},
         {"w.dxf", dxf_text(dxf_line(0, 0, 2.003, 0) + dxf_line(2, -0.003, 2, 1)),
          "w.dxf:18: this line crosses the one of line 6 at (2, ", "; end both there"},
         {"w.dxf",
          dxf_text(dxf_line(0, 0, 1, 0) + dxf_line(1, 0, 1, 1) + dxf_line(1, 1, 0, 0) +
                   dxf_line(1, 0, 3, 0) + dxf_line(3, 0, 4, 0) + dxf_line(4, 0, 4, 1) +
                   dxf_line(4, 1, 3, 0)),
          "w.dxf:42: the line from (1, 0) to (3, 0) is not a side", ""},
         {"w.dxf", dxf_text("0\nLWPOLYLINE\n10\nnan\n20\n0\n"),
          "w.dxf:8: \"nan\" is not a number", ""},
         {"w.dxf", dxf_text("x\nLWPOLYLINE\n"), "w.dxf:5: \"x\" is not a group code",
          "ASCII DXF"},
         {"w.dxf", "0\nSECTION\n2\nENTITIES\n" + block, "w.dxf:28: the file ends without EOF",
          "cut off"},
         {"w.dxf", "AutoCAD Binary DXF\r\n\x1a", "w.dxf: is a binary DXF", "ASCII"},
         {"w.dxf", "0\nSECTION\n2\nHEADER\n0\nENDSEC\n0\nEOF\n",
          "w.dxf:8: has no section ENTITIES", ""},
         {"w.obj", "v 0 0 0\n", "w.obj: is not a drawing that can be read", ".dxf"}});
}

TEST_CASE("bad drawing: more than can be a wall is refused at once", "[app][bad_drawing]")
{
    std::vector<scenes::Outline> many(20'001, rectangle(0, 0, 1, 1));
    check({{"w.json", json_text(many), "w.json:20002: has more than 20000 blocks", ""}});
    scenes::Outline dense; // corners at less than snap from each other
    for (int i = 0; i < 1000; ++i) dense.insert(dense.end(), {1e-4 * i, 1e-4 * i});
    check({{"w.json", json_text({rectangle(0, 0, 1, 0.5), dense}),
            "w.json: corners follow each other", "wall.snap"}});
}

TEST_CASE("bad drawing: other formats are refused with the format to save them in",
          "[app][bad_drawing]")
{
    check({{"w.jpg", "x", "w.jpg: is not a drawing", "by \"drystone stones\" first"},
           {"w.JPEG", "x", "w.JPEG: is not a drawing", "by \"drystone stones\" first"},
           {"w.dwg", "x", "w.dwg: is not a drawing that can be read; save it as ASCII DXF", ""},
           {"w.txt", "x", "w.txt: is not a drawing", "give a .dxf, .json, .svg or .png file"}});
}

TEST_CASE("bad drawing: a key that stands twice in one object of JSON loses nothing silently",
          "[app][bad_drawing]")
{
    check(
        {{"w.json",
          "{\"blocks\": [[[0, 0], [1, 0], [1, 1]]],\n\"blocks\": [[[1, 0], [2, 0], [2, 1]]]}",
          "w.json:2: \"blocks\" stands twice in the object that begins on line 1", "keep one"},
         {"w.json",
          "{\"blocks\": [\n{\"outline\": [[0, 0], [1, 0], [1, 1]],\n \"outline\": [[0, 0]]}]}",
          "w.json:3: \"outline\" stands twice in the object that begins on line 2", ""},
         {"w.json", "{\"a\": {\"x\": 1, \"x\": 2}, \"blocks\": [[[0, 0], [1, 0], [1, 1]]]}",
          "w.json:1: \"x\" stands twice", ""}});
    CHECK(refusal("w.json", "{\"blocks\": [{\"outline\": [[0, 0], [1, 0], [1, 1]]}, "
                            "{\"outline\": [[1, 0], [2, 0], [2, 1], [1, 1]]}]}") == "read");
}
