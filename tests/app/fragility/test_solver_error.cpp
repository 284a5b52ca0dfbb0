/// The error by the speed of the solver, from the walls to remarks, tables and bounds.

#include "app/fragility/fragility_command.hpp"
#include "app/fragility/fragility_walls.hpp"
#include "app/fragility/numbers/fragility_data.hpp"
#include "app/fragility/numbers/fragility_limits.hpp"
#include "app/fragility/solver_error_table.hpp"
#include "app/study/answers/solver_error.hpp"
#include "app/study/study_summary.hpp"
#include "tests/app/fragility/fragility_scenes.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <string>
#include <vector>

using Catch::Contains;

namespace {

/// Wall i of each level has an error of (i + 1) / 1000.
app::StudyWalls with_errors(std::size_t n)
{
    app::StudyWalls walls = scenes::study_walls(n);
    for (std::uint32_t l = 0; l < walls.levels.size(); ++l)
        for (std::size_t i = 0; i < n; ++i) {
            app::StudyWall& w = walls.levels[l].walls[i];
            w.key.level = l;
            w.solver_error = 1e-3 * static_cast<double>(i + 1);
        }
    return walls;
}

/// The first `n` walls of each level were pushed again: their force is lower by 1 %, and they
/// fell 2 % earlier.
void add_audit(app::StudyWalls& walls, std::size_t n)
{
    walls.head.levels = {{0.5e6, 50}, {1e6, 50}, {0.5e6, 8, 4}, {1e6, 8, 4}};
    for (app::StudyLevel& level : walls.levels)
        for (std::size_t i = 0; i < n; ++i) {
            level.audit.push_back(level.walls[i]);
            level.audit.back().reading.peak->force /= 1.01;
            level.audit.back().reading.ultimate.displacement /= 1.02;
        }
}

} // namespace

TEST_CASE("solver error: median, 95 % and the walls above the accuracy are said and named",
          "[app][solver_error]")
{
    app::StudyWalls walls = with_errors(25); // 0.1 to 2.5 %
    CHECK(app::solver_error_text(walls) ==
          "Solver error: median 1.3 %, 95 % of walls below 2.4 %, 30 of 50 walls above the 1 % "
          "asked for (0.50 MPa sample 10, 0.50 MPa sample 11, 0.50 MPa sample 12, 0.50 MPa "
          "sample 13, 0.50 MPa sample 14, ...).");
    walls.study.solver.accuracy = 0.024;
    CHECK_THAT(app::solver_error_text(walls),
               Contains("2 of 50 walls above the 2.4 % asked for (0.50 MPa sample 24, 1.00 MPa "
                        "sample 24)."));
    walls.study.solver.accuracy = 0.03;
    CHECK_THAT(app::solver_error_text(walls), Contains(", none of 50 walls above the 3 %"));
    CHECK_THAT(app::study_remarks(walls), Contains("Solver error: median 1.3 %"));
    CHECK_THAT(app::solver_error_text(with_errors(3)), // of six walls none is 5 %
               Contains("median 0.2 %, at most 0.3 %, none of 6 walls"));
}

TEST_CASE("solver error: walls with too few contact points are said and named, in no bracket",
          "[app][solver_error]")
{
    app::StudyWalls walls = with_errors(25);
    walls.study.solver.accuracy = 0.03;
    const app::Table without = app::solver_error_table(walls);
    CHECK(scenes::cell(without, 0, "contact points, 95 % below [%]").empty());
    CHECK_THAT(app::solver_error_text(walls), !Contains("contact"));
    for (app::StudyLevel& level : walls.levels)
        for (app::StudyWall& w : level.walls) w.points_error = 0.002;
    CHECK_THAT(
        app::solver_error_text(walls),
        Contains(" 3 % asked for. Error by the number of contact points: median 0.2 %, "
                 "95 % of walls below 0.2 %, none of 50 walls above the 3 % asked for."));
    walls.levels[1].walls[4].points_error = 0.04;
    CHECK_THAT(app::solver_error_text(walls),
               Contains(", 1 of 50 walls above the 3 % asked for (1.00 MPa sample 4). A larger "
                        "solver.contact_points lessens it."));
    const app::Table t = app::solver_error_table(walls);
    CHECK(scenes::sound(t));
    CHECK(scenes::number_in(t, 1, "contact points, median [%]").value == Approx(0.2));
    CHECK(scenes::cell(t, 1, "note") == "Too few contact points: 1.00 MPa sample 4.");
    CHECK(scenes::cell(t, 1, "mean peak force [kN]") ==
          scenes::cell(without, 1, "mean peak force [kN]"));
    const app::Table all = app::wall_table(walls, app::all_walls(walls));
    CHECK(scenes::cell(all, 29, "points error [%]") == "4.00");
}

TEST_CASE("solver error: walls of a file without it are not known, not exact",
          "[app][solver_error]")
{
    app::StudyWalls walls = scenes::study_walls(4);
    CHECK(app::solver_error_text(walls) ==
          "Solver error: not known, because the walls were pushed by an earlier version of the "
          "program.");
    const app::Table t = app::summarise(walls).table;
    CHECK(scenes::cell(t, 0, "solver error [%]").empty());
    CHECK(scenes::cell(t, 0, "inaccurate").empty());
    CHECK(scenes::cell(app::wall_table(walls, app::all_walls(walls)), 0, "solver error [%]")
              .empty());
    walls.levels[0].walls[1].solver_error = 0.0;
    CHECK_THAT(app::solver_error_text(walls),
               Contains("median 0 %, at most 0 %, none of 8 walls") &&
                   Contains(", not known of 7."));
}

TEST_CASE("solver error: the tables have it for each stress and wall", "[app][solver_error]")
{
    const app::StudyWalls walls = with_errors(25);
    const app::Table summary = app::summarise(walls).table;
    CHECK(scenes::number_in(summary, 1, "solver error [%]").value == Approx(1.3));
    CHECK(scenes::number_in(summary, 1, "solver error of 95 % [%]").value == Approx(2.38));
    CHECK(scenes::cell(summary, 1, "inaccurate") == "15");
    const app::Table all = app::wall_table(walls, app::all_walls(walls));
    CHECK(scenes::cell(all, 2, "solver error [%]") == "0.30");
    const app::Table t = app::solver_error_table(walls);
    REQUIRE(t.rows.size() == 2);
    CHECK(scenes::sound(t));
    CHECK(scenes::cell(t, 0, "asked for [%]") == "1.00");
    CHECK(scenes::cell(t, 0, "inaccurate") == "15");
    CHECK_THAT(scenes::cell(t, 0, "note"), Contains("Inaccurate: 0.50 MPa sample 10, "));
    // Errors of 1.1 to 2.5 % widen the bounds of the mean on both sides.
    const app::Number mean = scenes::number_in(t, 0, "mean peak force [kN]");
    const double sampling = scenes::number_in(t, 0, "sampling [%]").value;
    const double half = 0.5 * (mean.upper - mean.lower) / mean.value;
    CHECK(half > 0.01 * sampling + 0.008);
    CHECK(half < 0.01 * sampling + 0.015);
    const double solver = scenes::number_in(t, 0, "solver [%]").value;
    CHECK(solver > 1.2);
    CHECK(solver < 1.4);
}

TEST_CASE("solver error: an audit gives the differences of the walls that were pushed again",
          "[app][solver_error]")
{
    app::StudyWalls walls = with_errors(25);
    add_audit(walls, 8);
    app::StudyLevel& low = walls.levels[0];
    low.audit[0].failed = true;
    low.audit[1].reading.ultimate.reading = fragility::Reading::censored;
    low.audit[2].reading.mode = dem::FailureMode::sliding;
    walls.levels[1].audit_missing = 2;
    std::size_t fell = 0;
    for (const app::StudyLevel& level : walls.levels)
        for (std::size_t i = &level == &low ? 2 : 0; i < 8; ++i)
            fell += is_observed(level.walls[i].reading.ultimate) ? 1 : 0;
    CHECK_THAT(
        app::solver_error_text(walls),
        Contains(" Solver error of this study, 15 of 50 walls pushed again 4 times "
                 "slower: median 1 %, at most 1 % in peaks, at most 2 % in the "
                 "displacement at 80 % of the peak (" +
                 std::to_string(fell) +
                 "); the force of 1 wall came down in one of the two pushes only; 1 wall "
                 "failed in another mode; 1 gave no result in one of both; 2 still to "
                 "run."));
    const app::Table t = app::solver_error_table(walls);
    CHECK(scenes::cell(t, 0, "audit") == "7");
    CHECK(scenes::number_in(t, 0, "peak, median [%]").value == Approx(1.0));
    CHECK(scenes::number_in(t, 1, "ultimate, 95 % below [%]").value == Approx(2.0));
    CHECK(scenes::sound(t));
}

TEST_CASE("solver error: bounds of drifts hold wherever those of inaccurate walls lie",
          "[app][solver_error]")
{
    const std::vector<double> drifts = {1.0, 1.2, 1.5, 2.0, 2.2, -2.5};
    app::DriftData data = scenes::drifts({drifts});
    data.options.bootstrap = 0;
    const auto median = [&] {
        return scenes::number_in(app::performance_table(data), 0, "median drift [%]");
    };
    const auto interval_of = [&](double factor) { // were all of them exact
        std::vector<double> moved = drifts;
        for (double& d : moved) d *= factor;
        app::DriftData other = scenes::drifts({moved});
        other.options.bootstrap = 0;
        return scenes::number_in(app::performance_table(other), 0, "median drift [%]");
    };
    const app::Number exact = median();
    for (app::DriftWall& w : data.groups[0].walls) w.least = 0.9, w.most = 1.1;
    const app::Number wide = median();
    CHECK(wide.value == exact.value);
    CHECK(wide.lower == Approx(interval_of(0.9).lower).epsilon(1e-9));
    CHECK(wide.upper == Approx(interval_of(1.1).upper).epsilon(1e-9));
    CHECK_THAT(scenes::cell(app::performance_table(data), 0, "note"),
               Contains("6 walls miss the accuracy asked of the solver"));
    for (app::DriftWall& w : data.groups[0].walls)
        w.least = 0.0, w.most = 3.0; // nothing is known
    CHECK(median().lower == 0.0);
    CHECK(std::isinf(median().upper));
    for (app::DriftWall& w : data.groups[0].walls) w.limits[0]->capped = true; // set, not found
    CHECK(app::inaccurate_walls(data.groups[0], 0) == 0);
}

TEST_CASE("solver error: only walls that miss the accuracy move bounds", "[app][solver_error]")
{
    app::StudyWalls walls = with_errors(12); // 0.1 to 1.2 %
    CHECK(app::inaccurate_walls(app::drift_data(walls).groups[0], 0) == 2);
    walls.study.solver.accuracy = 0.05;
    CHECK(app::inaccurate_walls(app::drift_data(walls).groups[0], 0) == 0);
}

TEST_CASE("solver error: a fall that the force touches opens the bounds of its drift",
          "[app][solver_error]")
{
    app::StudyWalls walls = with_errors(12);
    app::StudyWall& wall = walls.levels[0].walls[11]; // 1.2 %
    fragility::DropRange& range = wall.reading.ultimate_range;
    wall.reading.ultimate = {0.02, fragility::Reading::observed, {}};
    range = {{0.018, fragility::Reading::observed, {}},
             {0.05, fragility::Reading::observed, {}}};
    const auto drift_wall = [&] { return app::drift_data(walls).groups[0].walls[11]; };
    CHECK(drift_wall().least == Approx(0.9));
    CHECK(drift_wall().most == Approx(2.5));
    CHECK_THAT(app::solver_error_text(walls),
               Contains(" It leaves an error in the displacement at 80 % of the peak: median "
                        "150 %, at most 150 %."));
    range.latest.reading = fragility::Reading::censored;
    CHECK(std::isinf(drift_wall().most));
    CHECK_THAT(app::solver_error_text(walls),
               Contains("at most 150 %; the range of 1 wall goes on beyond the end of "
                        "the push."));
    range = {{0.0199, fragility::Reading::observed, {}},
             {0.0201, fragility::Reading::observed, {}}};
    CHECK(drift_wall().least == Approx(1.0 - 0.012)); // the force is wrong by more
    CHECK(drift_wall().most == Approx(1.0 + 0.012));
    range.latest = {0.05, fragility::Reading::censored, {}};
    const auto ends = app::limits_at(app::drift_data(walls).groups[0], 0, app::ErrorEnd::most);
    CHECK(std::isinf(ends[11].upper));
    CHECK(std::isfinite(ends[11].lower));
}
