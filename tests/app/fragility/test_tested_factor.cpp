#include "app/calibration/test_notes.hpp"
#include "app/calibration/tested_factor.hpp"
#include "app/commands.hpp"
#include "app/input/command_line.hpp"
#include "app/input/study/model_factor_text.hpp"
#include "app/study_scenes.hpp"
#include "app/text/config_error.hpp"
#include "app/verbs.hpp"
#include "scenes/temporary_folder.hpp"
#include "tests/app/fragility/fragility_scenes.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <fstream>
#include <string>
#include <vector>

using app::Answer;
using scenes::cell;
using scenes::number_in;

namespace {

app::Csv table(const std::string& text) { return app::parse_csv("tests.csv", text); }

/// Tests whose peaks and drops are those of the walls times a factor.
std::string tests_of(const app::StudyWalls& walls, double factor)
{
    const std::vector<app::MeasuredTest> ones = {
        {"", walls.levels[0].stress, 1.0, 1.0, false, 2},
        {"", walls.levels[1].stress, 1.0, 1.0, false, 3}};
    const app::Csv none = table("stress,peak\n1,1\n");
    const auto peaks = app::tests_over_walls(none, ones, walls, Answer::force);
    std::string text = "wall;stress [MPa];peak [kN]\n";
    for (const double scatter : {0.9, 1.0, 1.1111111111})
        for (const app::TestedWall& w : peaks)
            text += "W" + std::to_string(text.size()) + ";" + std::to_string(w.stress / 1e6) +
                    ";" + std::to_string(factor * scatter * w.predicted) + "\n";
    return text;
}

void refused(const std::string& text, const std::string& message)
{
    CHECK_THROWS_WITH(app::measured_tests(table(text), 1.1), Catch::StartsWith(message));
}

} // namespace

TEST_CASE("calibration: tests that are twice the walls give a factor of two",
          "[app][calibration]")
{
    const app::StudyWalls walls = scenes::study_walls(30);
    const app::Csv csv = table(tests_of(walls, 2.0));
    const auto c = app::tested_factor(
        app::tests_over_walls(csv, app::measured_tests(csv, 1.1), walls, Answer::force));
    REQUIRE(c.factor);
    CHECK(c.factor->factor.median == Approx(2.0).epsilon(1e-5));
    CHECK(c.factor->factor.dispersion > 0.08);
    CHECK(c.factor->factor.dispersion < 0.25);
    const app::TestedFactor drift = app::tested_factor({});
    CHECK_FALSE(drift.factor);
    const std::string lines = app::factor_lines(drift, c, "tests.csv over s.h5");
    // the line is one that a study takes, with the same factor
    const auto at = lines.find("model_factor_force = ") + 21;
    const auto choice = app::parse_model_factor(lines.substr(at, lines.find(" #", at) - at));
    REQUIRE(choice.given);
    CHECK(choice.given->median == Approx(2.0).epsilon(5e-3));
    CHECK(choice.given->dispersion ==
          Approx(fragility::model_dispersion(c.factor->factor)).epsilon(5e-3));
    CHECK_THAT(lines,
               Catch::Contains("# model_factor: no factor: 0 tests have a measured value"));
    const app::Table t = app::factor_table(drift, c);
    REQUIRE(t.rows.size() == 6);
    CHECK(scenes::sound(t));
    CHECK(number_in(t, 2, "ratio").value == Approx(2.0).epsilon(1e-5));
    CHECK(number_in(t, 2, "interval by the others").lower < 2.0);
    CHECK(number_in(t, 2, "interval by the others").upper > 2.0);
}

TEST_CASE("calibration: a table of tests has stresses, peaks, drops and bounds",
          "[app][calibration]")
{
    const auto tests = app::measured_tests(
        table("wall;stress [MPa];peak [kN];drop [mm];censored\n"
              "A;0,5;41,5;12,6;no\nB;0,5;48,2;22,7;yes\nC;1;NA;9,3;0\nD;1;80;;\n"),
        1.1);
    REQUIRE(tests.size() == 4);
    CHECK(tests[0].name == "A");
    CHECK(tests[0].stress == Approx(0.5e6));
    CHECK(*tests[0].peak == Approx(41.5));
    CHECK(*tests[1].drop == Approx(22.7));
    CHECK(tests[1].censored);
    CHECK_FALSE(tests[0].censored);
    CHECK_FALSE(tests[2].peak);
    CHECK_FALSE(tests[3].drop); // and its censoring is not asked for
}

TEST_CASE("calibration: mistakes of a table are named by file, line and column",
          "[app][calibration]")
{
    // whole messages: each is written by one guard alone, so that another one cannot answer
    refused("stress [MPa],peak [kN]\n",
            "tests.csv: there is no row below the head; write one for each wall");
    refused("peak [kN]\n40\n", "tests.csv:1: stress [MPa]: there is no such column; name the "
                               "vertical stress of each test");
    refused(
        "stress [MPa]\n1\n",
        "tests.csv:1: peak [kN], stiffness [kN/mm], drop [mm], force at 5 mm [kN], energy of "
        "cycle 1 [J]: there is none of these columns; give at least one of them");
    refused("stress [MPa],drop [mm],drop [%]\n0.5,,0.4\n",
            "tests.csv:1: drop [%]: is a second column of \"drop\", beside \"drop [mm]\"");
    refused("stress [MPa],force at 2 mm [kN],force at 2.0 mm [kN]\n0.5,4,4\n",
            "tests.csv:1: force at 2.0 mm [kN]: there are two such columns");
    refused("stress,peak [kN]\n0.5,40\n",
            "tests.csv:1: stress: missing unit; write \"stress [MPa]\"");
    refused("stress [MPa],peak\n0.5,40\n",
            "tests.csv:1: peak: missing unit; write \"peak [kN]\"");
    refused("stress [MPa],drop\n0.5,4\n",
            "tests.csv:1: drop: missing unit; write \"drop [mm]\" or \"drop [%]\"");
    refused("stress [MPa],force at 5 mm\n0.5,4\n",
            "tests.csv:1: force at 5 mm: missing unit; write \"force at 5 mm [kN]\"");
    refused("stress [kPa],peak [kN]\n500,40\n", "tests.csv:1: stress [kPa]: is not in MPa; "
                                                "convert it, and write \"stress [MPa]\"");
    refused("stress [MPa],drop [cm]\n1,2\n", "tests.csv:1: drop [cm]: is not in mm or %; "
                                             "convert it, and write \"drop [mm]\"");
    refused("stress [MPa],stiffness [N/m]\n0.5,40\n",
            "tests.csv:1: stiffness [N/m]: is not in kN/mm; convert it, and write \"stiffness "
            "[kN/mm]\"");
    refused("stress [MPa],peak [kN]\n0.5,forty\n",
            "tests.csv:2: peak [kN]: \"forty\" is not a number");
    refused("stress [MPa],peak [kN]\n0.5,40\n0.5,0\n",
            "tests.csv:3: peak [kN]: must be above 0; write NA if it was not measured");
    refused("stress [MPa],peak [kN]\n0.5,-4\n",
            "tests.csv:2: peak [kN]: \"-4\" is negative; it must be at least 0");
    refused("stress [MPa],peak [kN]\n0.5,1e300\n",
            "tests.csv:2: peak [kN]: is no number of a wall; check it and its unit");
    refused("stress [MPa],peak [kN]\n0.5,nan\n",
            "tests.csv:2: peak [kN]: \"nan\" is not a finite number");
    refused("stress [MPa],peak [kN]\n,40\n", "tests.csv:2: stress [MPa]: empty cell; write the "
                                             "vertical stress in MPa");
    refused("stress [MPa],peak [kN]\n0.5,NA\n",
            "tests.csv:2: peak [kN]: nothing was measured in this row; remove it");
    refused("stress [MPa],drop [mm],censored\n0.5,4,perhaps\n",
            "tests.csv:2: censored: \"perhaps\" does not say whether the value is a bound");
    refused("stress [MPa],drop [mm]\n0.5,>\n",
            "tests.csv:2: drop [mm]: a bound without a number; write e.g. \"> 22.7\"");
    refused("stress [MPa],peak [kN]\n0.5,>40\n", // bounds are of drops alone
            "tests.csv:2: peak [kN]: \">40\" is not a number");
    refused(
        "stress [MPa],peak [kN],sigma\n0.5,40,5\n",
        "tests.csv:2: sigma: must be a share of the measured value in [0, 1], or in % under "
        "\"sigma [%]\"");
}

TEST_CASE("calibration: columns without effect and rows that stand there twice are named",
          "[app][calibration]")
{
    const auto notes = [](const std::string& text, bool taught) {
        return app::test_notes(table(text), 1.1, taught);
    };
    CHECK(notes("wall,stress [MPa],peak [kN],drop [mm],censored\nA,0.5,40,9,no\n", false)
              .empty());
    CHECK(notes("stress [MPa],peak [kN],stifness [kN/mm],remark\n0.5,40,9,wet\n", true) ==
          "note: tests.csv:1: \"stifness [kN/mm]\" is not read; did you mean "
          "\"stiffness\"?\n"
          "note: tests.csv:1: \"remark\" is not read\n");
    const std::string learned = "stress [MPa],peak [kN],sigma [%],force at 5 mm [kN]\n"
                                "0.5,40,2,30\n0.5,41,2,30\n0.5,40,2,30\n";
    CHECK(notes(learned, true) ==
          "note: tests.csv:4: is the same as line 2, and counts as a further test; remove it "
          "if it is none\n");
    CHECK_THAT(
        notes(learned, false),
        Catch::StartsWith("note: tests.csv:1: \"sigma [%]\" has no effect on a factor") &&
            Catch::Contains("\"force at 5 mm [kN]\" has no effect"));
}

TEST_CASE("calibration: a drift is a displacement under the load; bounds, stiffness and errors",
          "[app][calibration]")
{
    const auto tests = app::measured_tests(
        table("stress [MPa],stiffness [kN/mm],drop [%],sigma [%]\n0.5,8,1.5,5\n1,NA,> 2,\n"),
        1.1);
    REQUIRE(tests.size() == 2);
    CHECK(*tests[0].stiffness == Approx(8.0));
    CHECK(*tests[0].drop == Approx(16.5));
    CHECK(tests[0].error == Approx(0.05));
    CHECK_FALSE(tests[0].censored);
    CHECK(*tests[1].drop == Approx(22.0));
    CHECK(tests[1].censored);
    CHECK_FALSE(tests[1].stiffness);
    CHECK(tests[1].error == 0.0);
}

TEST_CASE("calibration: a stress that the study does not have, is refused; walls that stood "
          "give no factor",
          "[app][calibration]")
{
    const app::StudyWalls walls = scenes::study_walls(30);
    const auto over = [&](const std::string& text, Answer answer) {
        const app::Csv csv = table(text);
        return app::tests_over_walls(csv, app::measured_tests(csv, 1.1), walls, answer);
    };
    CHECK_THROWS_WITH(over("stress [MPa],peak [kN]\n0.123,40\n", Answer::force),
                      Catch::StartsWith("tests.csv:2: stress: 0.123 MPa is none of the study"));
    app::StudyWalls stood = walls;
    for (app::StudyLevel& level : stood.levels)
        for (app::StudyWall& w : level.walls)
            w.reading.ultimate = {0.028, fragility::Reading::censored, {}};
    const app::Csv csv = table("stress [MPa],drop [mm]\n" +
                               std::to_string(walls.levels[0].stress / 1e6) + ",10\n");
    const auto c = app::tested_factor(
        app::tests_over_walls(csv, app::measured_tests(csv, 1.1), stood, Answer::drift));
    CHECK_FALSE(c.factor);
    CHECK_THAT(c.reason, Catch::Contains("fewer than half of the study's walls fell"));
    CHECK(cell(app::factor_table(c, {}), 0, "ratio").empty());
}

TEST_CASE("calibration: the verb pushes the walls of a study and writes its lines",
          "[app][calibration]")
{
    const scenes::TemporaryFolder folder;
    const std::string study = (folder.path / "study.ini").string(),
                      tests = (folder.path / "tests.csv").string(),
                      out = (folder.path / "out").string();
    std::ofstream(study) << study_scenes::kSmall << "[uq]\nsamples = 2\n";
    const auto run = [&](const std::string& rows, const std::string& source) {
        std::ofstream(tests) << "stress [MPa],peak [kN]\n" << rows;
        return app::calibrate_command(app::parse_command_line(
            app::verbs(), {"calibrate", source, tests, "--out", out, "--quiet"}));
    };
    CHECK_THROWS_WITH(run("0.5,20\n0.7,20\n", study),
                      Catch::Contains("tests.csv:3: stress: 0.7 MPa is none of the study's"));
    CHECK_FALSE(std::filesystem::exists(out)); // before any wall is pushed
    CHECK(run("0.5,20\n0.5,22\n1.0,38\n", study) == 0);
    const std::string lines = scenes::read_text(folder.path / "out" / "model_factor.ini");
    CHECK_THAT(lines, Catch::Contains("\nmodel_factor_force = lognormal(median "));
    CHECK(std::filesystem::exists(folder.path / "out" / "calibration.csv"));
    // its own walls, read as a file of results, say the same
    const std::string walls = (folder.path / "out" / "walls.h5").string();
    CHECK(run("0.5,20\n0.5,22\n1.0,38\n", walls) == 0);
    CHECK(scenes::read_text(folder.path / "out" / "model_factor.ini") == lines);
    CHECK(run("0.5,20\n0.5,22\n", walls) == 1);
    CHECK_THAT(scenes::read_text(folder.path / "out" / "model_factor.ini"),
               Catch::Contains("# model_factor_force: no factor: 2 tests have"));
}

TEST_CASE("calibration: two values and a bound are too few for a factor", "[app][calibration]")
{
    const auto c = app::tested_factor({{"A", 1e6, 10.0, 12.0, false},
                                       {"B", 1e6, 11.0, 12.0, false},
                                       {"C", 2e6, 12.0, 12.0, true}});
    CHECK_FALSE(c.factor);
    CHECK(c.reason == "no factor: 2 tests have a measured value, and 3 are needed");
}
