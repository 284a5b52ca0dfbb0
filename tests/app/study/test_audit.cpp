/// uq.audit: walls of a study pushed again more slowly, beside the study.

#include "app/input/keys/limit_state_text.hpp"
#include "app/input/prepared_study.hpp"
#include "app/input/study_reading.hpp"
#include "app/study/answers/solver_error.hpp"
#include "app/study/pushed/interrupt.hpp"
#include "app/study/pushed/pushed_wall.hpp"
#include "app/study/run_study.hpp"
#include "app/study/stored/study_file_head.hpp"
#include "app/study_scenes.hpp"
#include "dem/block/model.hpp"
#include "dem/solver/slower.hpp"
#include "tests/scenes/same_results.hpp"
#include "tests/scenes/temporary_folder.hpp"

#include <catch2/catch.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;
using app::Study;

/// Two stresses, three walls of each, two of them pushed again.
Study audited(int audit = 2, int samples = 3)
{
    const std::vector<std::string> set = {
        "uq.samples=" + std::to_string(samples), "uq.audit=" + std::to_string(audit),
        "solver.fidelity=rigid", "solver.steps_per_mm=100", "load.max_displacement=1 mm"};
    return app::prepare(app::read_study(app::with_overrides(
                            app::parse_study_text("study.ini", study_scenes::kSmall), set)))
        .study;
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

/// All walls of a file, those of the audit at the end.
std::vector<app::WallRow> rows_of(const fs::path& file)
{
    std::vector<app::WallRow> rows;
    const auto keep = [&](const app::WallRow& row) { rows.push_back(row); };
    app::StoreReader reader(file);
    reader.for_each_row(keep);
    reader.for_each_audit_row(keep);
    return rows;
}

bool same(const std::vector<app::WallRow>& a, const std::vector<app::WallRow>& b)
{
    return std::ranges::equal(a, b, scenes::same_results);
}

} // namespace

TEST_CASE("audit: its walls are those of the study pushed alone four times slower, to the bit",
          "[app][audit]")
{
    const scenes::TemporaryFolder folder;
    const Study s = audited();
    REQUIRE(run(s, folder.path / "a.h5", 2).whole);
    const std::vector<app::WallRow> rows = rows_of(folder.path / "a.h5");
    REQUIRE(rows.size() == 10);
    const app::WallRow &own = rows[3], &slow = rows[8]; // 1 MPa, sample 0
    CHECK(slow.key == app::WallKey{3, 0});
    CHECK(scenes::same_bits(own.inputs, slow.inputs));
    const dem::Model model = app::model_of(app::prepare(s));
    const std::vector<std::uint32_t> sizes = {3};
    const app::SamplePlan plan = sample_plan(s, s.load, s.source, model.layout, sizes);
    const dem::WallMaterials m = app::wall_materials(s, s.random, app::stress_level(s.load, 1),
                                                     model.layout, app::draw(plan, 1, 0));
    const app::PushedWall alone =
        app::read_wall(app::reading_rules(s), s.load, s.output, 1,
                       dem::push(model, m, app::push_plan(s), dem::slower(s.solver, 4.0)));
    CHECK(slow.curve.force == alone.force);
    CHECK(slow.curve.force != own.curve.force);
}

TEST_CASE("audit: the walls are the same whatever threads, shards, stops and later wishes",
          "[app][audit]")
{
    const scenes::TemporaryFolder folder;
    const auto file = [&](const char* name) { return folder.path / name; };
    const Study s = audited();
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
    stopped.seen = [&](const app::RunProgress& p) { // in the study, then in its audit
        if (p.done > 0 && (p.round == app::Round::audit) == (turns == 1))
            throw app::Interrupted{};
    };
    for (; turns < 2; ++turns) CHECK_FALSE(app::run_study(app::prepare(s), stopped).whole);
    CHECK(rows_of(file("stopped.h5")).size() < whole.size());
    CHECK(run(s, file("stopped.h5")).whole);
    CHECK(same(rows_of(file("stopped.h5")), whole));

    run(audited(0), file("later.h5")); // a study that is finished is audited
    CHECK(rows_of(file("later.h5")).size() == 6);
    run(audited(1, 2), file("grown.h5"));
    run(s, file("later.h5"));
    CHECK(same(rows_of(file("later.h5")), whole));
    const app::StudyRunEnd grown = run(audited(2, 2), file("grown.h5"));
    CHECK(grown.before == 4); // walls of the study: those of the audit are not counted
    CHECK(grown.now == 0);
    CHECK(rows_of(file("grown.h5")).size() == 8);
}

TEST_CASE("audit: the walls of the study and their numbers stay what they are without it",
          "[app][audit]")
{
    const scenes::TemporaryFolder folder;
    run(audited(), folder.path / "with.h5");
    run(audited(0), folder.path / "without.h5");
    const auto with = app::study_summary(folder.path / "with.h5", false);
    const auto without = app::study_summary(folder.path / "without.h5", false);
    CHECK(app::as_csv(with.table) == app::as_csv(without.table));
    CHECK(with.missing == 0);
    CHECK(with.remarks.find("4 of 6 walls pushed again 4 times slower") != std::string::npos);
    CHECK(without.remarks.find("pushed again") == std::string::npos);
    const app::StudyWalls walls = app::read_study_walls(folder.path / "with.h5");
    REQUIRE(walls.levels.size() == 2);
    CHECK(walls.levels[1].walls.size() == 3);
    REQUIRE(walls.levels[1].audit.size() == 2);
    const app::AuditDifference d =
        app::audit_difference(walls.levels[1], walls.levels[1].audit[1]);
    CHECK(d.checked);
    CHECK(d.peak >= 0.0);
    CHECK(d.peak < 0.5);
}

TEST_CASE("audit: walls that were pushed again are not dropped", "[app][audit]")
{
    const scenes::TemporaryFolder folder;
    run(audited(), folder.path / "a.h5");
    CHECK_THROWS_WITH(
        run(audited(1), folder.path / "a.h5"),
        Catch::Contains("has 2 walls of each stress pushed again more slowly, only 1 are "
                        "wanted (uq.audit)"));
}

TEST_CASE("audit: more walls than there are means all of them", "[app][audit]")
{
    const Study s = audited(50);
    const std::vector<std::uint32_t> sizes = {3};
    const dem::Layout layout = app::prepare(s).layout;
    const app::StoreHead head =
        app::head_of(s, layout, sample_plan(s, s.load, s.source, layout, sizes), sizes);
    REQUIRE(head.levels.size() == 4);
    CHECK(head.levels[2].samples == 3);
    CHECK(head.levels[2].slower == 4);
}
