#include "tests/app/drawing/drawing_scenes.hpp"

#include <catch2/catch.hpp>

#include <string>

using scenes::area;
using scenes::drawing_of;
using scenes::refusal;

namespace {

const std::string kStone = "<rect width='2' height='1'/>";
const std::string kOther = "<rect y='1' width='2' height='1'";

/// A drawing in metres.
std::string page(const std::string& body, const std::string& root = "viewBox='0 0 2 2'")
{
    return "<svg xmlns='s' " + root + ">" + body + "</svg>";
}

app::Drawing wall(const std::string& body)
{
    return drawing_of("w.svg", page(body), {.unit = 1.0});
}

} // namespace

TEST_CASE(
    "svg page: a page of another shape than its viewBox shows the drawing as large as fits",
    "[app][svg_page]")
{
    const auto of = [](const std::string& root) {
        return drawing_of("w.svg", page("<rect width='1000' height='500'/>", root),
                          {.unit = 1e-3, .unit_given = false});
    };
    const std::string box = "viewBox='0 0 1000 500'";
    // width and height of the page in units of 1000 x 500, how it fits, size of a unit [mm]
    CHECK(area(of("width='2000mm' height='500mm' " + box)) == Approx(0.5));
    CHECK(area(of("width='1000mm' height='2000mm' " + box)) == Approx(0.5));
    CHECK(area(of("width='1000MM' height='2E3Mm' " + box)) == Approx(0.5)); // as CSS has it
    CHECK(area(of("width='2000mm' height='500mm' preserveAspectRatio='xMidYMid slice' " +
                  box)) == Approx(2.0));
    CHECK(area(of("height='1m' " + box)) == Approx(2.0));
    CHECK(area(of("width=' 200cm ' " + box)) == Approx(2.0));
    const std::string stretched =
        "width='2000mm' height='500mm' preserveAspectRatio='none' " + box;
    CHECK_THAT(refusal("w.svg", page("<rect width='1000' height='500'/>", stretched)),
               Catch::StartsWith("w.svg:1: preserveAspectRatio=\"none\" stretches"));
    CHECK(area(of("width='2000mm' height='1000mm' preserveAspectRatio='none' " + box)) ==
          Approx(2.0));
}

TEST_CASE("svg page: a style sheet hides by element, id and classes, wherever it stands",
          "[app][svg_page]")
{
    for (const char* sheet :
         {"#old{display:none}", "rect.old{display:none}", ".old.b{display:none}",
          "@import url('x.css'); .old{display:none}", "rect{display:inline} .old{display:none}",
          ".old{opacity:0}", "#old{visibility:hidden} rect.old.b{visibility:visible}",
          "*{stroke:red} .old{display:none} a:hover{opacity:0}"}) {
        INFO(sheet);
        const std::string style = "<style>" + std::string(sheet) + "</style>";
        const std::string old = kOther + " id='old' class='b\told'/>";
        for (const std::string& body : {style + kStone + old, kStone + old + style}) {
            CHECK(wall(body).blocks.size() == 1);
            CHECK(scenes::notes(wall(body), "1 hidden shape was ignored"));
        }
        CHECK(wall(style + kStone + kOther + "/>").blocks.size() == 2);
    }
    CHECK(wall("<style>rect{display:none} #a{display:inline}</style>"
               "<rect id='a' width='2' height='1'/>" +
               kOther + "/>")
              .blocks.size() == 1);
}

TEST_CASE("svg page: a rule that may hide or move shapes and is not read is refused",
          "[app][svg_page]")
{
    for (const char* selector : {"g rect", "g > rect", "rect:first-child", "rect[x]"}) {
        INFO(selector);
        const auto sheet = [&](const std::string& declared) {
            return page("<style>\n" + std::string(selector) + declared + "</style>" + kStone);
        };
        for (const char* declared : {"{display:none}", "{transform:scale(2)}", "{opacity:0}"})
            CHECK_THAT(refusal("w.svg", sheet(declared)),
                       Catch::StartsWith("w.svg:2: the style sheet hides or moves what \"" +
                                         std::string(selector) + "\" selects"));
        CHECK(drawing_of("w.svg", sheet("{fill:red}"), {.unit = 1.0}).blocks.size() == 1);
    }
}

TEST_CASE("svg page: shapes without fill and stroke are not seen, and are no stones",
          "[app][svg_page]")
{
    // as drawing programs lay a frame around each shape and around the page
    for (const char* paint :
         {"fill='none'", "class='f'", "style='fill:none;stroke:none'", "fill='transparent'"}) {
        INFO(paint);
        const std::string frame = "<rect width='2' height='1' " + std::string(paint) + "/>";
        const app::Drawing read =
            wall("<style>.f{fill:none}</style>" + frame + kStone + kOther + "/>");
        CHECK(read.blocks.size() == 2);
        CHECK(scenes::notes(read, "1 hidden shape was ignored"));
        CHECK(wall("<g fill='none' stroke='none'>" + frame +
                   "<path fill='#aaa' d='M0 0h2v1h-2z'/></g>")
                  .blocks.size() == 1);
    }
    for (const char* seen : {"fill='none' stroke='#000'", "stroke='none'",
                             "style='fill:none' class='s'", "fill='inherit'"})
        CHECK(wall("<style>.s{stroke:red}</style>" + kStone + kOther + " " + seen + "/>")
                  .blocks.size() == 2);
    CHECK(wall("<g fill='none' stroke='#000'>" + kStone + kOther + "/></g>").blocks.size() ==
          2);
    CHECK(wall("<g fill='none'><line x2='2'/><line x1='2' x2='2' y2='1'/>"
               "<line x1='2' y1='1' y2='1'/><line y1='1'/></g>")
              .blocks.size() == 1);
}

TEST_CASE("svg page: what is clipped or masked is told", "[app][svg_page]")
{
    for (const char* clip :
         {"clip-path='url(#c)'", "style='clip-path:url(#c)'", "mask='url(#c)'"}) {
        INFO(clip);
        CHECK(scenes::notes(wall("<g " + std::string(clip) + ">" + kStone + kOther + "/></g>"),
                            "2 shapes have a clip path or a mask"));
    }
    CHECK_FALSE(scenes::notes(wall(kStone + kOther + " clip-path='none'/>"), "clip path"));
}

TEST_CASE("svg page: transforms of the page and of CSS are applied or refused",
          "[app][svg_page]")
{
    CHECK(area(drawing_of("w.svg", page(kStone, "viewBox='0 0 2 2' transform='scale(3, 2)'"),
                          {.unit = 1.0})) == Approx(12.0));
    CHECK(area(wall("<style>rect{transform:scale(2)}</style>" + kStone)) == Approx(8.0));
    for (const char* moved :
         {"style='scale:2'", "style='translate:1px 0'", "style='rotate:90deg'",
          "transform='rotate(90)' transform-origin='1 1'"})
        CHECK_THAT(refusal("w.svg", page(kStone + kOther + " " + moved + "/>"), {.unit = 1.0}),
                   Catch::Contains("apply the transforms in the drawing program"));
}

TEST_CASE("svg page: a file without a unit of length says what it was read in",
          "[app][svg_page]")
{
    const auto of = [](const std::string& root, bool given) {
        return drawing_of("w.svg", page("<rect width='1000' height='500'/>", root),
                          {.unit = 1e-3, .unit_given = given});
    };
    for (const char* root :
         {"viewBox='0 0 9 9'", "width='100%' height='100%'", "width='1000mm' height='500mm'",
          "width='9px' viewBox='0 0 9 9'"}) {
        INFO(root);
        CHECK(scenes::notes(of(root, false),
                            "states no unit of length; one unit was read as 1 mm, and the wall "
                            "is 1 x 0.5 m. Set wall.length_unit if that is not its size."));
        CHECK_FALSE(scenes::notes(of(root, true), "no unit"));
    }
    CHECK_FALSE(scenes::notes(of("width='1m' viewBox='0 0 1000 500'", false), "no unit"));
}

TEST_CASE("svg page: a rectangle around all stones is the page or its frame, and no stone",
          "[app][svg_page]")
{
    const std::string stones = kStone + kOther + "/>";
    for (const std::string& body :
         {"<rect width='2' height='2' fill='#fff'/>" + stones,
          stones + "<rect x='-1' y='-1' width='4' height='4' fill='none' stroke='#000'/>",
          "<path d='M-1 -1H3V3H-1Z'/><path d='M-2 -2H4V4H-2Z'/>" + stones}) {
        INFO(body);
        const app::Drawing drawing = wall(body);
        CHECK(drawing.blocks.size() == 2);
        CHECK(area(drawing) == Approx(4.0));
        CHECK(scenes::notes(drawing, "The outline of line 1 goes around all stones"));
    }
    const std::string joints = "<path d='M0 1H2' stroke='#000'/><path d='M1 1V2'/>";
    CHECK(wall("<rect width='2' height='2'/>" + joints).blocks.size() == 3);
    CHECK(scenes::notes(wall("<rect width='100%' height='100%'/>" + stones), "1 page"));
    // two windows in a facade, one stone in another, and a frame that is none
    CHECK_THAT(refusal("w.svg",
                       page("<path d='M0 0H9V9H0Z'/><path d='M1 1H2V2H1Z'/><path "
                            "d='M4 1H5V2H4Z'/>"),
                       {.unit = 1.0}),
               Catch::Contains("lies within the block"));
    CHECK_THAT(refusal("w.svg",
                       page("<path d='M0 0H3V3H0Z'/>" + stones +
                            "<rect x='5' "
                            "width='1' height='1'/>"),
                       {.unit = 1.0}),
               Catch::Contains("overlaps"));
}

TEST_CASE("svg page: elements of SVG are known by their namespace, whatever its prefix",
          "[app][svg_page]")
{
    const std::string prefixed =
        "<s:svg xmlns:s='http://www.w3.org/2000/svg' viewBox='0 0 2 2'>"
        "<s:style>.no { display: none }</s:style><s:rect width='2' height='1'/>"
        "<s:rect class='no' y='1' width='2' height='1'/><p:rect/></s:svg>";
    CHECK(area(drawing_of("w.svg", prefixed, {.unit = 1.0})) == Approx(2.0));
}

TEST_CASE("svg page: of a switch the first element without a condition is drawn",
          "[app][svg_page]")
{
    const std::string german = "<g systemLanguage='de'>" + kStone + "</g>",
                      any = "<g>" + kOther + "/></g>", other = "<g>" + kStone + kStone + "</g>";
    CHECK(area(wall(kStone + "<switch>" + german + any + other + "</switch>")) == Approx(4.0));
    CHECK(area(wall(kStone + "<switch>" + german + "</switch>")) == Approx(2.0));
}

TEST_CASE("svg page: shapes that a style makes, or that have no size, are refused",
          "[app][svg_page]")
{
    const auto refused = [](const std::string& body) {
        return refusal("w.svg", page(kStone + body), {.unit = 1.0});
    };
    CHECK_THAT(refused("<rect y='1' width='-2' height='1'/>"),
               Catch::Contains("the rectangle at (0, 1) has a negative width or height"));
    CHECK_THAT(refused(kOther + " style='width: 3px'/>"),
               Catch::Contains("the style has \"width\", which is not read; write it as an "
                               "attribute of the rect"));
    CHECK_THAT(refused("<style>path { d: path('M0,0') }</style><path d='M0,0 1,0 1,1z'/>"),
               Catch::Contains("the style has \"d\""));
    CHECK_THAT(refused("<symbol id='a' refX='1'>" + kStone + "</symbol><use href='#a'/>"),
               Catch::Contains("a symbol that has a refX"));
}
