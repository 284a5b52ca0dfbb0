#include "app/output/capacity_csv.hpp"

#include <catch2/catch.hpp>

#include <limits>
#include <locale>
#include <stdexcept>
#include <vector>

TEST_CASE("capacity csv: rows are in mm, percent and kN", "[app][capacity_csv]")
{
    const std::vector<double> displacement = {0.0, 0.0011, 0.03},
                              force = {0.0, 49712.3456, -120.0};
    CHECK(app::capacity_csv(displacement, force, 1.1) ==
          "displacement_mm,drift_percent,force_kN\n"
          "0,0,0\n"
          "1.1,0.1,49.7123456\n"
          "30,2.72727273,-0.12\n");
}

TEST_CASE("capacity csv: what is not finite is an empty cell", "[app][capacity_csv]")
{
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const std::vector<double> displacement = {0.001, nan}, force = {nan, 1000.0};
    CHECK(app::capacity_csv(displacement, force, 1.0) ==
          "displacement_mm,drift_percent,force_kN\n1,0.1,\n,,1\n");
}

TEST_CASE("capacity csv: the decimal sign does not follow the locale", "[app][capacity_csv]")
{
    struct Comma : std::numpunct<char> {
        char do_decimal_point() const override { return ','; }
    };
    const std::locale before = std::locale::global(std::locale(std::locale(), new Comma));
    const std::vector<double> displacement = {0.0015}, force = {2500.0};
    const std::string table = app::capacity_csv(displacement, force, 1.0);
    std::locale::global(before);
    CHECK(table == "displacement_mm,drift_percent,force_kN\n1.5,0.15,2.5\n");
}

TEST_CASE("capacity csv: unequal lengths and a height that is not positive are refused",
          "[app][capacity_csv]")
{
    const std::vector<double> two = {0.0, 1.0}, one = {0.0};
    CHECK_THROWS_AS(app::capacity_csv(two, one, 1.0), std::invalid_argument);
    CHECK_THROWS_AS(app::capacity_csv(two, two, 0.0), std::invalid_argument);
    CHECK_THROWS_AS(app::capacity_csv(two, two, std::numeric_limits<double>::quiet_NaN()),
                    std::invalid_argument);
}
