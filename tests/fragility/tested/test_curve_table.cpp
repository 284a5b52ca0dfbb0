#include "bench/tested/curve_table.hpp"
#include "bench/tested/measured_walls.hpp"
#include "tests/scenes/temporary_folder.hpp"

#include <catch2/catch.hpp>

#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;

struct Folder : scenes::TemporaryFolder {
    fs::path file(const std::string& name, const std::string& text) const
    {
        std::ofstream(path / name) << text;
        return path / name;
    }
};

const std::string kHead = "displacement_mm,drift_percent,force_kN\n";

} // namespace

TEST_CASE("curve table: columns are found by name, below any heading and above any units",
          "[fragility][curve_table]")
{
    const Folder folder;
    const fs::path file = folder.file("a.csv", "Test unit,SW.1\r\nforce,other,way\r\n"
                                               "[kN],[-],[mm]\r\n3,x,0.5\r\n2.5,,1\r\n");
    const bench::CurveTable t = bench::read_curve_table(file, "way", "force");
    CHECK(t.displacement_mm == std::vector<double>{0.5, 1.0});
    CHECK(t.force_kN == std::vector<double>{3.0, 2.5});
}

TEST_CASE("curve table: what cannot be read is named with its line", "[fragility][curve_table]")
{
    using Catch::Matchers::Contains;
    const Folder folder;
    const auto refused = [&](const std::string& text, const std::string& why) {
        CHECK_THROWS_WITH(bench::read_capacity_curve(folder.file("a.csv", text)),
                          Contains(why));
    };
    refused(kHead + "0,0,0\n1,0,nan\n", "a.csv:3: 'nan'");
    refused(kHead + "0,0,0\n1,0,inf\n", "a.csv:3: 'inf'");
    refused(kHead + "0,0,\n", "a.csv:2: ''");
    refused(kHead + "0,0,1 kN\n", "a.csv:2: '1 kN'");
    refused(kHead + "0,0\n", "a.csv:2: too few columns");
    refused(kHead, "a.csv:1: no points");
    refused("", "a.csv: no points");
    refused("displacement_mm,drift_percent,force_N\n0,0,0\n", "a.csv: no points");
    refused(kHead + "0,0,0\n2,0,1\n1,0,1\n",
            "a.csv: capacity curve: point 3: displacement decreases");
    CHECK_THROWS_WITH(bench::read_capacity_curve(folder.path / "none.csv"),
                      Contains("none.csv: cannot be read"));
    CHECK_THROWS_AS(bench::read_capacity_curve(folder.path), std::runtime_error);
}

TEST_CASE("curve table: points that go back are dropped, steps are kept",
          "[fragility][curve_table]")
{
    const bench::CurveTable t = bench::never_backwards(
        {{0.0, 1.0, 1.0, 0.9, 1.0, 2.0}, {0.0, 5.0, 4.0, 3.0, 2.0, 1.0}});
    CHECK(t.displacement_mm == std::vector<double>{0.0, 1.0, 1.0, 1.0, 2.0});
    CHECK(t.force_kN == std::vector<double>{0.0, 5.0, 4.0, 2.0, 1.0});
}

TEST_CASE("measured walls: a series is its own files, in order", "[fragility][measured_walls]")
{
    const Folder folder;
    const std::string text = "top_displacement,horizontal_force\n[mm],[kN]\n0,0\n1,2\n0.9,3\n";
    for (const char* name :
         {"FD_SW305_a.csv", "FD_SW302_a.csv", "FD_SW304_a.csv", "FD_SW301_a.csv",
          "FD_SW303_a.csv", "FD_SW300.csv", "FD_SW3001_a.csv", "FD_SW306_a.txt",
          "FD_SW30X_a.csv", "FD_SW100_a.csv", "FD_SW30.csv"})
        folder.file(name, text);
    std::string names;
    for (const bench::MeasuredWall& w : bench::read_series(folder.path, "30")) {
        names += w.name + " ";
        CHECK(w.table.force_kN == std::vector<double>{0.0, 2.0}); // never backwards
    }
    CHECK(names == "SW.30.1 SW.30.2 SW.30.3 SW.30.4 SW.30.5 ");
    folder.file("FD_SW7_a.csv", text);
    CHECK(bench::read_series(folder.path, "").empty()); // a level that was not tested
    CHECK_THROWS(bench::read_series(folder.path / "none", "30"));
}
