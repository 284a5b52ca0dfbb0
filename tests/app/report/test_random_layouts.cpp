/// Studies whose samples lie in random layouts of their own.

#include "app/input/prepared_study.hpp"
#include "app/input/study_reading.hpp"
#include "app/input/wall/random_layouts.hpp"
#include "app/input/wall/wall_geometry.hpp"
#include "app/report/report_data.hpp"
#include "app/report/report_film.hpp"
#include "app/report/report_replay.hpp"
#include "app/study/push_layouts.hpp"
#include "app/study/pushed/interrupt.hpp"
#include "app/study/stored/study_columns.hpp"
#include "app/study/stored/study_file_head.hpp"
#include "app/study/study_runner.hpp"
#include "app/study_scenes.hpp"
#include "app/text/config_error.hpp"
#include "dem/block/model.hpp"
#include "scenes/temporary_folder.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <map>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

using app::Study;

namespace {

Study layouts(const std::vector<std::string>& more, const char* bond = "wall.bond=rubble")
{
    std::vector<std::string> all = {bond, "uq.samples=5"};
    all.insert(all.end(), more.begin(), more.end());
    if (std::ranges::none_of(more, [](const auto& m) { return m.starts_with("wall.seed"); }))
        all.emplace_back("wall.seed=11");
    return app::prepare(app::read_study(app::with_overrides(
                            app::parse_study_text("study.ini", study_scenes::kSmall), all)))
        .study;
}

void run(const app::PreparedStudy& ready, const std::filesystem::path& file, int threads)
{
    const Study& s = ready.study;
    const std::vector<std::uint32_t> sizes = {app::samples_of(s.geometry, s)};
    const app::SamplePlan plan = sample_plan(s, s.load, s.source, ready.layout, sizes);
    app::Store store(file, app::head_of(s, ready.layout, plan, sizes));
    app::run_walls(ready, plan, pending_walls(store, {}, false), threads, store, {});
    store.compact();
}

std::vector<app::WallRow> rows_of(const app::PreparedStudy& s, int threads)
{
    const scenes::TemporaryFolder folder;
    const auto file = folder.path / "study.h5";
    run(s, file, threads);
    std::vector<app::WallRow> rows;
    app::StoreReader(file).for_each_row([&](const app::WallRow& row) { rows.push_back(row); });
    return rows;
}

} // namespace

TEST_CASE("random layouts: each wall is that of its layout pushed alone, to the bit",
          "[app][random_layouts]")
{
    const Study s = layouts({"wall.layouts=3"});
    const std::vector<app::WallRow> rows = rows_of(app::prepare(s), 2);
    REQUIRE(rows.size() == 10);
    const std::vector<std::uint32_t> sizes = {5};
    const app::SamplePlan plan =
        sample_plan(s, s.load, s.source, layout_of(s, s.source), sizes);
    for (const app::WallRow& row : rows) {
        const Study own = layouts({"wall.seed=" + std::to_string(11 + row.key.sample % 3)});
        const dem::Model model = app::model_of(app::prepare(own));
        const int level = static_cast<int>(row.key.level);
        const app::WallDraw d = app::draw(plan, level, static_cast<int>(row.key.sample));
        const app::PushedWall w = app::read_wall(
            app::reading_rules(own), own.load, own.output, level,
            dem::push(model,
                      app::wall_materials(own, own.random, app::stress_level(own.load, level),
                                          model.layout, d),
                      app::push_plan(own), own.solver));
        CHECK(row.curve.displacement == w.displacement);
        CHECK(row.curve.force == w.force);
    }
    for (const int threads : {1, 5}) {
        const std::vector<app::WallRow> again = rows_of(app::prepare(s), threads);
        for (std::size_t i = 0; i < rows.size(); ++i)
            CHECK(again[i].curve.force == rows[i].curve.force);
    }
}

TEST_CASE("random layouts: lengths of units alone make samples, the same under each stress",
          "[app][random_layouts]")
{
    std::vector<std::string> more = {"wall.unit_length_cov=0.1", "wall.layouts=4"};
    for (const char* fixed : {"joint.friction_angle=31.8 deg", "joint.stiffness_factor=1",
                              "unit.tensile_strength=3.7 MPa", "unit.friction_angle=35 deg",
                              "unit.stiffness_factor=1"})
        more.emplace_back(fixed);
    const Study s = layouts(more, "wall.bond=running");
    CHECK(s.random.empty());
    CHECK(app::is_random(s.geometry, s.random));
    CHECK(app::samples_of(s.geometry, s) == 5);
    const std::vector<app::WallRow> rows = rows_of(app::prepare(s), 2);
    REQUIRE(rows.size() == 10);
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<double>> forces;
    for (const app::WallRow& row : rows)
        forces[{row.key.level, row.key.sample}] = row.curve.force;
    for (const std::uint32_t level : {0u, 1u}) {
        CHECK(forces[{level, 4}] == forces[{level, 0}]); // the fifth lies in the first layout
        for (const std::uint32_t sample : {1u, 2u, 3u})
            CHECK(forces[{level, sample}] != forces[{level, 0}]);
    }
}

TEST_CASE("random layouts: the page has the stones of each wall that it shows",
          "[app][random_layouts]")
{
    const scenes::TemporaryFolder folder;
    const auto file = folder.path / "study.h5";
    const Study s = layouts({"wall.layouts=3"});
    run(app::prepare(s), file, 2);
    const app::StudyWalls walls = app::read_study_walls(file, {}, app::Keep::everything);
    const app::WallList listed = app::walls_to_list(walls, 100);
    const app::Replay replay = app::replay(app::prepare(walls.study), listed, 2, {}, {});
    CHECK(replay.different == 0);
    const auto films = app::films_json(app::prepare(walls.study), listed, replay, "");
    CHECK(films["geometries"].size() == 3);
    REQUIRE(films["films"].size() == 10);
    for (const auto& film : films["films"]) {
        const std::uint32_t sample = listed[film["wall"].get<std::size_t>()]->key.sample;
        const Study own = layouts({"wall.seed=" + std::to_string(11 + sample % 3)});
        CHECK(films["geometries"][film["geometry"].get<std::size_t>()] ==
              app::wall_geometry(layout_of(own, own.source)));
    }
}

TEST_CASE(
    "random layouts: a layout that makes no wall is the failure of its walls, by its reason",
    "[app][random_layouts]")
{
    app::PreparedStudy s = app::prepare(layouts({"wall.layouts=5"}));
    s.study.wall.unit_length = 0.0;
    for (const int threads : {1, 3}) {
        const std::vector<app::WallRow> rows = rows_of(s, threads);
        CHECK(rows.size() == 10);
        for (const app::WallRow& row : rows) {
            CHECK(row.status != app::kWallOk);
            CHECK(row.reason.find("a wall of rubble needs positive sizes") !=
                  std::string::npos);
            CHECK(row.inputs.size() == s.study.random.size());
        }
    }
}

TEST_CASE("random layouts: what done throws ends the run and is thrown, whatever the threads",
          "[app][random_layouts]")
{
    const Study s = layouts({"wall.layouts=5"});
    for (const int threads : {1, 3}) {
        app::PushList list;
        list.size = 10;
        list.wall = [](std::size_t) -> app::WantedWall { return {0, {}}; };
        int taken = 0;
        list.done = [&](std::size_t, const app::WallDraw&, app::PushedWall&&) {
            if (++taken != 2) return;
            std::this_thread::sleep_for(
                std::chrono::milliseconds(50)); // others wait to hand on
            throw std::runtime_error("the disk is full");
        };
        CHECK_THROWS_WITH(app::push_in_layouts(
                              app::prepare(s), app::bare(app::push_plan(s)), list,
                              [](std::size_t i) { return static_cast<std::uint32_t>(i); },
                              threads),
                          "the disk is full");
        CHECK(taken == 2);
    }
}

TEST_CASE("random layouts: shards get whole samples", "[app][random_layouts]")
{
    app::StoreHead head;
    head.levels = {{0.5e6, 7}, {1e6, 7}};
    std::vector<app::WallKey> all;
    for (int i = 0; i < 3; ++i)
        for (const app::WallKey key : app::walls_of(head, {i, 3}, app::Deal::samples)) {
            CHECK(key.sample % 3 == static_cast<std::uint32_t>(i));
            all.push_back(key);
        }
    CHECK(all.size() == 14);
}

TEST_CASE("random layouts: what has no meaning across layouts is refused",
          "[app][random_layouts]")
{
    using Catch::Contains;
    CHECK_THROWS_WITH(layouts({"wall.layouts=3", "uq.spatial=independent"}),
                      Contains("uq.spatial") && Contains("write none"));
    CHECK_THROWS_WITH(layouts({"wall.layouts=3", "wall.seed=999999999"}),
                      Contains("wall.layouts") && Contains("smaller wall.seed"));
    CHECK_THROWS_WITH(
        layouts({"wall.layouts=3", "unit.cracks=grid(2, 2)", "unit.cracks_where=needed"}),
        Contains("unit.cracks_where") && Contains("one layout"));
    CHECK_THROWS_WITH(layouts({"wall.layouts=3"}, "wall.bond=stack"),
                      Contains("no layout is drawn at random"));
    const app::Study three = layouts({"wall.layouts=3"}), one = layouts({});
    CHECK_THROWS_WITH(app::refuse_layouts(three.geometry, three.source), Contains("write 1"));
    CHECK_NOTHROW(app::refuse_layouts(one.geometry, one.source));
}
