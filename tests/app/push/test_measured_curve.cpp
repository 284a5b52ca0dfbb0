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
