#include "app/input/keys/limit_state_text.hpp"
#include "app/input/prepared_study.hpp"
#include "app/input/study_reading.hpp"
#include "app/input/wall/wall_geometry.hpp"
#include "app/study/pushed/interrupt.hpp"
#include "app/study/pushed/pushed_wall.hpp"
#include "app/study/run_study.hpp"
#include "app/study/stored/study_columns.hpp"
#include "app/study/stored/study_file_head.hpp"
#include "app/study/study_runner.hpp"
#include "app/study_scenes.hpp"
#include "dem/block/model.hpp"
#include "tests/scenes/temporary_folder.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

using app::Study;

namespace {

namespace fs = std::filesystem;

struct Ran {
    dem::Model model;
    app::SamplePlan plan;
    std::vector<app::WallRow> rows;
};

Ran run(const Study& s, int threads = 2)
{
    const scenes::TemporaryFolder folder;
    const fs::path file = folder.path / "study.h5";
    Ran r{app::model_of(app::prepare(s)), {}, {}};
    const std::vector<std::uint32_t> sizes = {app::samples_of(s.geometry, s)};
    r.plan = sample_plan(s, s.load, s.source, r.model.layout, sizes);
    app::Store store(file, app::head_of(s, r.model.layout, r.plan, sizes));
    app::run_walls(app::prepare(s), r.plan, pending_walls(store, {}, false), threads, store,
                   {});
    store.compact();
    app::StoreReader(file).for_each_row(
        [&](const app::WallRow& row) { r.rows.push_back(row); });
    return r;
}

/// By dem::push, one wall in plain doubles.
app::PushedWall pushed_alone(const Study& s, int level, const app::WallDraw& draw)
{
    const dem::Model model = app::model_of(app::prepare(s));
    const dem::WallMaterials m =
        app::wall_materials(s, s.random, app::stress_level(s.load, level), model.layout, draw);
    return app::read_wall(app::reading_rules(s), s.load, s.output, level,
                          dem::push(model, m, app::push_plan(s), s.solver));
}

} // namespace

TEST_CASE("study runner: a stored wall pushed again alone has the same curve, to the bit",
          "[app][study_runner]")
{
    const Study s =
        study_scenes::study(GENERATE("samples = 5", "samples = 5\nspatial = stratified"));
    const Ran r = run(s);
    REQUIRE(r.rows.size() == 10);
    for (const std::size_t i : {std::size_t{2}, std::size_t{9}}) {
        const app::WallRow& row = r.rows[i];
        const int level = static_cast<int>(row.key.level);
        const app::WallDraw d = app::draw(r.plan, level, static_cast<int>(row.key.sample));
        const app::PushedWall w = pushed_alone(s, level, d);
        CHECK(row.inputs == app::flattened(d));
        CHECK(row.curve.displacement == w.displacement);
        CHECK(row.curve.force == w.force);
        CHECK(row.responses[app::column_of(app::response_columns(), "peak_force")] ==
              w.reading.peak->force);
    }
}

TEST_CASE("study runner: a study without distributions is one wall per level",
          "[app][study_runner]")
{
    std::string text = study_scenes::kSmall;
    for (const auto& [from, to] : std::vector<std::pair<std::string, std::string>>{
             {"normal(mean 31.8 deg, cov 0.20)", "31.8 deg"},
             {"normal(mean 1, cov 0.25)", "1"},
             {"lognormal(mean 3.7 MPa, cov 0.30)", "3.7 MPa"},
             {"normal(mean 35 deg, cov 0.20)", "35 deg"},
             {"normal(mean 1, cov 0.25)", "1"}})
        text.replace(text.find(from), from.size(), to);
    const Ran r = run(study_scenes::study("samples = 50", text));
    CHECK(r.rows.size() == 2);
}

TEST_CASE("study runner: a wall that fails is kept with its inputs and its reason",
          "[app][study_runner]")
{
    std::string text = study_scenes::kSmall;
    text += "energy_tolerance = 1e-14\n";
    const Ran r = run(study_scenes::study("samples = 2", text));
    REQUIRE(r.rows.size() == 4);
    for (const app::WallRow& row : r.rows) {
        CHECK(row.status != app::kWallOk);
        CHECK(row.reason == "the energy ledger does not close at any step tried");
        CHECK(row.inputs.size() == 5);
        CHECK(row.curve.force.empty());
        for (const double x : row.responses) CHECK(x != x); // not defined
        CHECK(row.counts[app::column_of(app::count_columns(), "outcome")] ==
              static_cast<std::int64_t>(dem::Outcome::energy_astray));
    }
}

TEST_CASE("study runner: a draw that makes no wall is a failed wall, and the others are pushed",
          "[app][study_runner]")
{
    // joint.wall_modulus is 768 and 1057 MPa
    const std::vector<std::string> soft = {"stone.young_modulus=normal(mean 2 GPa, cov 0.5)",
                                           "uq.samples=10"};
    const Ran r =
        run(app::prepare(app::read_study(app::with_overrides(
                             app::parse_study_text("study.ini", study_scenes::kSmall), soft)))
                .study);
    REQUIRE(r.rows.size() == 20);
    int failed = 0;
    for (const app::WallRow& row : r.rows) {
        const double modulus_of_wall = row.key.level == 0 ? 768e6 : 1057e6;
        const bool no_wall = row.inputs.front() <= modulus_of_wall; // Eq. 2 has no k_n then
        CHECK((row.status != app::kWallOk) == no_wall);
        CHECK(row.curve.force.empty() == no_wall);
        if (!no_wall) continue;
        ++failed;
        CHECK(row.reason.starts_with("no wall can be made of the values drawn: "));
    }
    CHECK(failed > 0);
}

TEST_CASE("study runner: shards share out the walls of a study, each to one of them",
          "[app][study_runner]")
{
    app::StoreHead head;
    head.levels = {{0.5e6, 7}, {1e6, 5}};
    std::vector<app::WallKey> all;
    for (int i = 0; i < 5; ++i)
        for (const app::WallKey key : app::walls_of(head, {i, 5})) all.push_back(key);
    std::sort(all.begin(), all.end());
    CHECK(all.size() == 12);
    CHECK(std::adjacent_find(all.begin(), all.end()) == all.end());
}

TEST_CASE(
    "study runner: each shard has about as many walls of every level, whatever the numbers",
    "[app][study_runner]")
{
    const int levels = GENERATE(1, 2, 3, 5, 12), shards = GENERATE(2, 3, 4, 5, 12, 16);
    const std::uint32_t samples = GENERATE(16U, 40U, 50U);
    app::StoreHead head, more;
    for (int l = 0; l < levels; ++l) {
        head.levels.push_back({1e5 * (l + 1), samples});
        more.levels.push_back({1e5 * (l + 1), samples + 7});
    }
    std::size_t least = 1'000'000, most = 0;
    for (int i = 0; i < shards; ++i) {
        const std::vector<app::WallKey> walls = app::walls_of(head, {i, shards});
        least = std::min(least, walls.size());
        most = std::max(most, walls.size());
        std::vector<std::uint32_t> of_level(static_cast<std::size_t>(levels));
        for (const app::WallKey wall : walls) ++of_level[wall.level];
        for (const std::uint32_t n : of_level) {
            CHECK(n >= samples / static_cast<std::uint32_t>(shards));
            CHECK(n <= samples / static_cast<std::uint32_t>(shards) + 1);
        }
        std::vector<app::WallKey> grown = app::walls_of(more, {i, shards});
        std::erase_if(grown, [&](app::WallKey w) { return w.sample >= samples; });
        CHECK(grown == walls);
    }
    CHECK(most - least <= 2); // the samples that are left over are spread
}

TEST_CASE("study runner: a shard that another version shared out is not gone on with",
          "[app][study_runner]")
{
    const Study s = study_scenes::study("samples = 4");
    const scenes::TemporaryFolder folder;
    app::StudyRun part;
    part.file = folder.path / "part.h5";
    part.shard = {0, 2};
    REQUIRE(app::run_study(app::prepare(s), part).whole);
    CHECK(app::run_study(app::prepare(s), part).before == 4);
    const dem::Layout layout = app::layout_of(s, s.source);
    const std::vector<std::uint32_t> sizes = {4};
    const app::SamplePlan plan = sample_plan(s, s.load, s.source, layout, sizes);
    app::StoreHead head = app::head_of(s, layout, plan, sizes);
    head.shards = 2;
    part.file = folder.path / "old.h5";
    app::Store old(part.file, head); // the walls of even numbers: those of level 0
    app::run_walls(app::prepare(s), plan, {{0, 0}, {0, 1}}, 1, old, {});
    old.compact();
    CHECK_THROWS_WITH(
        app::run_study(app::prepare(s), part),
        Catch::Contains("has wall (level 0, sample 1), which is not of this shard"));
}

TEST_CASE("study runner: a run that goes on tells what was there before it",
          "[app][study_runner]")
{
    const Study s = study_scenes::study("samples = 5");
    const scenes::TemporaryFolder folder;
    app::StudyRun run;
    run.file = folder.path / "study.h5";
    std::vector<app::RunProgress> seen;
    run.seen = [&](const app::RunProgress& p) {
        seen.push_back(p);
        if (p.done == 4 && p.before == 0) throw app::Interrupted();
    };
    const app::StudyRunEnd first = app::run_study(app::prepare(s), run);
    CHECK_FALSE(first.whole);
    CHECK(first.before == 0);
    CHECK(first.now == 4);
    seen.clear();
    const app::StudyRunEnd rest = app::run_study(app::prepare(s), run);
    CHECK(rest.whole);
    CHECK(rest.before == 4);
    CHECK(rest.now == 6);
    REQUIRE(!seen.empty());
    for (const app::RunProgress& p : seen) CHECK((p.before == 4 && p.all == 6));
}
