#include "app/input/study/units.hpp"

#include <catch2/catch.hpp>

#include <locale>
#include <numbers>
#include <string>
#include <vector>

namespace {

std::string complaint(const std::string& text, const std::string& unit)
{
    try {
        (void)app::parse_quantities(text, unit);
    } catch (const app::BadValue& bad) {
        return bad.what();
    }
    return {};
}

} // namespace

TEST_CASE("units: every unit is worth what it says", "[app][units]")
{
    CHECK(app::parse_quantity("3 m", "m") == 3.0);
    CHECK(app::parse_quantity("3 cm", "m") == 0.03);
    CHECK(app::parse_quantity("3 mm", "m") == 0.003);
    CHECK(app::parse_quantity("3 Pa", "MPa") == 3.0);
    CHECK(app::parse_quantity("3 kPa", "MPa") == 3e3);
    CHECK(app::parse_quantity("3 MPa", "Pa") == 3e6);
    CHECK(app::parse_quantity("3 GPa", "MPa") == 3e9);
    CHECK(app::parse_quantity("3 N/mm2", "MPa") == 3e6);
    CHECK(app::parse_quantity("3 Pa/m", "GPa/m") == 3.0);
    CHECK(app::parse_quantity("3 kPa/m", "GPa/m") == 3e3);
    CHECK(app::parse_quantity("3 MPa/m", "GPa/m") == 3e6);
    CHECK(app::parse_quantity("3 GPa/m", "GPa/m") == 3e9);
    CHECK(app::parse_quantity("3 Pa/mm", "GPa/m") == 3e3);
    CHECK(app::parse_quantity("3 N/mm3", "GPa/m") == 3e9);
    CHECK(app::parse_quantity("3 kg/m3", "kg/m3") == 3.0);
    CHECK(app::parse_quantity("3 N/m", "N/m") == 3.0);
    CHECK(app::parse_quantity("3 J/m2", "N/m") == 3.0);
    CHECK(app::parse_quantity("3 N/mm", "N/m") == 3e3);
    CHECK(app::parse_quantity("3 rad", "deg") == 3.0);
    CHECK(app::parse_quantity("180 deg", "deg") == std::numbers::pi);
    CHECK(app::parse_quantity("3 N", "kN") == 3.0);
    CHECK(app::parse_quantity("3 kN", "kN") == 3e3);
    CHECK(app::parse_quantity("3 m/s2", "m/s2") == 3.0);
    CHECK(app::parse_quantity("3", "") == 3.0);
}

TEST_CASE("units: a length has the same bits in metres and in millimetres", "[app][units]")
{
    for (int mm = 1; mm < 2000; ++mm) {
        const std::string text = std::to_string(mm);
        const std::string metres = std::to_string(mm / 1000) + "." +
                                   std::string(3 - std::to_string(mm % 1000).size(), '0') +
                                   std::to_string(mm % 1000);
        CHECK(app::parse_quantity(text + " mm", "m") ==
              app::parse_quantity(metres + " m", "m"));
    }
}

TEST_CASE("units: signs, exponents and blanks are read", "[app][units]")
{
    CHECK(app::parse_quantity("-5mm", "m") == -0.005);
    CHECK(app::parse_quantity("+5 mm", "m") == 0.005);
    CHECK(app::parse_quantity("5e-3\t m", "m") == 0.005);
    CHECK(app::parse_quantity(".5 m", "m") == 0.5);
    CHECK(app::parse_quantity("5. m", "m") == 5.0);
    CHECK(app::parse_quantity("1E3 m", "m") == 1000.0);
}

TEST_CASE("units: the unit of a list stands once at its end, or on each value", "[app][units]")
{
    const std::vector<double> stresses = {0.15e6, 0.5e6, 0.75e6};
    CHECK(app::parse_quantities("0.15, 0.50, 0.75 MPa", "MPa") == stresses);
    CHECK(app::parse_quantities("150 kPa, 0.50 MPa, 0.75 N/mm2", "MPa") == stresses);
    CHECK(app::parse_quantities("1, 2, 3", "") == std::vector<double>{1, 2, 3});
    const std::string some = "; write it once at the end, or on each value";
    CHECK(complaint("1, 2 MPa, 3 MPa", "MPa") == "missing unit in \"1, 2 MPa, 3 MPa\"" + some);
    CHECK(complaint("1 MPa, 2 MPa, 3", "MPa") == "missing unit in \"1 MPa, 2 MPa, 3\"" + some);
    CHECK(complaint("1, 2, 3", "MPa") == "missing unit; write \"1, 2, 3 MPa\"");
    CHECK(complaint("49", "m") == "missing unit; write \"49 m\"");
    CHECK(complaint("31", "deg") == "missing unit; write \"31 deg\"");
    CHECK(complaint("0.6", "deg") ==
          "missing unit; write \"0.6 deg\", or \"30.96 deg\" where it is the coefficient of "
          "friction");
    CHECK(complaint("0.1, 200", "m") == "missing unit; write \"0.1, 200 mm\"");
    CHECK(complaint("1, 2,", "") ==
          "empty place in the list \"1, 2,\"; write a number between two commas");
}

TEST_CASE("units: a list without blanks is offered as a list, a share in percent as a number",
          "[app][units]")
{
    CHECK(complaint("1,-1,2,-2 mm", "mm") == "comma inside \"1,-1,2,-2 mm\"; write a blank "
                                             "after each comma of a list, \"1, -1, 2, -2 mm\"");
    CHECK(complaint("1,-1 mm", "mm") ==
          "comma inside \"1,-1 mm\"; write a blank after each comma of a list, \"1, -1 mm\"");
    CHECK(complaint("0,20 m", "m") == "comma inside \"0,20 m\"; write a decimal point, \"0.20 "
                                      "m\", or a list with blanks, \"0, 20 m\"");
    CHECK(complaint("80 %", "") == "a percentage where a number belongs; write \"0.8\"");
}

TEST_CASE("units: what is no decimal number with its unit is refused", "[app][units]")
{
    const std::string text =
        GENERATE("nan m", "NaN", "inf m", "-Infinity m", "nan(1) m", "1e999 m", "1e-999 m",
                 "0x1p3 m", "1,5 m", "1.5.2 m", "1e3.5 m", "--1 m", "+-1 m", "-+1 m", "m",
                 "one m", "1 000 m", "1 m 2", "1 m m", "", "- m", "-. m", ". m", "e3 m",
                 "1 + 1 m", "0", "1 M", "1 ft", "1 %", "1 m;");
    INFO(text);
    CHECK(complaint(text, "m") != "");
}

TEST_CASE("units: a quantity that overflows in SI is refused", "[app][units]")
{
    CHECK(complaint("1e300 GPa", "MPa") == "\"1e300\" is beyond the range of a double; write a "
                                           "number and its unit, such as \"1 MPa\"");
}

TEST_CASE("units: a count is a whole number that a double holds exactly", "[app][units]")
{
    CHECK(app::parse_count("10") == 10.0);
    CHECK(app::parse_count("2e5") == 200000.0);
    CHECK(app::parse_count("9007199254740992") == 9007199254740992.0);
    CHECK_THROWS_AS(app::parse_count("7.5"), app::BadValue);
    CHECK_THROWS_AS(app::parse_count("1e16"), app::BadValue);
    CHECK_THROWS_AS(app::parse_count("10 m"), app::BadValue);
    CHECK_THROWS_AS(app::parse_count("1, 2"), app::BadValue);
}

TEST_CASE("units: a formatted quantity reads back to the same bits", "[app][units]")
{
    const std::string unit = GENERATE("m", "mm", "MPa", "GPa", "GPa/m", "deg", "kg/m3", "");
    double value = 1.0 / 3.0;
    for (int i = 0; i < 2000; ++i) {
        value *= 1.0 + 1.0 / 97.0; // 1/3 to 3e8, all digits in use
        const std::vector<double> both = {value, -value};
        const std::string text = app::format_quantities(both, unit);
        INFO(text);
        CHECK(app::parse_quantities(text, unit) == both);
    }
    CHECK(app::format_quantities(std::vector<double>{3.7e6}, "MPa") == "3.7 MPa");
    CHECK(app::format_quantities(std::vector<double>{0.15e6, 0.5e6}, "MPa") == "0.15, 0.5 MPa");
}

TEST_CASE("units: a formatted angle has the digits that were written, where they give its bits",
          "[app][units]")
{
    for (const std::string text : {"30 deg", "31.8 deg", "35 deg"})
        CHECK(app::format_quantities(app::parse_quantities(text, "deg"), "deg") == text);
}

TEST_CASE("units: the locale of the user changes nothing", "[app][units]")
{
    struct Comma : std::numpunct<char> {
        char do_decimal_point() const override { return ','; }
        char do_thousands_sep() const override { return '.'; }
        std::string do_grouping() const override { return "\3"; }
    };
    const std::locale before = std::locale::global(std::locale(std::locale(), new Comma));
    const double read = app::parse_quantity("1234.5 m", "m");
    const std::string written = app::format_quantities(std::vector<double>{1234.5}, "m");
    std::locale::global(before);
    CHECK(read == 1234.5);
    CHECK(written == "1234.5 m");
}

TEST_CASE("units: raised digits, and weights per volume, are read", "[app][units]")
{
    CHECK(app::parse_quantity("2300 kg/m\u00b3", "kg/m3") == 2300.0);
    CHECK(app::parse_quantity("2300 kg/m^3", "kg/m3") == 2300.0);
    CHECK(app::parse_quantity("3.5 N/mm\u00b2", "MPa") == 3.5e6);
    CHECK(app::parse_quantity("2 N/mm\u00b3", "GPa/m") == 2e9);
    CHECK(app::parse_quantity("9.81 m/s\u00b2", "m/s2") == 9.81);
    // the density that weighs as much under the gravity of a study
    CHECK(app::parse_quantity("23 kN/m3", "kg/m3") * 9.81 == Approx(23e3).epsilon(1e-15));
    CHECK(app::parse_quantity("23 kN/m\u00b3", "kg/m3") ==
          app::parse_quantity("23 kN/m3", "kg/m3"));
    CHECK_THROWS_WITH(app::parse_quantity("23 kN/m\u00b2", "kg/m3"),
                      Catch::Contains("kN/m\u00b2") && Catch::Contains("use kg/m3 or kN/m3"));
}
