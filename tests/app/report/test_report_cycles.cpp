#include "app/input/prepared_study.hpp"
#include "app/report/report_parts.hpp"

#include "app/report/report_data.hpp"
#include "app/report/report_replay.hpp"
#include "app/study/pushed/wall_frames.hpp"
#include "dem/block/model.hpp"
#include "dem/solver/push.hpp"
#include "scenes/temporary_folder.hpp"
#include "tests/app/report/report_scene.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <vector>

TEST_CASE(
    "report cycles: a study to and fro has backbones, loops, damping and films through its "
    "cycles, replayed to the bit",
    "[app][report_cycles]")
{
    const scenes::TemporaryFolder folder;
    const auto file = folder.path / "small.h5";
    scenes::run_study(file, "samples = 2\n[load]\namplitudes = 1, 2 mm");
    const app::StudyWalls study = app::read_study_walls(file, {}, app::Keep::everything);
    REQUIRE_FALSE(study.pushed_one_way);
    const app::WallList walls = app::walls_to_list(study, 100);
    const auto loops = app::loops_json(study, walls);
    const int frames = app::film_frames(study.study.load);
    CHECK(frames == app::kFilmFrames); // five ways
    CHECK(loops["points"] == frames * app::kLoopPoints + 1);
    REQUIRE(loops["counts"].size() == walls.size());
    CHECK(loops["counts"][0].get<int>() > frames * app::kLoopPoints - 4);
    const auto damping = app::damping_json(study);
    REQUIRE_FALSE(damping.empty());
    CHECK(damping[0]["mode"] == "all");
    CHECK(damping[0]["drift"].size() == 2);
    CHECK(walls.front()->forces.size() > 100); // the backbone
    CHECK(walls.front()->forces.back() > 0.0);
    const auto data = app::report_data(study, walls);
    CHECK_FALSE(data["tables"]["cycles"]["rows"].empty());
    const app::Replay r = app::replay(app::prepare(study.study), walls, 2, {}, {});
    CHECK(r.different == 0);
    CHECK(r.films.front().frames == frames + 1);
}

TEST_CASE("report cycles: a film goes through every cycle, to both sides and back",
          "[app][report_cycles]")
{
    const scenes::TemporaryFolder folder;
    const auto file = folder.path / "small.h5";
    scenes::run_study(file, "samples = 1\n[load]\namplitudes = 1, 2 mm");
    const app::Study study = app::read_study_walls(file).study;
    const dem::Model model = app::model_of(app::prepare(study));
    const auto frames =
        app::frames_of(dem::push(model,
                                 app::materials(study.parameters, study.wall.course_height,
                                                app::stress_level(study.load, 0), model.layout),
                                 app::filmed(app::push_plan(study), study.load), study.solver));
    CHECK(static_cast<int>(frames.size()) == app::film_frames(study.load) + 1);
    std::vector<double> turns = {0.0}; // displacements where it turns back
    for (std::size_t i = 1; i + 1 < frames.size(); ++i) {
        const double before = frames[i].displacement - frames[i - 1].displacement,
                     after = frames[i + 1].displacement - frames[i].displacement;
        if (before * after < 0.0) turns.push_back(frames[i].displacement);
    }
    turns.push_back(frames.back().displacement);
    const std::vector<double> visited = {0.0, 1e-3, -1e-3, 2e-3, -2e-3, 0.0};
    REQUIRE(turns.size() == visited.size());
    for (std::size_t i = 0; i < turns.size(); ++i)
        CHECK(turns[i] == Approx(visited[i]).margin(1.01 * app::film_step(study.load)));
}

TEST_CASE("report cycles: a push one way has no loops", "[app][report_cycles]")
{
    app::StudyWalls study;
    CHECK(app::loops_json(study, {}).is_null());
    CHECK(app::damping_json(study).empty());
}
