#include "tests/app/drawing/drawing_scenes.hpp"

#include <catch2/catch.hpp>

#include <string>

using scenes::area;
using scenes::drawing_of;

namespace {

/// A box of COMPAS from (x, 0, z) to (x + 1, 0.2, z + 1), with outward faces.
std::string compas_box(double x, double z)
{
    std::string vertices, text;
    int n = 0;
    for (const double at_z : {z, z + 1.0})
        for (const auto& [at_x, y] : {std::pair{x, 0.0}, std::pair{x + 1.0, 0.0},
                                      std::pair{x + 1.0, 0.2}, std::pair{x, 0.2}})
            vertices += (n == 0 ? "\"" : ", \"") + std::to_string(n) +
                        "\": {\"x\": " + std::to_string(at_x) +
                        ", \"y\": " + std::to_string(y) + ", \"z\": " + std::to_string(at_z) +
                        "}",
                ++n;
    return R"({"dtype": "compas.datastructures/Mesh", "data": {"attributes": {}, "vertex": {)" +
           vertices +
           R"(}, "face": {"0": [0, 3, 2, 1], "1": [4, 5, 6, 7], "2": [0, 1, 5, 4], "3": [1, 2, 6, 5],
               "4": [2, 3, 7, 6], "5": [3, 0, 4, 7]}}, "guid": "0"})";
}

} // namespace

TEST_CASE("json drawing: plain outlines and objects with layers are blocks",
          "[app][json_drawing]")
{
    const app::Drawing plain =
        drawing_of("w.json", scenes::json_text({scenes::rectangle(1, 2, 2, 3)}));
    REQUIRE(plain.blocks.size() == 1);
    CHECK(area(plain) == 1.0);
    CHECK(plain.blocks[0].outline[0].x == 0.0); // moved to the origin
    CHECK(plain.blocks[0].outline[0].z == 0.0);
    CHECK(plain.notes.empty());

    const app::Drawing named = drawing_of("w.JSON", R"({"blocks": [
        {"layer": "stone", "outline": [[0, 0], [0, 1000], [1000, 1000], [1000, 0], [0, 0]]},
        {"layer": "brick", "outline": [[1000, 0], [2000, 0], [2000, 1000], [1000, 1000]]}]})",
                                          {.unit = 1e-3});
    REQUIRE(named.blocks.size() == 2);
    CHECK(named.blocks[0].outline.size() == 4); // the first corner was repeated
    CHECK(area(named.blocks[0]) == 1.0);        // drawn clockwise
    CHECK(named.blocks[0].layer == "stone");
    CHECK(named.blocks[1].layer == "brick");
    CHECK(scenes::common_sides(named) == 1);
}

TEST_CASE("json drawing: meshes of COMPAS, flat or boxes, in lists and within assemblies",
          "[app][json_drawing]")
{
    const app::Drawing boxes =
        drawing_of("w.json", "[" + compas_box(0, 0) + ",\n" + compas_box(1, 0) + "]");
    CHECK(boxes.blocks.size() == 2);
    CHECK(area(boxes) == Approx(2.0).epsilon(1e-12));
    CHECK(scenes::notes(boxes, "prisms along y"));

    std::string triangles = compas_box(0, 0);
    triangles.replace(triangles.find("[0, 1, 5, 4]"), 12, "[0, 1, 5], \"6\": [0, 5, 4]");
    CHECK(area(drawing_of("w.json", triangles)) == Approx(1.0).epsilon(1e-12));
    CHECK(drawing_of("w.json", triangles).blocks.size() == 1);

    const app::Drawing assembly = drawing_of(
        "w.json",
        R"({"dtype": "compas_assembly.datastructures/Assembly", "data": {"graph": {"data": {"node": {"0": {"block": )" +
            compas_box(0, 0) + R"(}, "1": {"block": )" + compas_box(0, 1) + "}}}}}}");
    CHECK(assembly.blocks.size() == 2);
    CHECK(scenes::common_sides(assembly) == 1);

    const app::Drawing flat = drawing_of(
        "w.json",
        R"({"vertices": [[0, 0, 0], [1, 0, 0], [2, 0, 0], [2, 0, 1], [1, 0, 1], [0, 0, 1]],
        "faces": [[0, 1, 4, 5], [1, 2, 3, 4]]})");
    CHECK(flat.blocks.size() == 2);
    CHECK(area(flat) == 2.0);
    CHECK(scenes::notes(flat, "x-z plane; each of their faces"));

    const app::Drawing plane = drawing_of(
        "w.json",
        R"({"data": {"vertex": {"a": {"x": 0, "y": 0}, "b": {"x": 2}, "c": {"x": 2, "y": 1},
        "d": {"x": 0, "y": 1}}, "face": {"7": ["a", "b", "c", "d"]}}})");
    CHECK(area(plane) == 2.0);

    const app::Drawing polygon = drawing_of("w.json", R"([{"dtype": "compas.geometry/Polygon",
        "data": {"points": [[0, 0, 0], [1, 0, 0], [1, 0, 1], [0, 0, 1]]}}])");
    CHECK(area(polygon) == 1.0);
}

TEST_CASE("json drawing: nothing in \"blocks\" is passed over in silence",
          "[app][json_drawing]")
{
    const std::string good = R"({"outline": [[0, 0], [2, 0], [2, 1], [0, 1]], "layer": "a"})";
    const auto why = [&](const std::string& more) {
        return scenes::refusal("w.json", "{\"blocks\": [" + good + ",\n" + more + "]}",
                               {.unit = 1.0});
    };
    CHECK_THAT(
        why(R"({"outlin": [[0, 1], [2, 1], [2, 2], [0, 2]], "layer": "b"})"),
        Catch::StartsWith(
            "w.json:2: an object of \"blocks\" has no \"outline\" (it has: layer, outlin)"));
    CHECK_THAT(why("null"), Catch::Contains("neither a list of corners nor an object"));
    CHECK_THAT(why("[[0, 0, 1], [2, 0, 1], [2, 0, 2], [0, 0, 2]]"),
               Catch::StartsWith("w.json:2: a corner is not [x, y], two numbers"));
    CHECK_THAT(why(R"({"outline": [[0, 1], [2, 1], [2, 2], [0, 2]], "layer": 3})"),
               Catch::Contains("\"layer\" is not text"));
    const app::Drawing wall = drawing_of(
        "w.json",
        R"({"unit": "m", "blocks": [{"outline": [[0, 0], [2, 0], [2, 1], [0, 1]], "holes": []},
            {"Layer": "b", "outline": [[0, 1], [2, 1], [2, 2], [0, 2]], "holes": []}]})",
        {.unit = 1.0});
    CHECK(wall.blocks.size() == 2);
    CHECK(
        scenes::notes(wall, "Keys that are not read were ignored: 1 Layer, 2 holes, 1 unit."));
    CHECK(drawing_of("w.json", "{\"blocks\": [" + good + "]}", {.unit = 1.0}).notes.empty());
}
