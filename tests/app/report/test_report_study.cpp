#include "app/input/prepared_study.hpp"
#include "app/input/study_reading.hpp"
#include "app/report/report_choice.hpp"
#include "app/report/report_data.hpp"
#include "app/report/report_replay.hpp"
#include "app/study/answers/solver_error.hpp"
#include "app/study/stored/study_identity.hpp"
#include "dem/block/model.hpp"
#include "fragility/fits/share.hpp"
#include "scenes/temporary_folder.hpp"
#include "tests/app/report/report_scene.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <string>
#include <vector>

TEST_CASE("report configuration: the stored study file reads back to the study that wrote it",
          "[app][report_study]")
{
    const app::Study study = study_scenes::study("samples = 5");
    const std::string text = app::effective_configuration(study);
    CHECK(app::identity_text(
              app::prepare(app::read_study(app::parse_study_text("s", text))).study) ==
          app::identity_text(study));
}

TEST_CASE("report configuration: values that follow from drawn ones still follow them",
          "[app][report_study]")
{
    const app::Study study = study_scenes::study("samples = 5");
    const app::Study back =
        app::prepare(
            app::read_study(app::parse_study_text("s", app::effective_configuration(study))))
            .study;
    const dem::Layout layout = app::model_of(app::prepare(study)).layout;
    app::WallDraw draw;
    for (const app::RandomInput& input : study.random)
        draw.values.push_back({0.8 * input.mean});
    const auto a = app::wall_materials(study, study.random, app::stress_level(study.load, 1),
                                       layout, draw);
    const auto b =
        app::wall_materials(back, back.random, app::stress_level(back.load, 1), layout, draw);
    CHECK(a.cracks.front().cohesion == b.cracks.front().cohesion);
    CHECK(a.cracks.front().tan_phi == b.cracks.front().tan_phi);
    CHECK(a.joints.front().ks == b.joints.front().ks);
}

TEST_CASE("report replay: stored walls pushed again are those stored, to the bit",
          "[app][report_study]")
{
    const scenes::TemporaryFolder folder;
    const auto file = folder.path / "small.h5";
    scenes::run_study(file, GENERATE("samples = 3", "samples = 2\nspatial = independent"));
    app::StudyWalls study = app::read_study_walls(file, {}, app::Keep::everything);
    REQUIRE(study.inputs.size() == 5);
    const app::WallList walls = app::walls_to_list(study, 100);
    const app::Replay r = app::replay(app::prepare(study.study), walls, 2, {}, {});
    CHECK(r.different == 0);
    REQUIRE(r.films.size() == walls.size());
    CHECK(r.films.front().frames == app::kFilmFrames + 1);
    study.levels.front().walls.front().curve.force.back() *= 1.0 + 1e-15;
    dem::FailureMode& mode = study.levels.back().walls.back().reading.mode;
    mode =
        mode == dem::FailureMode::mixed ? dem::FailureMode::rocking : dem::FailureMode::mixed;
    CHECK(app::replay(app::prepare(study.study), walls, 2, {}, {}).different == 2);
}

TEST_CASE(
    "report replay: walls filmed while the study ran are not pushed again, and their films "
    "are the same to the bit",
    "[app][report_study]")
{
    const scenes::TemporaryFolder folder;
    const auto file = folder.path / "small.h5", bare = folder.path / "bare.h5";
    app::FilmShelf all, one;
    scenes::run_study(file, "samples = 3", "",
                      [&](app::WallKey key, dem::FailureMode mode, auto frames) {
                          all.put(key, mode, frames);
                          if (key == app::WallKey{1, 2}) one.put(key, mode, frames);
                      });
    scenes::run_study(bare, "samples = 3");
    const auto read = [](const auto& path) {
        return app::read_study_walls(path, {}, app::Keep::everything);
    };
    const app::StudyWalls study = read(file), unfilmed = read(bare);
    const app::WallList walls = app::walls_to_list(study, 100),
                        others = app::walls_to_list(unfilmed, 100);
    const app::Replay pushed = app::replay(app::prepare(study.study), walls, 2, {}, {}),
                      kept = app::replay(app::prepare(study.study), walls, 2, all, {}),
                      mixed = app::replay(app::prepare(study.study), walls, 2, one, {});
    CHECK(pushed.pushed == 6);
    CHECK(kept.pushed == 0);
    CHECK(mixed.pushed == 5);
    REQUIRE(walls.size() == others.size());
    for (std::size_t i = 0; i < walls.size(); ++i) {
        CHECK(walls[i]->curve.force == others[i]->curve.force);
        CHECK(kept.films[i].data == pushed.films[i].data);
        CHECK(mixed.films[i].data == pushed.films[i].data);
    }
}

TEST_CASE("report data: failed walls are named with their reason, and in no mean",
          "[app][report_study]")
{
    const scenes::TemporaryFolder folder;
    const auto file = folder.path / "small.h5";
    scenes::run_study(file, "samples = 6", "</script> the numbers broke");
    const app::StudyWalls study = app::read_study_walls(file, {}, app::Keep::everything);
    const auto data = app::report_data(study, app::walls_to_list(study, 100));
    const std::string sure = data["overview"]["sure"].dump();
    CHECK(sure.find("1 wall failed: </script> the numbers broke (1.00 MPa sample 5)") !=
          std::string::npos);
    CHECK(data["overview"]["run"][0].get<std::string>().starts_with(
        "12 walls under 2 vertical stresses from 0.50 MPa to 1.00 MPa: a wall of 0.60 m"));
    CHECK(data["overview"]["solver"] == app::solver_error_text(study));
    CHECK(data["overview"]["solver"].get<std::string>().find(
              "of 11 walls above the 1 % asked for") != std::string::npos);
    CHECK(data["tables"]["solver_error"]["rows"].size() == 2);
    CHECK(data["walls"].back()["mode"] == "failed");
    CHECK(data["walls"].back()["peak_force_kN"].is_null());
    CHECK(data["modes"]["levels"][1]["walls"] == 5);
    const auto& share = data["modes"]["levels"][1]; // wider than without the failed wall
    const auto five = fragility::share(5.0 * share["value"].get<double>(), 5.0, 0.0);
    CHECK(share["upper"].get<double>() - share["lower"].get<double>() >
          five.interval.upper - five.interval.lower + 0.05);
    CHECK(data["tables"]["results"]["rows"][0][1] == "6");
    CHECK(data["tables"]["results"]["rows"][1][2] == "1");
    for (const auto& bar : data["sensitivity"][0]["bars"]) // 6 walls for 5 inputs
        CHECK_FALSE(bar.contains("prcc"));
}

TEST_CASE("report data: a study without a wall, and inputs without a distribution, give a page",
          "[app][report_study]")
{
    const scenes::TemporaryFolder folder;
    const auto file = folder.path / "small.h5";
    scenes::run_study(file, "samples = 1");
    app::StudyWalls study = app::read_study_walls(file, {}, app::Keep::everything);
    for (app::StoredInput& input : study.inputs) input.marginal.reset();
    const app::WallList listed = app::walls_to_list(study, 100);
    const auto data = app::report_data(study, listed);
    CHECK(data["running"].empty());
    CHECK(app::films_json(app::prepare(study.study), listed, {}, "note")["films"].empty());
    for (app::StudyLevel& level : study.levels) level.walls.clear();
    CHECK_NOTHROW(app::report_data(study, {}));
}
