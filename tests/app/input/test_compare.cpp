#include "app/compare/compare_command.hpp"
#include "app/compare/compared.hpp"
#include "app/compare/compared_cycles.hpp"
#include "app/compare/compared_limits.hpp"
#include "app/push/test_curve.hpp"
#include "app/text/config_error.hpp"
#include "scenes/temporary_folder.hpp"
#include "scenes/terminal.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;

/// Peak 50 kN at 5 mm; at 9 mm 40 kN are left.
const std::string kTest = "time,displacement_mm,force_kN\n0,0,0\n1,5,50\n2,10,37.5\n";

std::string file_of(const fs::path& path, const std::string& text)
{
    std::ofstream(path) << text;
    return path.string();
}

std::string refusal(const std::string& path)
{
    try {
        static_cast<void>(app::read_compared(path));
    } catch (const app::ConfigError& e) {
        return e.what();
    }
    return "";
}

double value(const app::Cell& cell) { return std::get<app::Number>(cell).value; }

} // namespace

TEST_CASE("compare: a measured curve is read as a computed one", "[app][compare]")
{
    const scenes::TemporaryFolder folder;
    const auto all = app::read_compared(file_of(folder.path / "test.csv", kTest));
    REQUIRE(all.size() == 1);
    CHECK(all.front().name == "test");
    CHECK(all.front().measured);
    CHECK(all.front().peak == Approx(50e3));
    CHECK(value(all.front().cells[2]) == Approx(50.0));
    CHECK(value(all.front().cells[3]) == Approx(5.0));
    CHECK(value(all.front().cells[5]) == Approx(9.0)); // 80 % of the peak
    const std::string left = "displacement [mm];force [kN]\n0;0\n-5;-50\n-10;-37,5\n";
    const auto other = app::read_compared(file_of(folder.path / "left.csv", left));
    CHECK(value(other.front().cells[5]) == Approx(9.0));
}

TEST_CASE("compare: paths to and fro have their work, and noise is none", "[app][compare]")
{
    const scenes::TemporaryFolder folder;
    // A loop of 10 kN over 2 x 4 mm, and one way with a sensor that jitters.
    const std::string loop = "displacement_mm,force_kN\n0,0\n0,10\n2,10\n2,-10\n-2,-10\n"
                             "-2,10\n0,10\n0,0\n",
                      way = "displacement_mm,force_kN\n0,0\n2,10\n1.95,10\n4,10\n3.9,10\n";
    auto all = app::read_compared(file_of(folder.path / "loop.csv", loop));
    for (auto& c : app::read_compared(file_of(folder.path / "way.csv", way)))
        all.push_back(std::move(c));
    const app::Table t = app::compared_table(all);
    REQUIRE(t.head.at(9).name == "work [J]");
    CHECK(value(t.rows[0].at(9)) == Approx(80.0));
    CHECK(app::cell_text(t.rows[1].at(9)).empty());
    CHECK(app::compared_table({all[1]}).head.size() + 1 == t.head.size());
}

TEST_CASE("compare: a sensor that jitters, and comes home, has the peak of its way out",
          "[app][compare]")
{
    const scenes::TemporaryFolder folder;
    // 20 kN from 1 mm on; jitter of 0.02 mm to the other side; unloaded at the end
    std::string way = "displacement_mm,force_kN\n-0.02,0\n0.01,0.2\n-0.01,-0.1\n1,20\n0.99,20\n"
                      "10,20\n9.5,0\n-0.1,0\n";
    const auto right = app::read_compared(file_of(folder.path / "right.txt", way));
    CHECK(right.front().peak == Approx(20e3));
    CHECK(right.front().note.empty());
    std::string left;
    for (const char* const row : {"0.02,0", "-0.01,-0.2", "0.01,0.1", "-1,-20", "-0.99,-20",
                                  "-10,-20", "-9.5,0", "0.1,0"})
        left += std::string(row) + "\n";
    left = "displacement_mm,force_kN\n" + left;
    CHECK(app::read_compared(file_of(folder.path / "left.CSV", left)).front().peak ==
          Approx(20e3));
}

TEST_CASE("compare: forces of a reaction are turned round, and a begin off zero is told",
          "[app][compare]")
{
    const scenes::TemporaryFolder folder;
    const std::string head = "displacement_mm,force_kN\n",
                      loop = "0,0\n2,-10\n2,10\n-2,10\n-2,-10\n0,-10\n";
    auto c = app::read_compared(file_of(folder.path / "reaction.csv", head + loop)).front();
    CHECK(c.peak == Approx(10e3));
    CHECK(c.force[1] == 10e3);
    CHECK(c.note.find("against its displacements") != std::string::npos);
    c = app::read_compared(file_of(folder.path / "off.csv", head + "3,1\n5,11\n")).front();
    CHECK(c.note.find("begins at 3.00 mm and 1.00 kN") != std::string::npos);
    c = app::read_compared(file_of(folder.path / "at.csv", head + "0.01,0.1\n5,11\n")).front();
    CHECK(c.note.empty());
}

TEST_CASE("compare: cycles of a measured loop have the work and damping of their closed form, "
          "with a sensor that jitters too",
          "[app][compare]")
{
    // Slides at 20 kN, 40 kN/mm before: 4 F (a - F/k) in each cycle but the first.
    app::Compared c;
    for (const double jitter : {0.0, 0.02e-3}) {
        c = {};
        double u = 0.0, f = 0.0, sign = 1.0;
        const auto go = [&](double to) {
            const double step = to > u ? 0.01e-3 : -0.01e-3;
            while (u != to) {
                const double next = std::abs(to - u) < 1.5 * std::abs(step) ? to : u + step;
                f = std::clamp(f + 40e6 * (next - u), -20e3, 20e3);
                u = next;
                sign = -sign;
                c.displacement.push_back(u + sign * jitter);
                c.force.push_back(f);
            }
        };
        for (const double a : {2e-3, 4e-3})
            for (const double to : {a, -a, a, -a}) go(to);
        go(0.0);
        CHECK(app::targets_along(c).empty()); // only of measured paths
        c.measured = true;
        const auto cycles = app::compared_cycles(c);
        REQUIRE(cycles.size() == 4);
        CHECK(cycles[1].energy == Approx(120.0).epsilon(0.01));
        CHECK(cycles[3].energy == Approx(280.0).epsilon(0.01));
        CHECK(fragility::equivalent_damping(cycles[3]).value() ==
              Approx(2.0 / 3.14159265 * 3.5 / 4.0).epsilon(0.02));
        const std::string targets = app::targets_along(c);
        CHECK(std::ranges::count(targets, ',') == 8);
        if (jitter == 0.0) CHECK(targets == "load.targets = 2, -2, 2, -2, 4, -4, 4, -4, 0 mm");
    }
    CHECK(app::compared_cycle_table({c}).rows.size() == 4);
    c.displacement.resize(100), c.force.resize(100); // one way
    CHECK(app::compared_cycle_table({c}).rows.empty());
}

TEST_CASE("compare: a measured loop whose first amplitude is beyond yield has the stiffness of "
          "the side loaded first",
          "[app][compare]")
{
    const scenes::TemporaryFolder folder;
    const std::string loop =
        "displacement_mm,force_kN\n0,0\n0.5,20\n4,20\n3,-20\n-4,-20\n-3,20\n"
        "4,20\n3.5,0\n0,0\n";
    const auto all = app::read_compared(file_of(folder.path / "loop.csv", loop));
    CHECK(value(all.front().cells[4]) == Approx(40.0));
}

TEST_CASE("compare: folders of fragility are laid side by side by their limit drifts",
          "[app][compare]")
{
    const scenes::TemporaryFolder folder;
    const auto write = [&](const char* name, const std::string& median, const char* state) {
        fs::create_directory(folder.path / name);
        file_of(
            folder.path / name / "fragility.json",
            R"({"tables": {"performance_limits": {"rows": [{"stress [MPa]": 0.5, "n": 20, "drifts from": "mixture",
                    "limit state": ")" +
                std::string(state) + R"(", "16 % drift [%]": 0.4, "median drift [%]": )" +
                median + R"(, "median drift lower [%]": 0.45, "median drift upper [%]": 1.9,
                    "84 % drift lower [%]": 2.5, "84 % drift [%]": null}]}}})");
        return (folder.path / name).string();
    };
    auto all = app::read_limits(write("a", "0.5", "ntc SLC"));
    for (const char* const state : {"ntc SLC", "ec8 NC"})
        for (auto& limit : app::read_limits(write("b", "0.6", state))) all.push_back(limit);
    REQUIRE(all.size() == 3);
    CHECK(app::read_compared((folder.path / "a").string()).empty()); // no curves
    const app::Table t = app::compared_limit_table(all);
    REQUIRE(t.rows.size() == 3);
    CHECK(app::cell_text(t.rows[0][3]) == "mixture");
    CHECK(value(t.rows[0].back()) == Approx(0.0).margin(1e-9));
    CHECK(value(t.rows[1].back()) == Approx(20.0));             // of the same limit state
    CHECK(value(t.rows[2].back()) == Approx(0.0).margin(1e-9)); // another, the first of it
    CHECK(std::get<app::Number>(t.rows[0][7]).sense == app::Sense::above);
    CHECK(std::get<app::Number>(t.rows[0][7]).lower == Approx(2.5));
    const std::string chart = app::compared_limit_chart(all);
    CHECK(chart.find("ntc SLC") != std::string::npos); // the last of the first
    CHECK(app::read_limits((folder.path / "nothing").string()).empty());
    file_of(folder.path / "a" / "fragility.json", "{}");
    CHECK_THROWS_WITH(app::read_limits((folder.path / "a").string()),
                      Catch::Contains("has no table of limit drifts"));
}

TEST_CASE("compare: peaks are related to the first wall under the same stress",
          "[app][compare]")
{
    app::Compared a, b, c;
    a.name = "a", b.name = "b", c.name = "c";
    a.peak = 40e3, b.peak = 80e3, c.peak = 60e3;
    a.stress = 0.5e6, b.stress = 1e6, c.stress = 1e6;
    for (app::Compared* x : {&a, &b, &c}) x->cells.resize(8);
    const app::Table t = app::compared_table({a, b, c});
    CHECK(value(t.rows[0].back()) == 0.0);
    CHECK(value(t.rows[1].back()) == 0.0);
    CHECK(value(t.rows[2].back()) == Approx(-25.0));
    CHECK(t.rows[0].size() == t.head.size());
}

TEST_CASE("compare: what cannot be compared is refused with its place", "[app][compare]")
{
    const scenes::TemporaryFolder folder;
    const auto path = [&](const char* name) { return (folder.path / name).string(); };
    CHECK(refusal(path("a.txt")).find("there is no such file or folder") != std::string::npos);
    CHECK(refusal(file_of(folder.path / "a.doc", "x")).find("cannot be compared") !=
          std::string::npos);
    CHECK(refusal(file_of(path("b.csv"), "u,f\n1,2\n")) ==
          path("b.csv") +
              ":1: has no column of the displacement in mm, cm or m among \"u\", \"f\"; "
              "name it as in \"displacement_mm,force_kN\" or \"displacement "
              "[m],force [N]\"");
    CHECK(refusal(file_of(path("c.csv"), "displacement_mm,force_kN\n0,0\n1,much\n"))
              .find(":3:") != std::string::npos);
    CHECK(refusal(file_of(path("d.csv"), "displacement_mm,force_kN\n0,0\n"))
              .find("fewer than two points") != std::string::npos);
    CHECK(refusal(folder.path.string()).find("has no summary.json") != std::string::npos);
    file_of(path("summary.json"), R"({"record": "a.AT2"})");
    CHECK(refusal(folder.path.string()).find("is not the summary of a push") !=
          std::string::npos);
    file_of(path("summary.json"), "{");
    CHECK(refusal(folder.path.string()).find("is not the summary of a push") !=
          std::string::npos);
}

TEST_CASE("compare: a push and a test in one table, one chart and one page", "[app][compare]")
{
    const scenes::TemporaryFolder folder;
    fs::create_directory(folder.path / "wall");
    file_of(
        folder.path / "wall" / "summary.json",
        R"({"vertical_stress_MPa": 0.5, "peak_force_kN": 45.0, "displacement_at_peak_mm": 4.0,
                "ultimate_displacement_mm": 20.0, "ultimate_censored": true,
                "stiffness_kN_per_mm": 25.0, "load_height_m": 1.0, "mode": "rocking"})");
    file_of(folder.path / "wall" / "capacity.csv",
            "displacement_mm,drift_percent,force_kN\n0,0,0\n4,0.4,45\n");
    app::Command c;
    c.words = {(folder.path / "wall").string(), file_of(folder.path / "t<1>.csv", kTest)};
    c.out = (folder.path / "out").string();
    c.quiet = true;
    const scenes::Terminal terminal;
    CHECK(app::compare_command(c) == 0);
    CHECK(app::compare_command(c) == 0); // replaces its own
    const std::string csv = scenes::read_text(folder.path / "out" / "compare.csv");
    CHECK(csv.find("\nwall,0.5,1,45,,4,,25,") != std::string::npos); // keys of version 0.2
    CHECK(csv.find(",11.1") != std::string::npos);                   // 50 / 45
    CHECK(terminal.text().find("> 20.0") != std::string::npos);
    CHECK(terminal.text().find("> 2.00") != std::string::npos);
    const std::string page = scenes::read_text(folder.path / "out" / "compare.html");
    CHECK(page.find("t&lt;1&gt;") != std::string::npos);
    CHECK(page.find("<svg") != std::string::npos);
    CHECK(page.find("nan") == std::string::npos);
}

TEST_CASE("compare: two folders or files of one name stand with their paths", "[app][compare]")
{
    const scenes::TemporaryFolder folder;
    app::Command command;
    for (const char* const name : {"a", "b"}) {
        fs::create_directories(folder.path / name);
        command.words.push_back(file_of(folder.path / name / "test.csv", kTest));
    }
    command.words.push_back(file_of(folder.path / "other.csv", kTest));
    command.out = (folder.path / "out").string();
    {
        const scenes::Terminal terminal;
        REQUIRE(app::compare_command(command) == 0);
    }
    std::ifstream in(folder.path / "out" / "compare.csv");
    std::ostringstream text;
    text << in.rdbuf();
    CHECK(text.str().find("\n" + command.words[0] + ",") != std::string::npos);
    CHECK(text.str().find("\n" + command.words[1] + ",") != std::string::npos);
    CHECK(text.str().find("\nother,") != std::string::npos);
}
