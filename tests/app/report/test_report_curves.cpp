#include "app/report/report_parts.hpp"
#include "app/wall_scenes.hpp"
#include "fragility/curve/resampled_curve.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <cmath>
#include <vector>

namespace {

constexpr double kStep = 0.03 / static_cast<double>(app::kCurveSteps); // of the grid [m]

app::StudyWall straight_wall(double stiffness, double last)
{
    app::StudyWall w =
        scenes::read_wall({0, 0}, stiffness * last, last, true, dem::FailureMode::rocking);
    for (const double d : {0.0, 0.25 * last, last}) {
        w.curve.displacement.push_back(d);
        w.curve.force.push_back(stiffness * d);
    }
    w.forces = fragility::resampled({w.curve.displacement, w.curve.force}, kStep,
                                    app::kCurveSteps + 1);
    return w;
}

} // namespace

TEST_CASE(
    "report curves: the mean of straight curves is the straight line of their mean, within "
    "its interval",
    "[app][report_curves]")
{
    app::StudyWalls study;
    study.step = kStep;
    study.levels = {scenes::level(1e6)};
    for (const double k : {1e6, 2e6, 6e6})
        study.levels[0].walls.push_back(straight_wall(k, 0.03));
    const auto means = app::mean_curves_json(study);
    REQUIRE(means.size() == 2); // all, rocking
    CHECK(means[0]["mode"] == "all");
    CHECK(means[1]["mode"] == "rocking");
    CHECK(means[0]["mean"].size() == app::kCurveSteps + 1);
    CHECK(means[0]["mean"].back().get<double>() == Approx(90.0).epsilon(1e-5)); // kN
    // Student, 2 degrees of freedom: 4.3027; s / sqrt(3) = 45.826
    CHECK(means[0]["upper"].back().get<double>() ==
          Approx(90.0 + 4.3027 * 45.826).epsilon(1e-4));
}

TEST_CASE("report curves: a mean ends where less than nine tenths of its walls go on",
          "[app][report_curves]")
{
    app::StudyWalls study;
    study.step = kStep;
    study.levels = {scenes::level(1e6)};
    for (int i = 0; i < 20; ++i)
        study.levels[0].walls.push_back(straight_wall(1e6, i < 2 ? 0.01 : i < 3 ? 0.02 : 0.03));
    const auto means = app::mean_curves_json(study);
    const double step = means[0]["step"];
    const auto points = static_cast<double>(means[0]["mean"].size());
    CHECK((points - 1.0) * step == Approx(0.02)); // two of twenty may end, the third not
}

TEST_CASE("report curves: failed walls are in no mean", "[app][report_curves]")
{
    app::StudyWalls study;
    study.step = kStep;
    study.levels = {scenes::level(1e6)};
    for (const double k : {1e6, 2e6, 6e6})
        study.levels[0].walls.push_back(straight_wall(k, 0.03));
    study.levels[0].failed_walls = {study.levels[0].walls.back()};
    study.levels[0].walls.pop_back();
    CHECK(app::mean_curves_json(study)[0]["walls"] == 2);
    CHECK(app::mean_curves_json(study)[0]["mean"].back().get<double>() == Approx(45.0));
}
