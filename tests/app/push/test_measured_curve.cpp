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

TEST_CASE("measured curve: columns are found by their units, whatever they are called",
          "[app][csv]")
{
    for (const char* const head :
         {"Weg [mm];Zeit [s];Kraft [kN]", "Spostamento (mm);t;Forza (kN)", "u_mm;n;F_kN",
          "D\xC3\xA9placement mm;temps s;effort kN", "mm;step;KN",
          "displacement_mm;uplift_mm;force_kN"}) {
        INFO(head);
        const app::TestCurve c = read(std::string(head) + "\n0,0;1;0\n2,5;2;-20,5\n");
        CHECK(c.displacement.back() == Approx(0.0025).epsilon(1e-12));
        CHECK(c.force.back() == -20500.0);
    }
    CHECK_THROWS_WITH(read("LVDT1 [mm],LVDT2 [mm],Load [kN]\n0,0,0\n1,1,1\n"),
                      Catch::Contains("wall.csv:1: several columns may be the displacement in "
                                      "mm, cm or m among \"LVDT1 [mm]\", \"LVDT2 [mm]\""));
    CHECK_THROWS_WITH(read("drift [%],force_kN\n0,0\n1,1\n"),
                      Catch::Contains("a drift in % times the height"));
    CHECK_THROWS_WITH(read("displacement_mm force_kN\n0 0\n1 1\n"),
                      Catch::Contains("between commas, semicolons or tabs"));
}

TEST_CASE(
    "measured curve: lines about the test stand before the head, units may stand below it",
    "[app][csv]")
{
    for (const char* const before :
         {"displacement_mm,force_kN\n", "displacement,force\nmm,kN\n", "u,H\n[mm],[kN]\n",
          "Wall W3, 0.5 MPa\n\ndisplacement_mm,force_kN\n", "sep=,\nu,H\nmm,kN\n",
          "# of 12 March; rig 2\n# operator: N. N.\ndisplacement,force\n(mm),(kN)\n"}) {
        INFO(before);
        const app::TestCurve c = read(std::string(before) + "0,0\n2.5,-20.5\n");
        CHECK(c.displacement.back() == Approx(0.0025).epsilon(1e-12));
        CHECK(c.force.back() == -20500.0);
    }
    CHECK(read("displacement_mm,force_kN,\n0,0,\n1,2,\n").force.back() == 2000.0);
    CHECK(read("displacement_mm,force_kN\r0,0\r1,2\r").force.back() == 2000.0);
    CHECK_THROWS_WITH(read("Wall W3\n\ndisplacement_mm,force_kN\n0,0\n1,x\n"),
                      Catch::Contains("wall.csv:5: force_kN: "));
    CHECK_THROWS_WITH(read("Wall W3\nu,f\n0,0\n1,1\n"), Catch::Contains("wall.csv:2: has no"));
    CHECK_THROWS_WITH(read("0.0,0.0\n1.0,2.0\n"),
                      Catch::Contains("wall.csv:1: has no head above its numbers"));
    CHECK_THROWS_WITH(read("\xFF\xFE"
                           "d"),
                      Catch::Contains("UTF-16; save it as UTF-8"));
    CHECK_THROWS_WITH(read("displacement_mm;force_kN\n0;0\n1;1,600.5\n"),
                      Catch::Contains("\"1,600.5\" is not a number"));
}
