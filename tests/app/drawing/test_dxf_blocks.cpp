#include "tests/app/drawing/drawing_scenes.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <string>
#include <vector>

using scenes::area;
using scenes::drawing_of;
using scenes::dxf_line;
using scenes::lwpolyline;
using scenes::rectangle;
using scenes::refusal;

namespace {

/// The definition of a block.
std::string block(const std::string& name, const std::string& entities,
                  const std::string& base = "10\n0\n20\n0\n", int flags = 0)
{
    return "0\nBLOCK\n8\n0\n2\n" + name + "\n70\n" + std::to_string(flags) + "\n" + base +
           entities + "0\nENDBLK\n8\n0\n";
}

/// The insertion of a block at a place, with more groups behind.
std::string insert(const std::string& name, const std::string& x, const std::string& y,
                   const std::string& more = "", const std::string& layer = "0")
{
    return "0\nINSERT\n8\n" + layer + "\n2\n" + name + "\n10\n" + x + "\n20\n" + y + "\n" +
           more;
}

std::string file(const std::string& blocks, const std::string& entities)
{
    return "0\nSECTION\n2\nBLOCKS\n" + blocks + "0\nENDSEC\n" + scenes::dxf_text(entities);
}

app::Drawing wall_of(const std::string& blocks, const std::string& entities)
{
    return drawing_of("w.dxf", file(blocks, entities), {.unit = 1.0});
}

/// Corners of all blocks, in order of x, then z, each block once.
std::vector<std::vector<std::pair<double, double>>> corners(const app::Drawing& wall)
{
    std::vector<std::vector<std::pair<double, double>>> all;
    for (const app::DrawnBlock& b : wall.blocks) {
        all.emplace_back();
        for (const dem::Point& p : b.outline) all.back().emplace_back(p.x, p.z);
        std::ranges::sort(all.back());
    }
    std::ranges::sort(all);
    return all;
}

/// A stone that is the same in no other orientation: 2 long, 1 high, its upper right corner
/// cut.
const std::string kStone = lwpolyline({0, 0, 2, 0, 2, 0.5, 1.5, 1, 0, 1});

/// A stone from z = 18 to the lowest side of an outline, so that it floats in no air.
std::string strut_below(const scenes::Outline& outline)
{
    double left = 1e9, right = -1e9, low = 1e9;
    for (std::size_t k = 0; k < outline.size(); k += 2) low = std::min(low, outline[k + 1]);
    for (std::size_t k = 0; k < outline.size(); k += 2) {
        if (outline[k + 1] > low) continue;
        left = std::min(left, outline[k]);
        right = std::max(right, outline[k]);
    }
    return low > 18 ? lwpolyline(rectangle(left, 18, right, low)) : "";
}

} // namespace

TEST_CASE("dxf blocks: an insertion draws its block at its place, from the base point",
          "[app][dxf_blocks]")
{
    const std::string blocks =
        block("Stone", lwpolyline(rectangle(5, 7, 7, 8)), "10\n5\n20\n7\n30\n0\n");
    const app::Drawing wall =
        wall_of(blocks, insert("Stone", "0", "0") + insert("STONE", "2", "0") +
                            insert("stone", "1", "1"));
    const app::Drawing plain = drawing_of("w.dxf",
                                          scenes::dxf_text(lwpolyline(rectangle(0, 0, 2, 1)) +
                                                           lwpolyline(rectangle(2, 0, 4, 1)) +
                                                           lwpolyline(rectangle(1, 1, 3, 2))),
                                          {.unit = 1.0});
    CHECK(corners(wall) == corners(plain));
    CHECK(scenes::notes(wall, "3 insertions of blocks were expanded: 3 Stone."));
    // a block that nothing inserts is not in the drawing
    CHECK(wall_of(blocks, lwpolyline(rectangle(0, 0, 2, 1))).blocks.size() == 1);
}

TEST_CASE("dxf blocks: scales, mirrors, turns and views from behind place each corner",
          "[app][dxf_blocks]")
{
    struct Case {
        std::string more;
        scenes::Outline drawn; ///< by hand
    };
    // the base point (1, 0) of the stone comes to (10, 20)
    for (const Case& c : {
             Case{"", {9, 20, 11, 20, 11, 20.5, 10.5, 21, 9, 21}},
             Case{"41\n2\n42\n0.5\n", {8, 20, 12, 20, 12, 20.25, 11, 20.5, 8, 20.5}},
             Case{"41\n-1\n42\n1\n", {11, 20, 9, 20, 9, 20.5, 9.5, 21, 11, 21}},
             Case{"42\n-1\n", {9, 20, 11, 20, 11, 19.5, 10.5, 19, 9, 19}},
             Case{"50\n90\n", {10, 19, 10, 21, 9.5, 21, 9, 20.5, 9, 19}},
             Case{"50\n-90\n", {10, 21, 10, 19, 10.5, 19, 11, 19.5, 11, 21}},
             Case{"41\n2\n50\n450\n", {10, 18, 10, 22, 9.5, 22, 9, 21, 9, 18}},
             Case{"50\n90\n210\n0\n220\n0\n230\n-1\n",
                  {-10, 19, -10, 21, -9.5, 21, -9, 20.5, -9, 19}},
         }) {
        INFO(c.more);
        // a floor that shows where the stone stands
        const std::string floor = lwpolyline(rectangle(-20, 15, 20, 18));
        const std::string pillar = lwpolyline(rectangle(-20, 18, -15, 23));
        const auto stones = [&](const std::string& stone) {
            return "0\nSECTION\n2\nBLOCKS\n" + block("S", kStone, "10\n1\n20\n0\n") +
                   "0\nENDSEC\n" + scenes::dxf_text(floor + pillar + stone);
        };
        const std::string strut = strut_below(c.drawn);
        const app::Drawing inserted =
            drawing_of("w.dxf", stones(strut + insert("S", "10", "20", c.more)), {.unit = 1.0});
        const app::Drawing drawn =
            drawing_of("w.dxf", stones(strut + lwpolyline(c.drawn)), {.unit = 1.0});
        CHECK(corners(inserted) == corners(drawn));
    }
}

TEST_CASE("dxf blocks: insertions within insertions turn and move one after the other",
          "[app][dxf_blocks]")
{
    const std::string blocks =
        block("A", lwpolyline({0, 0, 4, 0, 4, 3})) +
        block("B", insert("A", "7", "1", "50\n-36.86989764584402\n"), "10\n7\n20\n1\n");
    const app::Drawing wall =
        wall_of(blocks, insert("B", "0", "0", "50\n36.86989764584402\n41\n2\n42\n2\n"));
    REQUIRE(wall.blocks.size() == 1);
    const auto found = corners(wall)[0];
    const std::vector<std::pair<double, double>> drawn = {{0, 0}, {8, 0}, {8, 6}};
    REQUIRE(found.size() == 3);
    for (std::size_t i = 0; i < 3; ++i) {
        CHECK(found[i].first == Approx(drawn[i].first).margin(1e-12));
        CHECK(found[i].second == Approx(drawn[i].second).margin(1e-12));
    }
}

TEST_CASE("dxf blocks: rows and columns lie along the turned axes, unscaled",
          "[app][dxf_blocks]")
{
    const std::string blocks = block("S", lwpolyline(rectangle(0, 0, 1, 1)));
    const app::Drawing wall =
        wall_of(blocks, insert("S", "0", "0", "41\n2\n70\n3\n71\n2\n44\n2\n45\n1\n"));
    CHECK(wall.blocks.size() == 6);
    CHECK(area(wall) == 12.0);
    CHECK(scenes::common_sides(wall) == 7);
    // columns upwards, rows to the left
    const app::Drawing turned =
        wall_of(blocks, insert("S", "0", "0", "50\n90\n41\n2\n70\n3\n71\n2\n44\n2\n45\n1\n"));
    CHECK(turned.blocks.size() == 6);
    double top = 0.0, right = 0.0;
    for (const app::DrawnBlock& b : turned.blocks)
        for (const dem::Point& p : b.outline) {
            top = std::max(top, p.z);
            right = std::max(right, p.x);
        }
    CHECK(top == 6.0);
    CHECK(right == 2.0);
}

TEST_CASE("dxf blocks: layer 0 within a block is the layer of the insertion, at any depth",
          "[app][dxf_blocks]")
{
    const std::string blocks =
        block("one", lwpolyline(rectangle(0, 0, 1, 1)) +
                         lwpolyline(rectangle(1, 0, 2, 1), true, "brick")) +
        block("two", insert("one", "0", "0") + insert("one", "2", "0", "", "lime"));
    const app::Drawing wall = wall_of(blocks, insert("two", "0", "0", "", "granite"));
    REQUIRE(wall.blocks.size() == 4);
    CHECK(wall.blocks[0].layer == "granite");
    CHECK(wall.blocks[1].layer == "brick");
    CHECK(wall.blocks[2].layer == "lime");
    CHECK(wall.blocks[3].layer == "brick");
}

TEST_CASE("dxf blocks: lines, old polylines and texts within a block are read as outside of it",
          "[app][dxf_blocks]")
{
    const std::string old = "0\nPOLYLINE\n8\n0\n66\n1\n70\n1\n0\nVERTEX\n10\n0\n20\n0\n0\n"
                            "VERTEX\n10\n1\n20\n0\n0\nVERTEX\n10\n0\n20\n1\n0\nSEQEND\n";
    const std::string lines =
        dxf_line(0, 0, 0, 1, "brick") + dxf_line(0, 1, -1, 0) + dxf_line(-1, 0, 0, 0, "brick");
    const std::string texts = "0\nATTDEF\n2\nNO\n0\nTEXT\n1\na\n";
    const app::Drawing wall =
        wall_of(block("S", old + lines + texts),
                insert("S", "1", "0", "66\n1\n") + "0\nATTRIB\n1\n7\n0\nSEQEND\n");
    REQUIRE(wall.blocks.size() == 2);
    CHECK(area(wall) == 1.0);
    CHECK(scenes::notes(wall, "1 ATTDEF, 1 ATTRIB, 1 TEXT"));
}

TEST_CASE("dxf blocks: what is hidden follows the layers of the insertion", "[app][dxf_blocks]")
{
    const std::string blocks = block("S", lwpolyline(rectangle(0, 0, 1, 1)) +
                                              lwpolyline(rectangle(1, 0, 2, 1), true, "brick"));
    const auto shown = [&](int flags, int colour, const std::string& more) {
        const std::string tables = "0\nSECTION\n2\nTABLES\n0\nLAYER\n2\nold\n70\n" +
                                   std::to_string(flags) + "\n62\n" + std::to_string(colour) +
                                   "\n0\nENDSEC\n";
        return drawing_of("w.dxf",
                          tables + file(blocks, lwpolyline(rectangle(2, 0, 3, 1)) +
                                                    insert("S", "0", "0", more, "old")),
                          {.unit = 1.0})
            .blocks.size();
    };
    CHECK(shown(0, 7, "") == 3);
    CHECK(shown(0, -7, "") == 2); // off: what the block has on other layers is seen
    CHECK(shown(1, 7, "") == 1);  // frozen
    CHECK(shown(0, 7, "60\n1\n") == 1);
    CHECK(shown(0, 7, "67\n1\n") == 1); // of the paper space
}

TEST_CASE("dxf blocks: a clip boundary is told", "[app][dxf_blocks]")
{
    std::string text =
        file(block("S", lwpolyline(rectangle(0, 0, 1, 1))), insert("S", "0", "0"));
    text.insert(text.size() - 6,
                "0\nSECTION\n2\nOBJECTS\n0\nSPATIAL_FILTER\n5\n1F\n0\nENDSEC\n");
    CHECK(
        scenes::notes(drawing_of("w.dxf", text, {.unit = 1.0}),
                      "1 insertion of a block has a clip boundary (XCLIP), which is not read"));
}

TEST_CASE("dxf blocks: what cannot be expanded is refused with its line, block and remedy",
          "[app][dxf_blocks]")
{
    const auto why = [](const std::string& blocks, const std::string& entities) {
        return refusal("w.dxf", file(blocks, entities), {.unit = 1.0});
    };
    CHECK_THAT(
        why("", insert("door", "2", "3")),
        Catch::StartsWith("w.dxf:12: at (2, 3) the block \"door\" is inserted, which the "
                          "file does not define; ") &&
            Catch::Contains("explode"));
    CHECK_THAT(why(block("x", "", "", 4), insert("x", "2", "3")),
               Catch::Contains("the block \"x\" is inserted, which is in another file") &&
                   Catch::Contains("XREF, Bind"));
    CHECK_THAT(why(block("a", insert("B", "1", "1")) + block("b", insert("A", "0", "4")),
                   insert("a", "2", "3")),
               Catch::Contains("at (3, 8) the block \"A\" is inserted within itself") &&
                   Catch::Contains("(in the block \"b\", which line 64 inserts)"));
    CHECK_THAT(why(block("x", kStone), insert("x", "2", "3", "41\n0\n")),
               Catch::Contains("the block \"x\" is inserted with a scale of 0"));
    CHECK_THAT(why(block("x", kStone), insert("x", "2", "3", "230\n0\n210\n1\n")),
               Catch::Contains("INSERT is not drawn in the x-y plane"));
    CHECK_THAT(why("0\nBLOCK\n2\nx\n" + kStone, insert("x", "2", "3")),
               Catch::StartsWith("w.dxf:6: the block \"x\" has no end"));
    // what its block draws is refused where it is drawn, with its place in the drawing
    CHECK_THAT(why(block("x", "0\nCIRCLE\n10\n2\n20\n3\n40\n1\n"), insert("x", "10", "20")),
               Catch::StartsWith("w.dxf:18: at (12, 23) there is a circle") &&
                   Catch::EndsWith(" (in the block \"x\", which line 36 inserts)"));
    // what does not fit together is named by the insertion
    CHECK_THAT(why(block("x", kStone), insert("x", "0", "0") + insert("x", "0", "0")),
               Catch::StartsWith("w.dxf:66: this block is drawn twice: the block of line 56"));
}

TEST_CASE("dxf blocks: a file that would draw without end is refused at once",
          "[app][dxf_blocks]")
{
    const auto why = [](const std::string& blocks, const std::string& entities) {
        return refusal("w.dxf", file(blocks, entities), {.unit = 1.0});
    };
    // each block inserts the one before ten times: 10^30 texts
    std::string blocks = block("b0", "0\nTEXT\n1\na\n");
    for (int i = 1; i <= 30; ++i) {
        std::string ten;
        for (int k = 0; k < 10; ++k) ten += insert("b" + std::to_string(i - 1), "0", "0");
        blocks += block("b" + std::to_string(i), ten);
    }
    CHECK_THAT(why(blocks, insert("b30", "0", "0")),
               Catch::Contains("draw more than a wall can have"));
    // a chain of blocks
    blocks = block("b0", kStone);
    for (int i = 1; i <= 100; ++i)
        blocks += block("b" + std::to_string(i), insert("b" + std::to_string(i - 1), "0", "0"));
    CHECK_THAT(why(blocks, insert("b100", "0", "0")),
               Catch::Contains("more than 64 insertions deep"));
    CHECK(why(blocks, insert("b60", "0", "0")) == "read");
    // a grid of nothing
    CHECK_THAT(why(block("e", ""), insert("e", "0", "0", "70\n999999999\n71\n999999999\n")),
               Catch::Contains("draw more than a wall can have"));
    CHECK_THAT(why(block("s", kStone), insert("s", "0", "0", "70\n999999999\n44\n2\n")),
               Catch::Contains("has more than 20000 blocks"));
}

TEST_CASE("dxf blocks: a border with joints drawn as polylines is inserted whole",
          "[app][dxf_blocks]")
{
    const app::Drawing wall =
        wall_of(block("x", lwpolyline({0, 1, 4, 1}, false) + lwpolyline({2, 0, 2, 1}, false) +
                               lwpolyline(rectangle(0, 0, 4, 2))),
                insert("x", "10", "20"));
    CHECK(wall.blocks.size() == 3);
    CHECK(area(wall) == 8.0);
}
