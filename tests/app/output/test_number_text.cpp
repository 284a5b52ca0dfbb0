#include "app/text/number_text.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <cstdlib>
#include <limits>

using app::fixed;
using app::number;

TEST_CASE("number text: rounded is the nearest value of that many digits, however small",
          "[app][number_text]")
{
    CHECK(app::rounded(0.4 * 1e6 * 1e-6, 15) == 0.4);
    CHECK(app::rounded(-123.456, 4) == -123.5);
    CHECK(app::rounded(1.2345e-310, 3) == 1.23e-310);
    CHECK(app::rounded(0.0, 6) == 0.0);
    CHECK(std::isnan(app::rounded(std::nan(""), 6)));
}

TEST_CASE("number text: what is not finite is empty", "[app][number_text]")
{
    const double inf = std::numeric_limits<double>::infinity();
    for (const double value : {std::numeric_limits<double>::quiet_NaN(), inf, -inf}) {
        CHECK(number(value, 6).empty());
        CHECK(number(value, 17).empty());
        CHECK(fixed(value, 2).empty());
    }
}

TEST_CASE("number text: 17 digits read back as the same double", "[app][number_text]")
{
    const double value =
        GENERATE(0.1, 1.0 / 3.0, -2.5e-308, 1.7976931348623157e308, 5e-324, -0.0);
    CHECK(std::strtod(number(value, 17).c_str(), nullptr) == value);
}

TEST_CASE("number text: digits are significant and trailing zeros go", "[app][number_text]")
{
    CHECK(number(0.1 + 0.2, 9) == "0.3");
    CHECK(number(49712.3456, 6) == "49712.3");
    CHECK(number(250.0, 6) == "250");
    CHECK(number(-0.0, 6) == "0");
    CHECK(number(0.1, 17) == "0.1");
}

TEST_CASE("number text: fixed keeps its decimals and has no negative zero",
          "[app][number_text]")
{
    CHECK(fixed(9.84, 1) == "9.8");
    CHECK(fixed(3.0, 2) == "3.00");
    CHECK(fixed(-0.001, 1) == "0.0");
    CHECK(fixed(-0.06, 1) == "-0.1");
    CHECK(fixed(1e300, 0).size() == 301);
}

TEST_CASE("number text: what is not zero is not written as zero", "[app][number_text]")
{
    CHECK(app::never_rounded_away(-0.0042, 1) == "-0.0042");
    CHECK(app::never_rounded_away(9.84, 1) == "9.8");
    CHECK(app::never_rounded_away(0.0, 1) == "0.0");
}
