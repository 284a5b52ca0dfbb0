#include "app/study/answers/fragility_text.hpp"

#include <catch2/catch.hpp>

#include <cmath>

TEST_CASE(
    "fragility text: a bound of the median is the lower bound of a value that is not known",
    "[app][fragility_text]")
{
    const app::Number n = app::median_bound({0.95, true, 2.7259, true}, 2);
    CHECK(std::isnan(n.value));
    CHECK(n.lower == 2.7259);
    CHECK(app::cell_text(n) == "> 2.72");
    CHECK(app::cell_text(app::median_bound({0.95, true, 2.7259, false}, 2)) == ">= 2.72");
    CHECK(app::cell_text(app::median_bound({}, 2)).empty());
}

TEST_CASE("fragility text: names of files have no path in them and are not too long",
          "[app][fragility_text]")
{
    CHECK(app::file_name("0.75 MPa") == "0.75_MPa");
    CHECK(app::file_name("../x") == "_.._x");
    CHECK(app::file_name("gr\u00f6\u00dfe") == "gr__e");
    CHECK(app::file_name("").size() == 1);
    CHECK(app::file_name(std::string(400, 'x')).size() == 60);
}
