/// Studies with load.direction = both: each wall is pushed both ways, the worse one counts.

#include "app/input/wall/wall_geometry.hpp"
#include "app/study/answers/solver_error.hpp"
#include "app/study/other_way.hpp"
#include "app/study/pushed/both_ways.hpp"
#include "app/study/pushed/interrupt.hpp"
#include "app/study/run_study.hpp"
#include "app/study/stored/study_walls.hpp"
#include "app/study/stored/turned_walls.hpp"
#include "app/study_scenes.hpp"
#include "app/text/config_error.hpp"
#include "tests/scenes/same_results.hpp"
#include "tests/scenes/temporary_folder.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;
using app::Study;

/// Two stresses, three walls of each, with a door that is not in the middle.
Study with_door(const std::string& direction, const std::vector<std::string>& more = {},
                const std::string& from = "0.1 m")
{
    std::vector<std::string> set = {"uq.samples=3",
                                    "solver.fidelity=rigid",
                                    "solver.steps_per_mm=200",
                                    "load.max_displacement=2 mm",
                                    "wall.openings=" + from + ", 0 m, 0.2 m, 0.2 m",
                                    "lintel.bearing=0.1 m",
                                    "load.direction=" + direction};
    set.insert(set.end(), more.begin(), more.end());
    return app::read_study(
        app::with_overrides(app::parse_study_text("study.ini", study_scenes::kSmall), set));
}

app::StudyRunEnd run(const Study& s, const fs::path& file, int threads = 1,
                     app::Shard shard = {})
{
    app::StudyRun r;
    r.file = file;
    r.threads = threads;
    r.shard = shard;
    return app::run_study(app::prepare(s), r);
}

/// All walls of a file, those that were pushed the other way at the end.
std::vector<app::WallRow> rows_of(const fs::path& file)
{
    std::vector<app::WallRow> rows;
    const auto keep = [&](const app::WallRow& row) { rows.push_back(row); };
    app::StoreReader reader(file);
    reader.for_each_row(keep);
    reader.for_each_turned_row(keep);
    return rows;
}

bool same(const std::vector<app::WallRow>& a, const std::vector<app::WallRow>& b)
{
    return std::ranges::equal(a, b, scenes::same_results);
}

} // namespace

TEST_CASE(
    "both ways: a study keeps both pushes of each wall, those of a study to the right and "
    "of one to the left, to the bit",
    "[app][both_ways_study]")
{
    const scenes::TemporaryFolder folder;
    for (const char* const direction : {"both", "right", "left"})
        REQUIRE(run(with_door(direction), folder.path / direction, 2).whole);
    const std::vector<app::WallRow> both = rows_of(folder.path / "both"),
                                    right = rows_of(folder.path / "right"),
                                    left = rows_of(folder.path / "left");
    REQUIRE(both.size() == 12);
    REQUIRE(right.size() == 6);
    REQUIRE(left.size() == 6);
    for (std::size_t i = 0; i < 6; ++i) {
        CHECK(both[i].key == right[i].key);
        CHECK(both[i].curve.force == right[i].curve.force);
        CHECK(both[i + 6].curve.force == left[i].curve.force);
        CHECK(both[i + 6].curve.displacement.back() < 0.0);
        CHECK(scenes::same_bits(both[i].inputs, both[i + 6].inputs));
    }
}

TEST_CASE("both ways: the worse of both directions stands for a wall in every table",
          "[app][both_ways_study]")
{
    const scenes::TemporaryFolder folder;
    for (const char* const direction : {"both", "right", "left"})
        run(with_door(direction), folder.path / direction, 2);
    const app::StudyWalls both = app::read_study_walls(folder.path / "both"),
                          right = app::read_study_walls(folder.path / "right"),
                          left = app::read_study_walls(folder.path / "left");
    std::size_t by_left = 0;
    for (std::size_t l = 0; l < 2; ++l) {
        REQUIRE(both.levels[l].walls.size() == 3);
        CHECK(both.levels[l].missing == 0);
        for (std::size_t i = 0; i < 3; ++i) {
            const app::StudyWall &w = both.levels[l].walls[i], &r = right.levels[l].walls[i],
                                 &t = left.levels[l].walls[i];
            const double a = peak_force(r.reading), b = peak_force(t.reading);
            REQUIRE(a != b);
            by_left += b < a ? 1 : 0;
            CHECK(peak_force(w.reading) == std::min(a, b));
            CHECK(w.reading.mode == (b < a ? t : r).reading.mode);
            CHECK(w.forces == (b < a ? t : r).forces);
            CHECK(peak_force(first_way(w)) == a);
            for (std::size_t k = 0; k < w.reading.limits.size(); ++k)
                CHECK(w.reading.limits[k].displacement ==
                      fragility::worse(r.reading.limits[k], t.reading.limits[k]).displacement);
        }
    }
    const std::string remark = other_way_remark(both);
    CHECK_THAT(remark, Catch::Contains("peak force: right " + std::to_string(6 - by_left) +
                                       ", left " + std::to_string(by_left)));
    CHECK(other_way_remark(right).find("load.direction = both") != std::string::npos);
}

TEST_CASE("both ways: walls are the same whatever threads, shards, stops and later wishes",
          "[app][both_ways_study]")
{
    const scenes::TemporaryFolder folder;
    const auto file = [&](const char* name) { return folder.path / name; };
    const Study s = with_door("both");
    run(s, file("whole.h5"));
    const std::vector<app::WallRow> whole = rows_of(file("whole.h5"));

    run(s, file("threads.h5"), 3);
    CHECK(same(rows_of(file("threads.h5")), whole));

    for (const int i : {0, 1}) run(s, file(i == 0 ? "1.h5" : "2.h5"), 1, {i, 2});
    app::merge(file("merged.h5"), {file("1.h5"), file("2.h5")});
    CHECK(same(rows_of(file("merged.h5")), whole));

    app::StudyRun stopped;
    stopped.file = file("stopped.h5");
    int turns = 0;
    stopped.seen = [&](const app::RunProgress& p) { // in one direction, then in the other
        if (p.done > 0 && (p.round == app::Round::turned) == (turns == 1))
            throw app::Interrupted{};
    };
    for (; turns < 2; ++turns) CHECK_FALSE(app::run_study(app::prepare(s), stopped).whole);
    const app::StudyWalls part = app::read_study_walls(file("stopped.h5"));
    CHECK(part.levels[0].missing + part.levels[1].missing > 0); // pushed one way is not pushed
    CHECK(run(s, file("stopped.h5")).whole);
    CHECK(same(rows_of(file("stopped.h5")), whole));

    run(with_door("right"), file("later.h5")); // the other direction may follow
    CHECK(rows_of(file("later.h5")).size() == 6);
    run(s, file("later.h5"));
    CHECK(same(rows_of(file("later.h5")), whole));
    CHECK_THROWS_WITH(run(with_door("right"), file("later.h5")),
                      Catch::Contains("pushed both ways; write load.direction = both"));
}

TEST_CASE("both ways: an audit stands behind both directions, and compares with its own one",
          "[app][both_ways_study]")
{
    const scenes::TemporaryFolder folder;
    run(with_door("both"), folder.path / "a.h5");
    run(with_door("both", {"uq.audit=1"}), folder.path / "a.h5");
    const app::StudyWalls walls = app::read_study_walls(folder.path / "a.h5");
    REQUIRE(walls.levels[0].audit.size() == 1);
    REQUIRE(walls.levels[0].walls.size() == 3);
    const double own = peak_force(first_way(walls.levels[0].walls.front())),
                 slow = peak_force(walls.levels[0].audit.front().reading);
    CHECK(slow == Approx(own).epsilon(0.2));
    CHECK(app::audit_difference(walls.levels[0], walls.levels[0].audit.front()).peak ==
          Approx(std::abs(own / slow - 1.0)).margin(1e-12));
}

TEST_CASE("both ways: a wall that gives no result one way is a failed wall that says which",
          "[app][both_ways_study]")
{
    const scenes::TemporaryFolder folder;
    const Study s = with_door("both");
    run(s, folder.path / "a.h5");
    app::StoreReader reader(folder.path / "a.h5");
    const app::StoreHead head = reader.head();
    std::vector<app::WallRow> rows = rows_of(folder.path / "a.h5");
    app::WallRow& bad = rows[7]; // 0.5 MPa, sample 1, the other way
    REQUIRE(bad.key == app::WallKey{2, 1});
    bad.status = 4;
    bad.reason = "lost";
    bad.curve = {};
    bad.piers.movement = bad.piers.shear = {};
    app::Store store(folder.path / "b.h5", head);
    store.append(rows);
    store.compact();
    const app::StudyWalls walls = app::read_study_walls(folder.path / "b.h5");
    CHECK(walls.levels[0].walls.size() == 2);
    REQUIRE(walls.levels[0].failed_walls.size() == 1);
    CHECK(walls.levels[0].failed_walls.front().key.sample == 1);
    CHECK(walls.levels[0].failed_walls.front().reason == "pushed to the left: lost");
}

TEST_CASE("both ways: a symmetric wall is pushed once, and cracks placed for one direction are "
          "refused",
          "[app][both_ways_study]")
{
    const auto both = [](const Study& s) {
        return app::pushes_both_ways(s.geometry, s.load, s.source, app::layout_of(s, s.source));
    };
    CHECK(both(with_door("both")));
    CHECK_FALSE(both(with_door("right")));
    CHECK_FALSE(both(with_door("both", {}, "0.2 m")));
    CHECK_FALSE(both(study_scenes::study("samples = 3"))); // not asked for
    CHECK_THROWS_WITH(both(with_door("both", {"unit.cracks=thirds", "unit.cracks_where=toe"})),
                      Catch::Contains("load.direction: unit.cracks_where = toe"));
}
