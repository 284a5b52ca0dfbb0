#include "app/output/picture/svg_elements.hpp"

#include "tests/scenes/xml_tree.hpp"

#include <catch2/catch.hpp>

#include <limits>
#include <stdexcept>

TEST_CASE("svg elements: any text survives being written and read", "[app][svg_elements]")
{
    const std::string text = "a < b && \"c\" > 'd' λ, 20 %";
    const scenes::Xml page = scenes::parse_xml(app::svg_page(
        100, 50, text, app::svg_text({1, 2}, text, app::svg_attribute("fill", "#333"))));
    CHECK(scenes::texts(page) == std::vector<std::string>{text});
    CHECK(scenes::elements(page, "title").at(0).data() == text);
}

TEST_CASE("svg elements: characters that XML forbids become spaces", "[app][svg_elements]")
{
    CHECK(app::xml_escape(std::string("a\x01\n\x7F") + "b") == "a   b");
}

TEST_CASE("svg elements: a coordinate that is not finite is refused", "[app][svg_elements]")
{
    const double nan = std::numeric_limits<double>::quiet_NaN();
    CHECK_THROWS_AS(app::svg_line({0, 0}, {nan, 0}, ""), std::invalid_argument);
    CHECK_THROWS_AS(app::svg_number(std::numeric_limits<double>::infinity()),
                    std::invalid_argument);
}

TEST_CASE("svg elements: coordinates have at most two decimals", "[app][svg_elements]")
{
    CHECK(app::svg_number(12.0) == "12");
    CHECK(app::svg_number(100.0) == "100");
    CHECK(app::svg_number(1.236) == "1.24");
    CHECK(app::svg_number(-0.001) == "0");
}

TEST_CASE("svg elements: a group or line of nothing is nothing", "[app][svg_elements]")
{
    CHECK(app::svg_group("fill=\"red\"", "").empty());
    CHECK(app::svg_polyline({}, "").empty());
}

TEST_CASE("svg elements: a window keeps the coordinates of the page", "[app][svg_elements]")
{
    const scenes::Xml window = scenes::parse_xml(app::svg_window({10, 20}, 30, 40, "<g/>"));
    const scenes::Xml svg = scenes::elements(window, "svg").at(0);
    CHECK(scenes::attribute(svg, "viewBox") == "10 20 30 40");
    CHECK(scenes::number_of(svg, "x") == 10);
    CHECK(scenes::number_of(svg, "y") == 20);
    CHECK(scenes::number_of(svg, "width") == 30);
    CHECK(scenes::number_of(svg, "height") == 40);
}

TEST_CASE("svg elements: no title and no text leave no empty elements", "[app][svg_elements]")
{
    const std::string page = app::svg_page(100, 50, "", app::svg_text({1, 2}, "", ""));
    CHECK(page.find("<title") == std::string::npos);
    CHECK(page.find("<text") == std::string::npos);
}
