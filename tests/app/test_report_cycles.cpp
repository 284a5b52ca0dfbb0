#include "app/report/report_cycles.hpp"

#include "app/report/report_data.hpp"
#include "app/report/report_replay.hpp"
#include "app/report_scene.hpp"
#include "app/study/wall_frames.hpp"
#include "scenes/temporary_folder.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

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
    const int frames = app::film_frames(study.study);
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
    const app::Replay r = app::replay(study, walls, 2, {}, {});
    CHECK(r.different == 0);
    CHECK(r.films.front().frames == frames + 1);
}

TEST_CASE("report cycles: a push one way has no loops", "[app][report_cycles]")
{
    app::StudyWalls study;
    CHECK(app::loops_json(study, {}).is_null());
    CHECK(app::damping_json(study).empty());
}
