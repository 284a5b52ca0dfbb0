#include "app/fragility/fragility_means.hpp"

#include "app/fragility/fragility_inputs.hpp"
#include "app/study/answers/mean_cells.hpp"
#include "app/study/study_summary.hpp"
#include "tests/app/fragility/fragility_scenes.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <string>
#include <variant>
#include <vector>

using scenes::cell;
using scenes::number_in;

namespace {
const char* const kFell = "displacement of walls that fell [mm]";
}

// two stresses: rows 0 and 1 are rocking, rows 2 and 3 mixed

TEST_CASE(
    "fragility means: runs that ended before a drop are bounds, never averaged as observed",
    "[app][fragility_means]")
{
    const app::Table t = app::mean_table(scenes::study_walls(13));
    CHECK(scenes::sound(t));
    REQUIRE(t.rows.size() == 4);
    CHECK(cell(t, 0, "mode") == "rocking");
    CHECK(cell(t, 0, kFell).empty());
    CHECK(cell(t, 0, "observed") == "0");
    CHECK(cell(t, 0, "mean end of censored runs [mm]") == "> 28.00");
    CHECK(cell(t, 0, "median displacement [mm]") == ">= 28.0");
    app::StudyWalls both = scenes::study_walls(13);
    both.levels[0].walls[0].reading.ultimate.reading = fragility::Reading::censored;
    both.levels[0].walls[0].reading.ultimate.displacement = 1.0;
    const app::Table mixed = app::mean_table(both);
    CHECK(cell(mixed, 2, "mode") == "mixed");
    CHECK(cell(mixed, 2, "censored") == "1");
    CHECK(number_in(mixed, 2, kFell).value > 15.0);
}

TEST_CASE("fragility means: means and standard errors are those of the walls of the mode",
          "[app][fragility_means]")
{
    app::StudyWalls walls = scenes::study_walls(13);
    for (app::StudyWall& w : walls.levels[0].walls) w.reading.mode = dem::FailureMode::rocking;
    for (const std::size_t i : {std::size_t{0}, std::size_t{1}}) {
        app::StudyWall& w = walls.levels[0].walls[i];
        w.reading.mode = dem::FailureMode::mixed;
        w.reading.peak->force = 40e3 + 4e3 * static_cast<double>(i);
        w.reading.ultimate = {0.016 + 0.002 * static_cast<double>(i),
                              fragility::Reading::observed, ""};
    }
    const app::Table t = app::mean_table(walls);
    CHECK(cell(t, 2, "n") == "2");
    CHECK(cell(t, 2, "peak force [kN]") == "42.00 +- 2.00");
    CHECK(cell(t, 2, kFell) == "17.00 +- 1.00");
    CHECK(cell(t, 2, "joint.friction_angle [deg]") == "21.00 +- 1.00");
    CHECK(cell(t, 2, "median displacement [mm]") == "16.0 [0.0, no limit]"); // of two walls
}

TEST_CASE("fragility means: a mode that does not occur is said in words, one wall has no error",
          "[app][fragility_means]")
{
    app::StudyWalls walls = scenes::study_walls(13);
    for (app::StudyWall& w : walls.levels[0].walls) w.reading.mode = dem::FailureMode::rocking;
    walls.levels[0].walls[2].reading.mode = dem::FailureMode::mixed;
    for (app::StudyWall& w : walls.levels[1].walls) w.reading.mode = dem::FailureMode::rocking;
    const app::Table t = app::mean_table(walls);
    CHECK(scenes::sound(t));
    CHECK(number_in(t, 2, "peak force [kN]").value > 0.0);
    CHECK(std::isnan(number_in(t, 2, "peak force [kN]").error));
    CHECK(cell(t, 3, "note") == "The mode does not occur.");
    CHECK(cell(t, 3, "share [%]").empty());
    CHECK(cell(t, 3, "peak force [kN]").empty());
}

TEST_CASE("fragility means: the mean curve of equal curves is that curve, with no band",
          "[app][fragility_means]")
{
    app::StudyWalls walls = scenes::study_walls(6);
    for (app::StudyLevel& level : walls.levels)
        for (app::StudyWall& w : level.walls)
            for (std::size_t i = 0; i < w.forces.size(); ++i)
                w.forces[i] = 1e3 * static_cast<double>(i);
    const app::Table t = app::mean_curve_table(walls);
    for (std::size_t r = 0; r < t.rows.size(); ++r) {
        const double mean = number_in(t, r, "mean force [kN]").value;
        CHECK(mean == number_in(t, r, "16 % of the walls below [kN]").value);
        CHECK(mean == number_in(t, r, "84 % of the walls below [kN]").value);
        // step i at i x 0.25 mm of a height of 1.1 m
        CHECK(number_in(t, r, "drift [%]").value == Approx(mean * 0.025 / 1.1).epsilon(1e-12));
    }
}

TEST_CASE(
    "fragility means: a mean curve ends where fewer than 90 % of its walls are pushed, and "
    "says that runs ended early",
    "[app][fragility_means]")
{
    app::StudyWalls walls = scenes::study_walls(20);
    CHECK(app::mean_curve_table(walls).caption.find("ended before") == std::string::npos);
    for (app::StudyWall& w : walls.levels[0].walls) w.reading.mode = dem::FailureMode::rocking;
    for (std::size_t i = 0; i < 3; ++i) walls.levels[0].walls[i].forces.resize(i < 2 ? 41 : 61);
    walls.study.load.stop_below = 0.5;
    const app::Table t = app::mean_curve_table(walls);
    std::size_t rows = 0;
    while (rows < t.rows.size() && cell(t, rows, "stress [MPa]") == "0.5" &&
           cell(t, rows, "walls") == "rocking")
        ++rows;
    CHECK(rows == 16); // steps 0, 4, ..., 60
    CHECK(cell(t, 10, "n") == "20");
    CHECK(cell(t, 11, "n") == "18");
    CHECK(t.caption.find("3 of 20 at 0.50 MPa (load.stop_below ends a run once the force has "
                         "fallen to 50 % of the peak)") != std::string::npos);
    CHECK(t.caption.find("above the mean of all") != std::string::npos);
}

TEST_CASE(
    "fragility inputs: a force that is linear in the friction angle correlates with it alone",
    "[app][fragility_inputs]")
{
    const app::Table t = app::input_table(scenes::study_walls(39));
    CHECK(scenes::sound(t));
    REQUIRE(t.rows.size() == 8);
    CHECK(cell(t, 0, "input") == "joint.friction_angle");
    CHECK(cell(t, 0, "r").starts_with("1.00"));
    CHECK(number_in(t, 0, "rank regression").value == Approx(1.0).margin(0.01));
    CHECK(std::abs(number_in(t, 1, "r").value) < 0.3);
    CHECK(std::stoi(cell(t, 2, "n")) < 39); // displacement: walls that fell
}

TEST_CASE("fragility inputs: too few walls and inputs that do not vary are said in words",
          "[app][fragility_inputs]")
{
    CHECK(cell(app::input_table(scenes::study_walls(3)), 0, "note") == "Fewer than 4 walls.");
    app::StudyWalls walls = scenes::study_walls(20);
    for (app::StudyWall& w : walls.levels[0].walls) w.inputs[1] = 3.7;
    const app::Table t = app::input_table(walls);
    CHECK(cell(t, 1, "r").empty());
    CHECK(cell(t, 1, "note") == "The input does not vary.");
    CHECK(scenes::sound(t));
}

TEST_CASE(
    "fragility means: of walls that all fell the median is the middle one, and its interval "
    "that of ranks",
    "[app][fragility_means]")
{
    std::vector<fragility::Observation> walls;
    for (int i = 1; i <= 20; ++i) walls.push_back(fragility::observed(i));
    // ranks 6 and 15 of 20 hold the median in 95.9 of 100 samples (Conover, Practical
    // Nonparametric Statistics, table A3)
    CHECK(app::cell_text(app::median_cell(walls, 0.95, 1)) == "10.0 [6.0, 15.0]");
    CHECK(app::cell_text(app::median_cell({}, 0.95, 1)).empty());
    // pushes to one target end a rounding apart
    walls.clear();
    for (int i = 0; i < 16; ++i) walls.push_back(fragility::right_censored(35.99 - 1e-3 * i));
    CHECK(app::cell_text(app::median_cell(walls, 0.95, 1)) == ">= 35.9");
}

TEST_CASE("fragility means: the study's ultimate displacement is the median of all its walls, "
          "never the mean of those that fell",
          "[app][fragility_means]")
{
    app::StudyWalls walls = scenes::study_walls(20);
    const auto set = [&](std::size_t level, std::size_t fell) {
        for (std::size_t i = 0; i < 20; ++i)
            walls.levels[level].walls[i].reading.ultimate =
                i < fell
                    ? fragility::LimitDisplacement{0.010 + 0.001 * static_cast<double>(i),
                                                   fragility::Reading::observed, ""}
                    : fragility::LimitDisplacement{0.060, fragility::Reading::censored, ""};
    };
    set(0, 12);
    set(1, 1);
    const app::Table t = app::summarise(walls).table;
    CHECK(cell(t, 0, "ultimate [mm]").starts_with("19.0 [15.0, ")); // tenth of twenty; ranks
    CHECK(cell(t, 0, "observed") == "12");
    CHECK(cell(t, 0, "censored") == "8");
    CHECK(cell(t, 1, "ultimate [mm]") == ">= 60.0"); // one fell at 10 mm
    CHECK(cell(t, 1, "observed") == "1");
    // few of few: less than half fell, and the doubt is said
    walls.levels[1].walls.resize(8);
    set(0, 20);
    for (std::size_t i = 0; i < 3; ++i)
        walls.levels[1].walls[i].reading.ultimate = {0.010 + 0.001 * static_cast<double>(i),
                                                     fragility::Reading::observed, ""};
    CHECK(cell(app::summarise(walls).table, 1, "ultimate [mm]") == ">= 60.0 [10.0, no limit]");
    const app::PlainTable plain = app::plain(app::summarise(walls).table);
    const auto at = [&](const std::string& head) {
        const auto found = std::find(plain.head.begin(), plain.head.end(), head);
        REQUIRE(found != plain.head.end());
        return plain.rows[1][static_cast<std::size_t>(found - plain.head.begin())];
    };
    CHECK(std::get<double>(at("ultimate [mm]")) == 60.0);
    CHECK(std::get<double>(at("ultimate censored")) == 1.0);
    CHECK(std::get<double>(at("ultimate lower [mm]")) == 10.0);
    CHECK(std::holds_alternative<std::monostate>(at("ultimate upper [mm]")));
}
