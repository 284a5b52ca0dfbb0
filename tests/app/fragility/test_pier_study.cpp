/// Piers in studies: what is stored of them, and how walls, tables and laws are read off it.

#include "app/fragility/numbers/fragility_data.hpp"
#include "app/fragility/numbers/model_doubt.hpp"
#include "app/study/answers/part_tables.hpp"
#include "app/study/answers/pier_shares.hpp"
#include "app/study/pushed/both_ways.hpp"
#include "app/study/pushed/pier_columns.hpp"
#include "app/study/pushed/push_walls.hpp"
#include "app/study/run_study.hpp"
#include "app/study/stored/study_walls.hpp"
#include "app/study_scenes.hpp"
#include "dem/block/model.hpp"
#include "tests/scenes/same_results.hpp"
#include "tests/scenes/temporary_folder.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace {

namespace fs = std::filesystem;

/// Four walls with a short pier between a door and a window, and longer ones beside them.
app::Study with_piers(const std::vector<std::string>& more = {},
                      const std::string& states = "paper, ntc", int samples = 4)
{
    std::vector<std::string> set = {"uq.samples=" + std::to_string(samples),
                                    "wall.length=1.2 m",
                                    "wall.courses=6",
                                    "solver.fidelity=rigid",
                                    "solver.steps_per_mm=100",
                                    "solver.accuracy=20 %",
                                    "load.max_displacement=14 mm",
                                    "load.vertical_stress=0.3 MPa",
                                    "joint.wall_modulus=900 MPa",
                                    "fragility.limit_states=" + states,
                                    "wall.openings=0.2 m, 0 m, 0.2 m, 0.5 m; "
                                    "0.8 m, 0.3 m, 0.2 m, 0.2 m"};
    set.insert(set.end(), more.begin(), more.end());
    return app::read_study(
        app::with_overrides(app::parse_study_text("study.ini", study_scenes::kSmall), set));
}

void run(const app::Study& s, const fs::path& file)
{
    app::StudyRun r;
    r.file = file;
    REQUIRE(app::run_study(app::prepare(s), r).whole);
}

/// The walls of a study as pushes of their own.
std::vector<app::PushedWall> pushed(const app::Study& s)
{
    const app::PreparedStudy ready = app::prepare(s);
    const std::vector<std::uint32_t> sizes = {4};
    const app::SamplePlan plan = app::sample_plan(s, s.load, s.source, ready.layout, sizes);
    std::vector<app::PushedWall> walls(4);
    app::PushList list;
    list.size = walls.size();
    list.wall = [&](std::size_t i) {
        return app::WantedWall{0, app::draw(plan, 0, static_cast<int>(i))};
    };
    list.done = [&](std::size_t i, const app::WallDraw&, app::PushedWall&& w) {
        walls[i] = std::move(w);
    };
    app::push_walls(s, app::model_of(ready), app::push_plan(s), list, 1);
    return walls;
}

bool same(const app::WallReading& a, const app::WallReading& b)
{
    return a.governing == b.governing && a.mode == b.mode &&
           std::ranges::equal(a.limits, b.limits, app::same_limit);
}

std::size_t state_of(const app::StudyWalls& walls, const std::string& name)
{
    for (std::size_t s = 0; s < walls.states.size(); ++s)
        if (state_name(walls.states[s]) == name) return s;
    throw std::invalid_argument(name);
}

std::size_t capped_walls(const app::StudyLevel& level, std::size_t state)
{
    return static_cast<std::size_t>(std::ranges::count_if(
        level.walls, [&](const auto& w) { return w.reading.governing.at(state) > 0; }));
}

} // namespace

TEST_CASE("piers in studies: a wall of a file has the limits of its own push, to the bit",
          "[app][pier_study]")
{
    const scenes::TemporaryFolder folder;
    const app::Study study = with_piers();
    run(study, folder.path / "a.h5");
    const app::StudyWalls walls = app::read_study_walls(folder.path / "a.h5");
    const std::vector<app::PushedWall> own = pushed(study);
    REQUIRE(walls.piers.size() == 3);
    REQUIRE(walls.spandrels.size() == 2);
    REQUIRE(walls.levels.front().walls.size() == 4);
    const std::size_t slc = state_of(walls, "ntc SLC"), slv = state_of(walls, "ntc SLV");
    for (std::size_t i = 0; i < 4; ++i) {
        const app::StudyWall& w = walls.levels.front().walls[i];
        CHECK(same(w.reading, own[i].reading));
        REQUIRE(w.reading.governing.size() == walls.states.size());
        // The short pier turns most.
        CHECK(w.reading.governing[slc] == app::governing_pier(own[i].piers, "ntc"));
        CHECK(w.reading.governing[slc] > 0);
        CHECK(w.reading.governing[slv] == w.reading.governing[slc]); // a share of it
        CHECK(w.reading.governing[state_of(walls, "ntc SLO")] == 0);
        for (std::size_t p = 0; p < 3; ++p) {
            CHECK(w.piers[p].drift == own[i].piers[p].drift);
            CHECK(w.piers[p].mode == mode_text(own[i].piers[p]));
        }
        REQUIRE(w.spandrels.size() == own[i].spandrels.size());
        for (std::size_t s = 0; s < w.spandrels.size(); ++s) {
            const app::SpandrelReading &a = w.spandrels[s], &b = own[i].spandrels[s];
            CHECK(a.spandrel.at == b.spandrel.at);
            CHECK(a.drift == b.drift);
            CHECK(a.drift != 0.0);
            CHECK(a.facts.normal_at_peak == b.facts.normal_at_peak);
            CHECK(a.facts.shear_at_peak == b.facts.shear_at_peak);
            CHECK(a.facts.most_shear == b.facts.most_shear);
            CHECK(a.facts.most_shear >= std::abs(a.facts.shear_at_peak));
        }
    }
}

TEST_CASE("piers in studies: they are read anew by other rules, as a push by these is",
          "[app][pier_study]")
{
    const scenes::TemporaryFolder folder;
    run(with_piers(), folder.path / "a.h5");
    const std::vector<std::string> rules = {"fragility.limit_states=ec8, ntc"};
    const app::StudyWalls walls = app::read_study_walls(folder.path / "a.h5", rules);
    const std::vector<app::PushedWall> own = pushed(with_piers({}, "ec8, ntc"));
    for (std::size_t i = 0; i < 4; ++i)
        CHECK(same(walls.levels.front().walls.at(i).reading, own[i].reading));
    CHECK(capped_walls(walls.levels.front(), state_of(walls, "ec8 NC")) > 0);
}

TEST_CASE("piers in studies: of both directions, the pier of the one that governs counts",
          "[app][pier_study]")
{
    const scenes::TemporaryFolder folder;
    for (const char* const direction : {"both", "right", "left"})
        run(with_piers({std::string("load.direction=") + direction}), folder.path / direction);
    const auto read = [&](const char* name) {
        return app::read_study_walls(folder.path / name);
    };
    const app::StudyWalls both = read("both"), right = read("right"), left = read("left");
    const std::size_t slc = state_of(both, "ntc SLC");
    const auto wall = [](const app::StudyWalls& s, std::size_t i) -> const app::StudyWall& {
        return s.levels.front().walls.at(i);
    };
    std::size_t turned = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        const app::WallReading &r = wall(right, i).reading, &l = wall(left, i).reading,
                               &w = wall(both, i).reading;
        const bool by_left = l.limits[slc].displacement < r.limits[slc].displacement;
        turned += by_left;
        CHECK(app::same_limit(w.limits[slc], by_left ? l.limits[slc] : r.limits[slc]));
        CHECK(w.governing[slc] == (by_left ? l : r).governing[slc]);
        CHECK(wall(both, i).turned_piers.at(2).drift == wall(left, i).piers.at(2).drift);
        CHECK(wall(both, i).turned_spandrels.at(1).drift ==
              wall(left, i).spandrels.at(1).drift);
    }
    std::size_t n = 0, to_left = 0;
    for (const app::GoverningPier& g : app::governing_piers(both, both.levels.front(), slc)) {
        n += g.walls;
        to_left += g.direction < 0 ? g.walls : 0;
    }
    CHECK(n == 4);
    CHECK(to_left == turned);
    CHECK(app::study_pier_table(both).rows.size() == 6);
    CHECK(app::study_pier_table(right).rows.size() == 3);
    CHECK(app::study_spandrel_table(both).rows.size() == 4);
    CHECK(app::study_spandrel_table(right).rows.size() == 2);
}

TEST_CASE("piers in studies: shares of the piers that govern add up, and the sentence has them",
          "[app][pier_study]")
{
    const scenes::TemporaryFolder folder;
    run(with_piers(), folder.path / "a.h5");
    const app::StudyWalls walls = app::read_study_walls(folder.path / "a.h5");
    const app::StudyLevel& level = walls.levels.front();
    const std::size_t slc = state_of(walls, "ntc SLC");
    REQUIRE(app::pier_states(walls) == std::vector<std::size_t>{slc});
    std::size_t rows = 0, all = 0;
    std::string sentence = app::pier_sentence(walls);
    for (const app::GoverningPier& g : app::governing_piers(walls, level, slc)) {
        ++rows;
        all += g.walls;
        CHECK(sentence.find(app::governing_text(walls, g) + ": " + std::to_string(g.walls)) !=
              std::string::npos);
    }
    CHECK(all == 4);
    CHECK(app::pier_share_table(walls).rows.size() == rows);
    CHECK(sentence.find("stand for all of them") == std::string::npos);
}

TEST_CASE("piers in studies: the drift limit of a pier differs from wall to wall, so that laws "
          "describe it, and has no error of the model",
          "[app][pier_study]")
{
    const scenes::TemporaryFolder folder;
    run(with_piers(), folder.path / "a.h5");
    const app::StudyWalls walls = app::read_study_walls(folder.path / "a.h5");
    const app::DriftData data = app::drift_data(walls);
    const std::size_t slc = state_of(walls, "ntc SLC"), slo = state_of(walls, "ntc SLO");
    REQUIRE(capped_walls(walls.levels.front(), slc) > 0);
    for (const fragility::Observation& o : app::limits_of(data.groups.front(), slc))
        CHECK(!o.capped);
    CHECK(app::limit_text(data, 0, slc).empty());
    CHECK(app::pier_text(data, 0, slc).starts_with("pier "));
    CHECK(app::pier_text(data, 0, slo).empty());
    CHECK(!app::doubted_limit(data, 0, slc));
    CHECK(app::doubted_limit(data, 0, slo));
    CHECK(data.drift.find("stand for all of them") == std::string::npos);
}

TEST_CASE("piers in studies: a file that holds none is read as one wall, which it says",
          "[app][pier_study]")
{
    const scenes::TemporaryFolder folder;
    const fs::path file = folder.path / "a.h5", old = folder.path / "old.h5";
    run(with_piers(), file);
    app::StoreReader reader(file);
    app::StoreHead head = reader.head(); // as a version before wrote it
    head.piers = head.spandrels = {};
    app::Store store(old, head);
    reader.for_each_row([&](app::WallRow row) {
        row.piers = row.spandrels = {};
        store.append({&row, 1});
    });
    const app::StudyWalls walls = app::read_study_walls(old);
    CHECK(walls.piers.empty());
    CHECK(walls.levels.front().walls.front().reading.governing.empty());
    CHECK(app::pier_sentence(walls).find("stand for all of them") != std::string::npos);
    CHECK(app::pier_share_table(walls).rows.empty());
    CHECK(app::drift_data(walls).drift.find("stand for all of them") != std::string::npos);
}

TEST_CASE(
    "piers in studies: a file without spandrels, of a version before, is read and goes on",
    "[app][pier_study]")
{
    const scenes::TemporaryFolder folder;
    const fs::path file = folder.path / "a.h5", old = folder.path / "old.h5";
    run(with_piers({}, "paper, ntc", 2), file);
    app::StoreReader reader(file);
    app::StoreHead head = reader.head();
    const app::Study study = with_piers();
    CHECK(head.spandrels == app::stored_spandrels_of(study, study.load));
    head.spandrels = {};
    {
        app::Store store(old, head);
        reader.for_each_row([&](app::WallRow row) {
            row.spandrels = {};
            store.append({&row, 1});
        });
    }
    CHECK(app::study_spandrel_table(app::read_study_walls(old)).rows.empty());
    run(with_piers(), old); // two more walls
    const app::StudyWalls walls = app::read_study_walls(old);
    REQUIRE(walls.levels.front().walls.size() == 4);
    CHECK(walls.piers.size() == 3);
    CHECK(walls.spandrels.empty());
}

TEST_CASE("piers in studies: what is stored of piers comes back to the bit, from the parts and "
          "from the file, and a wall without a reading as none",
          "[app][pier_study]")
{
    const scenes::TemporaryFolder folder;
    const fs::path file = folder.path / "a.h5";
    const app::Study study = with_piers();
    run(study, file);
    app::StoreReader reader(file);
    const app::StoreHead head = reader.head();
    CHECK(head.piers == app::stored_piers_of(study, study.load));
    std::vector<app::WallRow> rows;
    reader.for_each_row([&](const app::WallRow& row) { rows.push_back(row); });
    std::ranges::fill(rows.back().piers.facts, std::nan(""));
    CHECK(app::pier_facts_of(rows.back().piers, head.piers).empty());
    const auto facts = app::pier_facts_of(rows.front().piers, head.piers);
    REQUIRE(facts.size() == 3);
    const app::PierFacts own = pushed(study).front().piers.at(1).facts;
    CHECK(facts[1].movement == own.movement);
    CHECK(facts[1].shear == own.shear);
    CHECK(facts[1].mechanism.turning_share == own.mechanism.turning_share);
    app::Store store(folder.path / "b.h5", head);
    store.append(rows);
    const auto check = [&] {
        std::size_t i = 0;
        app::StoreReader(folder.path / "b.h5").for_each_row([&](const app::WallRow& row) {
            CHECK(scenes::same_results(row, rows.at(i++)));
        });
        CHECK(i == rows.size());
    };
    check();
    store.compact();
    check();
    CHECK(rows.front().spandrels.facts.size() == 2 * head.spandrels.facts.size());
    app::WallRow short_one = rows.front();
    short_one.spandrels.facts.pop_back();
    CHECK_THROWS_WITH(app::check_row(head, short_one),
                      Catch::Matchers::Contains("facts of spandrels"));
    rows.front().piers.shear.pop_back();
    rows.front().key.sample = 3;
    CHECK_THROWS_WITH(app::check_row(head, rows.front()),
                      Catch::Matchers::Contains("shears of piers"));
}
