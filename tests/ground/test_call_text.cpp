#include "ground/call_text.hpp"

#include <catch2/catch.hpp>

#include <numbers>

TEST_CASE("call text: a name, and values with names and units", "[ground][call_text]")
{
    const ground::CallText call =
        ground::parse_call(" half_sine( peak 0.5 g,duration  0.3 s ) ");
    CHECK(call.name == "half_sine");
    REQUIRE(call.arguments.size() == 2);
    CHECK(call.arguments[0].name == "peak");
    CHECK(ground::quantity(call.arguments[0].value, ground::Dimension::acceleration) ==
          0.5 * 9.80665);
    CHECK(ground::quantity(call.arguments[1].value, ground::Dimension::time) == 0.3);
    CHECK(ground::parse_call("pga").arguments.empty());
    CHECK(ground::quantity("90 deg", ground::Dimension::angle) ==
          Approx(std::numbers::pi / 2.0));
}

TEST_CASE("call text: what is wrong is refused with what to write", "[ground][call_text]")
{
    using Catch::Matchers::Contains;
    CHECK_THROWS_WITH(ground::parse_call("sa(0.3 s"), Contains("no bracket at its end"));
    CHECK_THROWS_WITH(ground::parse_call("sine(peak)"), Contains("write a name and a value"));
    CHECK_THROWS_WITH(ground::quantity("0.5", ground::Dimension::acceleration),
                      Contains("write g or m/s2"));
    CHECK_THROWS_WITH(ground::quantity("nan s", ground::Dimension::time),
                      Contains("is no number"));
    CHECK_THROWS_WITH(ground::quantity("2 s", ground::Dimension::none),
                      Contains("write the number alone"));
}
