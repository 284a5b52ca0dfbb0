#include "app/push/test_curve.hpp"
#include "tests/scenes/temporary_folder.hpp"

#include <catch2/catch.hpp>

#include <fstream>
#include <string>
#include <vector>

namespace {

app::TestCurve read(const std::string& text)
{
    const scenes::TemporaryFolder folder;
    const std::string path = (folder.path / "wall.csv").string();
    std::ofstream(path, std::ios::binary) << text;
    return app::read_test_curve(path);
}

} // namespace

TEST_CASE("measured curve: blanks, plus signs and decimal commas are those of other tables",
          "[app][csv]")
{
    const std::vector<double> force = {0.0, -20500.0, 30000.0};
    CHECK(read("displacement_mm, force_kN\n0, 0\n-1.5, -20.5 \n +2, 30\n").force == force);
    CHECK(read("displacement_mm;force_kN\n0;0\n-1,5; -20,5\n2;+30\n").force == force);
}

TEST_CASE("measured curve: a bad cell is named by row and column", "[app][csv]")
{
    for (const char* const cell : {"nan", "-inf", "1e400", "12x", ""})
        CHECK_THROWS_WITH(read("displacement_mm,force_kN\n0,0\n1," + std::string(cell) + "\n"),
                          Catch::Contains("wall.csv:3: force_kN: "));
}

TEST_CASE("measured curve: columns in other units are read, in units that nobody knows refused",
          "[app][csv]")
{
    const auto same = [](const std::string& heads, const std::string& row) {
        INFO(heads);
        const app::TestCurve c = read(heads + "\n0,0\n" + row + "\n");
        CHECK(c.displacement.back() == Approx(0.0025).epsilon(1e-12));
        CHECK(c.force.back() == Approx(-20500.0).epsilon(1e-12));
    };
    same("displacement_mm,force_kN", "2.5,-20.5");
    same("displacement [m],force [N]", "0.0025,-20500");
    same("displacement (cm),force (MN)", "0.25,-0.0205");
    CHECK_THROWS_WITH(read("displacement [ell],force_kN\n0,0\n1,1\n"),
                      Catch::Contains("wall.csv:1: has no column of the displacement in mm, cm "
                                      "or m among \"displacement [ell]\", \"force_kN\"; name "
                                      "it as in"));
}
