#include "app/fragility/fragility_modes.hpp"

#include "app/fragility/fragility_means.hpp"
#include "app/fragility/fragility_walls.hpp"
#include "app/study/answers/mode_share.hpp"
#include "app/study/study_summary.hpp"
#include "tests/app/fragility/fragility_scenes.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <string>

using scenes::cell;
using scenes::number_in;

TEST_CASE("fragility modes: shares add up, and bounds count failed walls either way",
          "[app][fragility_modes]")
{
    app::StudyWalls walls = scenes::study_walls(8);
    walls.levels[0].failed_walls.resize(2);
    const app::Table t = app::mode_table(walls);
    REQUIRE(t.rows.size() == 4);
    CHECK(std::stoi(cell(t, 0, "walls with this mode")) +
              std::stoi(cell(t, 1, "walls with this mode")) ==
          8);
    // 20 to 30 deg: 6 mixed of 8; the others 32 and 34 deg rock
    CHECK(cell(t, 1, "walls with this mode") == "6");
    CHECK(cell(t, 1, "share [%]") == "75.0 [31.3, 94.3]"); // Wilson, of 6 of 10 and of 8 of 10
    CHECK(cell(t, 1, "Clopper-Pearson [%]") == "26.2 to 97.5");
}

TEST_CASE(
    "fragility modes: every table and the page give one interval of a share, failed walls "
    "or not",
    "[app][fragility_modes]")
{
    const std::size_t failed = GENERATE(std::size_t{0}, std::size_t{3});
    app::StudyWalls walls = scenes::study_walls(8);
    walls.study.fragility.mode.modes = dem::ModeRule::mechanism;
    walls.levels[0].failed_walls.resize(failed);
    const app::Table modes = app::mode_table(walls), means = app::mean_table(walls),
                     summary = app::summarise(walls).table;
    for (int mode = 0; mode < app::kAllModes; ++mode) {
        const auto s = app::mode_share(walls.levels[0], mode, 0.95);
        CHECK(s.failed == static_cast<double>(failed));
        const auto check = [&](const app::Number& n) {
            CHECK(n.value == 100.0 * s.value);
            CHECK(n.lower == 100.0 * s.interval.lower);
            CHECK(n.upper == 100.0 * s.interval.upper);
        };
        check(number_in(modes, static_cast<std::size_t>(mode), "share [%]"));
        check(number_in(summary, 0, std::string(app::mode_name(mode)) + " [%]"));
        if (s.count > 0.0)
            check(number_in(means, 2 * static_cast<std::size_t>(mode), "share [%]"));
    }
}

TEST_CASE("fragility modes: the interval of a share allows any mode for walls that still stood",
          "[app][fragility_modes]")
{
    app::StudyWalls walls = scenes::study_walls(8); // 6 mixed, 2 rocking
    for (app::StudyWall& w : walls.levels[0].walls)
        w.reading.mode_so_far = w.reading.mode == dem::FailureMode::rocking;
    const app::Table t = app::mode_table(walls);
    CHECK(cell(t, 0, "share [%]") == "25.0 [0.0, 59.1]");   // Wilson, of 0 and of 2 of 8
    CHECK(cell(t, 1, "share [%]") == "75.0 [40.9, 100.0]"); // of 6 and of 8 of 8
    walls.levels[0].failed_walls.resize(2);
    CHECK(cell(app::mode_table(walls), 0, "share [%]") == "25.0 [0.0, 68.7]"); // 4 of 10
    CHECK(app::mode_share(walls.levels[0], app::kAllModes, 0.95).interval.lower ==
          Approx(0.4902).epsilon(1e-3)); // 8 of 10: whatever they become, they are walls
}

TEST_CASE("fragility modes: a mode that does not occur has the share 0 with an upper bound",
          "[app][fragility_modes]")
{
    app::StudyWalls walls = scenes::study_walls(10);
    for (app::StudyWall& w : walls.levels[0].walls) w.reading.mode = dem::FailureMode::rocking;
    const app::Table t = app::mode_table(walls);
    CHECK(cell(t, 1, "share [%]").starts_with("0.0 [0.0, 27.8]"));
    CHECK(cell(t, 1, "Clopper-Pearson [%]") == "0.0 to 30.8"); // 1 - 0.025^(1/10)
    const app::Table equal = app::equal_modes_table(walls);
    CHECK(cell(equal, 0, "angle [deg]").empty());
    CHECK(cell(equal, 0, "note") ==
          "The mode mixed does not occur: the data have no such angle.");
    CHECK(cell(equal, 0, "slope [1/deg]").empty());
}

TEST_CASE("fragility modes: the angle of equal modes lies between the modes",
          "[app][fragility_modes]")
{
    const app::Table t = app::equal_modes_table(scenes::study_walls(60));
    CHECK(scenes::sound(t));
    const double angle = number_in(t, 0, "angle [deg]").value;
    CHECK(angle > 28.0);
    CHECK(angle < 36.0);
    CHECK(number_in(t, 0, "slope [1/deg]").value < 0.0);
}

TEST_CASE(
    "fragility modes: angles that tell the modes apart without error keep a finite slope and "
    "say so",
    "[app][fragility_modes]")
{
    app::StudyWalls walls = scenes::study_walls(26);
    for (app::StudyWall& w : walls.levels[0].walls)
        w.reading.mode =
            w.inputs[0] < 32.0 ? dem::FailureMode::mixed : dem::FailureMode::rocking;
    const app::Table t = app::equal_modes_table(walls);
    CHECK(number_in(t, 0, "angle [deg]").value == Approx(31.0).margin(1.0));
    CHECK(cell(t, 0, "note").starts_with("Firth's penalty"));
}

TEST_CASE(
    "fragility modes: a mode that does not depend on the angle has no angle of equal modes",
    "[app][fragility_modes]")
{
    app::StudyWalls walls = scenes::study_walls(26);
    for (app::StudyWall& w : walls.levels[0].walls)
        w.reading.mode =
            w.key.sample % 4 < 2 ? dem::FailureMode::mixed : dem::FailureMode::rocking;
    const app::Table t = app::equal_modes_table(walls);
    CHECK(cell(t, 0, "note") == "Not identifiable: the slope is not significant.");
    CHECK(cell(t, 0, "angle [deg]").empty());
    CHECK(std::isfinite(number_in(t, 0, "slope [1/deg]").value));
    CHECK(cell(t, 0, "angle after Fieller [deg]").empty());
}

TEST_CASE("fragility modes: without a random friction angle the table says so",
          "[app][fragility_modes]")
{
    app::StudyWalls walls = scenes::study_walls(10);
    walls.inputs[0].key = "unit.friction_angle";
    CHECK(cell(app::equal_modes_table(walls), 0, "note") ==
          "joint.friction_angle does not vary in this study.");
}

TEST_CASE(
    "fragility modes: walls whose units spalled, or whose contacts crushed through, are told",
    "[app][fragility_modes]")
{
    app::StudyWalls walls = scenes::study_walls(10);
    for (app::StudyWall& w : walls.levels[0].walls) w.reading.mode = dem::FailureMode::rocking;
    walls.levels[0].walls[3].mechanism.spalled_units = 2;
    walls.levels[0].walls[3].mechanism.crushed_area = 1e-4;
    walls.levels[0].walls[4].mechanism.crushed_area = 1e-4;
    const app::Table t = app::mode_table(walls);
    CHECK(cell(t, 0, "with spalled units") == "1");
    CHECK(cell(t, 0, "with contacts crushed through") == "2");
    CHECK(cell(t, 1, "with contacts crushed through") == "0");
}

TEST_CASE("fragility modes: walls that slid whole count as rocking and are told apart",
          "[app][fragility_modes]")
{
    app::StudyWalls walls = scenes::study_walls(10);
    for (app::StudyWall& w : walls.levels[1].walls) {
        w.reading.dropped = false;
        w.mechanism.cracked_units = 0;
        w.mechanism.rotation_share = 0.1;
        w.reading.mode = dem::FailureMode::rocking;
    }
    walls.levels[1].walls[0].mechanism.cracked_units = 1;    // mixed
    walls.levels[1].walls[1].mechanism.rotation_share = 0.5; // overturns
    const auto slid = [](const app::StudyWall& w, const dem::ModeThresholds& t) {
        return app::slid_whole(w.mechanism, w.reading.dropped, t);
    };
    for (app::StudyWall& w : walls.levels[1].walls) {
        w.reading.slid = slid(w, walls.study.fragility.mode);
        CHECK_FALSE(slid(w, {0.4, 0})); // where sliding makes a wall mixed
    }
    const app::Table t = app::mode_table(walls);
    CHECK(cell(t, 0, "slid without cracking") == "0");
    CHECK(cell(t, 2, "slid without cracking") == "8");
    CHECK(cell(t, 3, "slid without cracking").empty());
    // each of them says which limit of the code it was given
    const app::Table each = app::wall_table(walls, app::all_walls(walls));
    std::size_t slid_walls = 0;
    for (std::size_t r = 0; r < each.rows.size(); ++r) {
        if (!cell(each, r, "note").starts_with("Slid whole, which counts as rocking")) continue;
        ++slid_walls;
        CHECK(cell(each, r, "mode") == "rocking");
        CHECK(cell(each, r, "mode of codes") == "sliding");
    }
    CHECK(slid_walls == 8);
    CHECK(t.caption.find(
              "a stone cracked through and less than 0.5 of the movement is rotation") !=
          std::string::npos);
    walls.study.fragility.mode = {0.4, 0, dem::ModeRule::paper};
    CHECK(app::mode_table(walls).caption.find("80 % of the peak, or less than 0.4") !=
          std::string::npos);
    walls.study.fragility.mode = {0.4, 3, dem::ModeRule::paper};
    CHECK(app::mode_table(walls).caption.find("3 stones cracked through") != std::string::npos);
}

TEST_CASE("fragility modes: thresholds move walls that cracked, not walls whose load fell",
          "[app][fragility_modes]")
{
    app::StudyWalls walls = scenes::study_walls(10);
    for (app::StudyLevel& level : walls.levels)
        for (app::StudyWall& w : level.walls) {
            w.reading.dropped = false;
            w.mechanism.rotation_share = 0.45;
            w.mechanism.cracked_units = 2;
        }
    walls.levels[0].walls[0].reading.dropped = true;
    const app::Table t = app::threshold_table(walls);
    REQUIRE(t.rows.size() == 20);
    CHECK(cell(t, 0, "rotation share") == "0.5");
    CHECK(cell(t, 0, "walls that change their mode [%]") == "0.0");
    for (std::size_t r = 0; r < t.rows.size(); ++r) {
        const bool mixed = std::stod(cell(t, r, "rotation share")) > 0.45 &&
                           std::stoi(cell(t, r, "cracked units")) <= 2;
        CHECK(cell(t, r, "mixed at 0.50 MPa [%]") == (mixed ? "100" : "10"));
        CHECK(cell(t, r, "walls that change their mode [%]") == (mixed ? "0.0" : "95.0"));
    }
}

TEST_CASE("fragility modes: three modes have their shares, their angles and their thresholds",
          "[app][fragility_modes]")
{
    app::StudyWalls walls = scenes::study_walls(20);
    walls.study.fragility.mode.modes = dem::ModeRule::mechanism;
    for (app::StudyLevel& level : walls.levels)
        for (app::StudyWall& w : level.walls) {
            w.reading.dropped = false;
            w.mechanism.rotation_share = w.key.sample % 4 == 0 ? 0.1 : 0.9;
            w.mechanism.cracked_units = 0;
            w.reading.mode = dem::failure_mode(w.mechanism, false);
        }
    const app::Table shares = app::mode_table(walls);
    REQUIRE(shares.rows.size() == 6);
    CHECK(cell(shares, 1, "mode") == "sliding");
    CHECK(cell(shares, 1, "share [%]").starts_with("25.0"));
    CHECK(cell(shares, 0, "slid without cracking").empty());
    CHECK(cell(shares, 2, "share [%]").starts_with("0.0"));
    const app::Table equal = app::equal_modes_table(walls);
    CHECK(cell(equal, 0, "other mode") == "sliding");
    CHECK(cell(equal, 0, "n") == "20");
    CHECK(cell(equal, 1, "note") ==
          "The mode mixed does not occur: the data have no such angle.");
    const app::Table t = app::threshold_table(walls);
    CHECK(cell(t, 0, "sliding at 0.50 MPa [%]") == "25");
    CHECK(cell(t, 0, "mixed at 0.50 MPa [%]") == "0");
    CHECK(scenes::sound(t));
}
