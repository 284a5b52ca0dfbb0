#include "app/fragility/fragility_means.hpp"

#include "app/fragility/fragility_inputs.hpp"
#include "app/fragility_scenes.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <string>

using scenes::cell;
using scenes::number_in;

// two stresses: rows 0 and 1 are rocking, rows 2 and 3 mixed

TEST_CASE(
    "fragility means: runs that ended before a drop are bounds, never averaged as observed",
    "[app][fragility_means]")
{
    const app::Table t = app::mean_table(scenes::study_walls(13));
    CHECK(scenes::sound(t));
    REQUIRE(t.rows.size() == 4);
    CHECK(cell(t, 0, "mode") == "rocking");
    CHECK(cell(t, 0, "displacement [mm]").empty());
    CHECK(cell(t, 0, "observed") == "0");
    CHECK(cell(t, 0, "mean end of censored runs [mm]") == "> 28.00");
    CHECK(cell(t, 0, "median displacement [mm]") == "> 28.0");
    app::StudyWalls both = scenes::study_walls(13);
    both.levels[0].walls[0].reading.ultimate.reading = fragility::Reading::censored;
    both.levels[0].walls[0].reading.ultimate.displacement = 1.0;
    const app::Table mixed = app::mean_table(both);
    CHECK(cell(mixed, 2, "mode") == "mixed");
    CHECK(cell(mixed, 2, "censored") == "1");
    CHECK(number_in(mixed, 2, "displacement [mm]").value > 15.0);
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
    CHECK(cell(t, 2, "displacement [mm]") == "17.00 +- 1.00");
    CHECK(cell(t, 2, "joint.friction_angle [deg]") == "21.00 +- 1.00");
    CHECK(cell(t, 2, "median displacement [mm]").empty());
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
