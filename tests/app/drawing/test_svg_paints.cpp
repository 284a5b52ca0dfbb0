#include "tests/app/drawing/drawing_scenes.hpp"

#include <catch2/catch.hpp>

#include <string>

using scenes::area;
using scenes::drawing_of;
using scenes::refusal;

namespace {

std::string page(const std::string& body)
{
    return "<svg xmlns='s' viewBox='0 0 4 4'>\n" + body + "</svg>";
}

app::Drawing wall(const std::string& body)
{
    return drawing_of("w.svg", page(body), {.unit = 1.0});
}

const std::string kFill = " fill='#aaa' stroke='none'/>\n",
                  kStroke = " fill='none' stroke='#000'/>\n",
                  kBoth = " fill='#aaa' stroke='#000'/>\n";
const std::string kPath = "<path d='M0 0H2V1H0Z'";

} // namespace

TEST_CASE("svg paints: a stone whose fill and stroke are two paths is one stone",
          "[app][svg_paints]")
{
    for (const char* same :
         {"<path d='M0 0H2V1H0Z'", "<path d='M2 1V0H0V1Z'", "<path d='M2 0V1H0V0Z'",
          "<polygon points='0,1 0,0 2,0 2,1'", "<rect width='2' height='1'",
          "<path d='M1 1H0V0H1H2V1H1Z'", "<path transform='scale(2)' d='M0 0.0001H1V0.5H0Z'"}) {
        INFO(same);
        for (const std::string& body :
             {kPath + kFill + same + kStroke, kPath + kStroke + same + kFill}) {
            const app::Drawing read = wall(body);
            REQUIRE(read.blocks.size() == 1);
            CHECK(area(read) == Approx(2.0).epsilon(2e-4));
            CHECK(scenes::notes(read, "1 stone has its fill and its stroke as two outlines"));
        }
    }
    // all fills first, then all strokes, of two stones
    const std::string other = "<path d='M0 1H2V2H0Z'";
    const app::Drawing two =
        wall(kPath + kFill + other + kFill + kPath + kStroke + other + kStroke);
    CHECK(two.blocks.size() == 2);
    CHECK(scenes::notes(two, "2 stones have their fill and their stroke"));
}

TEST_CASE("svg paints: the layer is that of the fill, and a stroke on another one is told",
          "[app][svg_paints]")
{
    const std::string fills = "<g id='lime'>" + kPath + kFill + "</g>",
                      strokes = "<g id='pen'>" + kPath + kStroke + "</g>";
    for (const std::string& body : {fills + strokes, strokes + fills}) {
        const app::Drawing read = wall(body);
        REQUIRE(read.blocks.size() == 1);
        CHECK(read.blocks[0].layer == "lime");
        CHECK(scenes::notes(read, "1 stroke is on another layer than the fill"));
    }
}

TEST_CASE("svg paints: a fill that is clear, a stroke that is clear or has no width are none",
          "[app][svg_paints]")
{
    const std::string beside = "<rect x='2' width='2' height='1' ";
    for (const char* clear :
         {"style='fill:#aaa;fill-opacity:0;stroke:none'",
          "fill='none' stroke='#000' stroke-width='0'", "fill-opacity='0.0'",
          "fill='none' stroke='#000' style='stroke-width:0px'",
          "fill='none' stroke='red' stroke-opacity='0'", "fill='#0000'", "fill='#12345600'",
          "fill='rgba(0,0,0,0)'", "fill='rgb(0 0 0 / 0)'", "fill='rgb(9 9 9 / 0%)'",
          "fill='hsla(0, 0%, 0%, 0.0)'", "fill='None' stroke='RGBA(1,2,3,0)'",
          "opacity='0%'"}) {
        INFO(clear);
        const app::Drawing read = wall(kPath + kBoth + beside + clear + "/>");
        CHECK(read.blocks.size() == 1);
        CHECK(scenes::notes(read, "1 hidden shape was ignored"));
    }
    for (const char* seen :
         {"fill-opacity='0.1'", "fill-opacity='0' stroke='#000'", "stroke-width='0'",
          "fill='none' stroke='#000' stroke-width='0.5mm'", "fill-opacity='50%'",
          "fill='#0001'", "fill='#000000'", "fill='#123456f0'", "fill='rgba(0,0,0,0.1)'",
          "fill='rgb(0 0 0 / 5%)'", "fill='rgb(0,0,0)'", "fill='url(#a)'", "opacity='5%'"}) {
        INFO(seen);
        CHECK(wall(kPath + kBoth + beside + seen + "/>").blocks.size() == 2);
    }
    CHECK(wall(kPath + kBoth + "<g fill-opacity='0'>" + beside + "/></g>").blocks.size() == 1);
    CHECK(wall(kPath + kBoth + "<g fill-opacity='0'>" + beside + "fill-opacity='1'/></g>")
              .blocks.size() == 2);
}

TEST_CASE("svg paints: an important declaration is stronger than any usual one",
          "[app][svg_paints]")
{
    const auto stones = [&](const std::string& sheet, const std::string& attributes) {
        return wall("<style>" + sheet + "</style>" + kPath + kBoth +
                    "<rect x='2' width='2' height='1' " + attributes + "/>")
            .blocks.size();
    };
    const std::string hidden = ".old{display:none !important}";
    CHECK(stones(hidden, "class='old' style='display:inline'") == 1);
    CHECK(stones(hidden + "#a{display:inline}", "class='old' id='a'") == 1);
    CHECK(stones(hidden + "#a{display:inline!important}", "class='old' id='a'") == 2);
    CHECK(stones(hidden, "class='old' style='display:inline ! important'") == 2);
    CHECK(stones("rect{display:none}", "style='display:inline'") == 2);
    CHECK_THAT(refusal("w.svg",
                       page("<style>g > rect{display:none!important}</style>" + kPath + kBoth),
                       {.unit = 1.0}),
               Catch::Contains("g > rect"));
}

TEST_CASE("svg paints: any other stone that is drawn twice is refused", "[app][svg_paints]")
{
    for (const std::string& body :
         {kPath + kFill + kPath + kFill, kPath + kStroke + kPath + kStroke,
          kPath + kBoth + kPath + kStroke, kPath + kFill + kPath + kBoth,
          kPath + kFill + kPath + kStroke + kPath + kStroke,
          kPath + kFill + kPath + kStroke + kPath + kFill})
        CHECK_THAT(refusal("w.svg", page(body), {.unit = 1.0}),
                   Catch::Contains("this block is drawn twice"));
    // a stroke that only overlaps
    CHECK_THAT(refusal("w.svg", page(kPath + kFill + "<path d='M0 0H2V0.99H0Z'" + kStroke),
                       {.unit = 1.0}),
               Catch::Contains("overlaps"));
}
