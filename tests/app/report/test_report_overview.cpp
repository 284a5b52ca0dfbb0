#include "app/fragility/numbers/answer_table.hpp"
#include "app/fragility/numbers/model_doubt.hpp"
#include "app/input/keys/limit_state_text.hpp"
#include "app/report/report_parts.hpp"
#include "app/study_scenes.hpp"
#include "app/text/number_text.hpp"
#include "app/wall_scenes.hpp"
#include "tests/app/fragility/fragility_scenes.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

namespace {

app::StudyWalls two_stresses(std::uint32_t samples)
{
    app::StudyWalls study;
    study.study = study_scenes::study("samples = 1");
    study.levels = {scenes::level(1e6), scenes::level(5e5)};
    for (std::uint32_t i = 0; i < samples; ++i) {
        study.levels[0].walls.push_back(
            scenes::read_wall({0, i}, 80e3, 0.005 + 0.002 * i, i % 2 == 0));
        study.levels[1].walls.push_back(
            scenes::read_wall({1, i}, 40e3, 0.03, true, dem::FailureMode::rocking));
    }
    return study;
}

/// A study whose only limit state is the ultimate displacement.
app::StudyWalls one_stress()
{
    app::StudyWalls study;
    study.study = study_scenes::study("samples = 1\n[fragility]\nlimit_states = paper");
    study.rules = app::reading_rules(study.study);
    study.states = app::state_names(study.rules);
    study.levels = {scenes::level(1e6)};
    return study;
}

} // namespace

TEST_CASE("report overview: the lowest and the highest stress are set side by side, in words",
          "[app][report_overview]")
{
    const app::Overview six = app::overview(two_stresses(6));
    REQUIRE(six.found.size() == 3);
    CHECK(
        six.found[2].starts_with("How a wall failed: Rocking: at least 0.5 of the movement is "
                                 "rotation of the beam, whatever cracked. Otherwise mixed: a "
                                 "stone cracked through. "));
    CHECK(
        six.lead ==
        "From 0.50 MPa to 1.00 MPa, the mean peak force goes from 40.0 to 80.0 kN, "
        "the share of walls that rocked goes from 100 to 0 %, and the share that lost 20 % of "
        "their peak force before the push ended goes from 0 to 50 %.");
    const app::Overview four = app::overview(two_stresses(4)); // shares of four say nothing
    CHECK(four.lead == four.found.front());
    app::StudyWalls one = two_stresses(4);
    one.levels.pop_back();
    const app::Overview o = app::overview(one); // what the lead says is not said again
    CHECK(o.lead.starts_with("1.00 MPa: mean peak force 80.0 kN"));
    CHECK(o.found.front().starts_with("How a wall failed: "));
}

TEST_CASE("report overview: walls that still stood are told once", "[app][report_overview]")
{
    app::StudyWalls study = two_stresses(4);
    for (const dem::Kinematics k : {dem::Kinematics::small, dem::Kinematics::finite}) {
        study.study.solver.kinematics = k;
        const auto sure = app::overview(study).sure;
        CHECK(std::ranges::count_if(sure, [](const std::string& s) {
                  return s.find("still carried more than 80 % of the peak") !=
                         std::string::npos;
              }) == 1);
    }
}

TEST_CASE("report answers: drift limits of one further wall, codes' caps in words",
          "[app][report_overview][answer_table]")
{
    app::StudyWalls study = one_stress();
    study.height = 1.0;
    study.study.fragility.model_factor = "lognormal(median 1, sigma_log 0.4)";
    const auto row = [&] {
        return app::answers_json(study, app::drift_data(study))["rows"][0]
            .get<std::vector<std::string>>();
    };
    auto& walls = study.levels[0].walls;
    for (std::uint32_t i = 0; i < 9; ++i) // 1.0, 1.1, ... 1.8 %
        walls.push_back(scenes::read_wall({0, i}, 80e3, 0.010 + 0.001 * i, false));
    REQUIRE(row().size() == 5);
    CHECK(row()[0] == "1");
    CHECK(row()[1].starts_with("80.0"));
    CHECK(row()[2] == "mixed");
    // ln drift: sd 0.189, its mean 0.189 / 3 = 0.063, model 0.4: in all 0.447
    CHECK(row()[3] == "1.38 (0.88 to 2.15)"); // 1.376 exp(-+ 0.9945 0.447)
    CHECK(row()[4] ==
          "only 9 walls; factor 1.6 either way: model 0.40, material 0.19, sampling 0.06");
    const auto limit = [](app::StudyWall& w, double at) {
        w.reading.limits[0] = {at, fragility::Reading::observed,
                               "governed by the code's drift limit"};
    };
    for (app::StudyWall& w : walls) limit(w, 0.01);
    CHECK(row()[3] == "cap of the code (1.00 %): 100 % of walls");
    CHECK(row()[4] == "only 9 walls");
    for (std::size_t i = 0; i < 3; ++i) limit(walls[i], 0.005);
    CHECK(row()[3] == "cap of the code (0.500 %): 33.3 % of walls, (1.00 %): 66.7 % of walls");
    for (std::size_t i = 0; i < 5; ++i)
        walls[i].reading.limits[0] = {0.0272, fragility::Reading::censored, {}};
    // 4 of 9 fell there: the lower end of the interval
    CHECK(row()[3] == "> 1.00; cap of the code (1.00 %): 44.4 % of walls");
    CHECK(row()[4] == "only 9 walls; 5 of 9 walls stood to the end of the push");
    walls[0].reading.mode = dem::FailureMode::rocking;
    CHECK(row()[2] == "mixed 89 %, rocking 11 %");
}

TEST_CASE("answer table: beyond the drift tested there is a bound", "[app][answer_table]")
{
    app::StudyWalls study = one_stress();
    study.height = 1.0;
    study.study.fragility.model_factor = "none";
    auto& walls = study.levels[0].walls;
    for (std::uint32_t i = 0; i < 20; ++i) // 2 fell, 18 stood at 2.72 %
        walls.push_back(scenes::read_wall({0, i}, 80e3, 0.020, false));
    for (std::size_t i = 2; i < 20; ++i)
        walls[i].reading.limits[0] = {0.0272, fragility::Reading::censored, {}};
    study.levels[0].missing = 3;
    const app::Table t = app::answer_table(study, app::drift_data(study));
    CHECK(scenes::cell(t, 0, "paper ultimate drift [%]") == "> 2.72");
    CHECK(scenes::cell(t, 0, "how sure") ==
          "18 of 20 walls stood to the end of the push; 3 walls not run");
}

TEST_CASE("answer table: a drift that hangs on what lies beyond stands between its bounds",
          "[app][answer_table][model_doubt]")
{
    app::StudyWalls study = one_stress();
    study.height = 1.0;
    study.study.fragility.model_factor = "lognormal(median 1, sigma_log 0.4)";
    auto& walls = study.levels[0].walls;
    for (std::uint32_t i = 0; i < 20; ++i) // 16 fell at 1.00, 1.05, ... %, 4 stood at 2.72 %
        walls.push_back(scenes::read_wall({0, i}, 80e3, 0.010 + 0.0005 * i, false));
    for (std::size_t i = 16; i < 20; ++i)
        walls[i].reading.limits[0] = {0.0272, fragility::Reading::censored, {}};
    const app::DriftData data = app::drift_data(study);
    const auto limit = app::doubted_limit(data, 0, 0);
    REQUIRE(limit);
    const auto& median = limit->quantiles[1];
    REQUIRE(std::isfinite(median.upper));
    REQUIRE(median.upper > median.lower + 0.01);
    const std::string cell =
        scenes::cell(app::answer_table(study, data), 0, "paper ultimate drift [%]");
    CHECK(cell.starts_with(app::fixed(median.lower, 2) + "–" + app::fixed(median.upper, 2)));
    const app::Table table = app::drift_doubt_table(data);
    CHECK(scenes::cell(table, 0, "median drift [%]") ==
          app::fixed(median.lower, 2) + " to " + app::fixed(median.upper, 2));
}

TEST_CASE("report overview: walls that slid whole are counted apart", "[app][report_overview]")
{
    app::StudyWalls study = two_stresses(6);
    CHECK(app::overview(study).found[1].find("slid") == std::string::npos);
    study.levels[1].walls.back().reading.slid = true;
    CHECK(app::overview(study).found[1].find(
              "100 % rocked [61, 100], counting 1 that slid whole;") != std::string::npos);
}

TEST_CASE("report overview: of walls without ultimate displacement no fall is spoken of",
          "[app][report_overview]")
{
    app::StudyWalls study = two_stresses(4);
    CHECK(app::overview(study).found[0].find("lost 20 %") != std::string::npos);
    for (app::StudyLevel& level : study.levels)
        for (app::StudyWall& w : level.walls) w.reading.ultimate = {};
    CHECK(app::overview(study).found[0].find("lost 20 %") == std::string::npos);
}

TEST_CASE("report fragility: neither curve nor band falls with the drift",
          "[app][report_fragility]")
{
    app::StudyWalls study = one_stress();
    for (std::uint32_t i = 0; i < 12; ++i) // few and scattered: the band is widest near zero
        study.levels[0].walls.push_back(
            scenes::read_wall({0, i}, 80e3, i < 7 ? 0.004 * std::pow(1.4, i) : 0.03, i >= 7));
    const auto curve = app::fragility_json(app::drift_data(study))[0]["curves"][0];
    REQUIRE(curve["fitted"] == true);
    for (const char* const line : {"least", "lower", "upper"}) {
        const auto p = curve[line].get<std::vector<double>>();
        for (std::size_t i = 1; i < p.size(); ++i) CHECK(p[i] >= p[i - 1]);
    }
}

TEST_CASE("report fragility: the band does not leap where the first of the runs ends",
          "[app][report_fragility]")
{
    app::StudyWalls study = one_stress();
    study.height = 1.1;
    for (std::uint32_t i = 0; i < 24; ++i) { // a dozen fall, a dozen rock to the end of the run
        const bool rocks = i >= 12;
        study.levels[0].walls.push_back(
            scenes::read_wall({0, i}, 80e3, rocks ? 0.03 - 1e-7 * i : 0.01 + 1e-3 * i, rocks,
                              rocks ? dem::FailureMode::rocking : dem::FailureMode::mixed));
    }
    const auto upper = app::fragility_json(app::drift_data(study))[0]["curves"][0]["upper"]
                           .get<std::vector<double>>();
    REQUIRE(upper.size() > 2);
    const std::size_t last = upper.size() - 1;
    CHECK(upper[last] - upper[last - 1] < 0.02);
}
