#include "app/fragility/fragility_command.hpp"
#include "app/fragility/study_output.hpp"
#include "app/input/prepared_study.hpp"

#include "app/input/command_line.hpp"
#include "app/store/store.hpp"
#include "app/store/store_reader.hpp"
#include "app/study/stored/study_columns.hpp"
#include "app/study/stored/study_file_head.hpp"
#include "app/study/stored/study_identity.hpp"
#include "app/study/stored/study_walls.hpp"
#include "app/study/study_runner.hpp"
#include "app/study_scenes.hpp"
#include "app/text/config_error.hpp"
#include "app/verbs.hpp"
#include "dem/block/model.hpp"
#include "tests/scenes/temporary_folder.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;

/// A study's file in a folder of its own.
struct File {
    scenes::TemporaryFolder folder;
    fs::path path = folder.path / "study.h5";
};

/// A study of 3 walls under each of two stresses, or the first of its shards, of which `walls`
/// were run, or as many as there are.
void run_study(const fs::path& path, std::size_t walls, std::uint32_t shards = 1)
{
    const app::Study s = study_scenes::study("samples = 3");
    const dem::Model model = app::model_of(app::prepare(s));
    const std::vector<std::uint32_t> sizes = {3};
    const app::SamplePlan plan = sample_plan(s, s.load, s.source, model.layout, sizes);
    app::StoreHead head = app::head_of(s, model.layout, plan, sizes);
    head.shards = shards;
    app::Store store(path, head);
    auto keys = pending_walls(store, {0, static_cast<int>(shards)}, false);
    keys.resize(std::min(walls, keys.size()));
    app::run_walls(app::prepare(s), plan, keys, 2, store, {});
    store.compact();
}

int run(const std::vector<std::string>& arguments)
{
    return app::fragility_command(app::parse_command_line(app::verbs(), arguments));
}

} // namespace

TEST_CASE(
    "fragility of a study: modes and displacements are those of the store, drifts over the "
    "height of the load",
    "[app][fragility_study]")
{
    const File file;
    run_study(file.path, 5);
    const app::StudyWalls walls = app::read_study_walls(file.path, {});
    CHECK(walls.height == Approx(0.5).epsilon(1e-14)); // 4 courses and the beam
    CHECK(walls.levels[0].walls.size() + walls.levels[1].walls.size() == 5);
    CHECK(walls.levels[1].missing == 1);
    app::StoreReader reader(file.path);
    const std::size_t peak = column_of(reader.head().responses, "peak_force");
    for (const app::StudyLevel& level : walls.levels)
        for (const app::StudyWall& w : level.walls) {
            const auto row = reader.row(app::WallKey{
                static_cast<std::uint32_t>(&level - walls.levels.data()), w.key.sample});
            REQUIRE(row);
            CHECK(app::peak_force(w.reading) == row->responses[peak]);
            CHECK(w.reading.limits[0].displacement == w.reading.ultimate.displacement);
            CHECK(w.reading.limits[0].reading == w.reading.ultimate.reading);
            CHECK(w.inputs[0] == Approx(row->inputs[0] * walls.inputs[0].scale));
        }
    const auto data = app::drift_data(walls);
    CHECK(data.groups[0].walls[0].limits[0]->lower ==
          Approx(100.0 * walls.levels[0].walls[0].reading.ultimate.displacement / 0.5)
              .epsilon(1e-14));
    CHECK(walls.inputs[0].unit == "deg");
}

TEST_CASE(
    "fragility of a study: an unfinished one, or one without a wall, is written and says what "
    "is missing",
    "[app][fragility_study]")
{
    const std::size_t n = GENERATE(std::size_t{0}, std::size_t{4});
    const File file;
    run_study(file.path, n);
    const auto output = app::study_output(app::read_study_walls(file.path, {}));
    CHECK(output.remarks.find(std::to_string(6 - n) + " of 6 walls have not been run yet") !=
          std::string::npos);
    CHECK(output.source.find(std::to_string(6 - n) + " not in this file") != std::string::npos);
}

TEST_CASE("fragility of a study: a shard is read as it is, with the walls that the whole has",
          "[app][fragility_study]")
{
    const File whole, part;
    run_study(whole.path, 6);
    run_study(part.path, 6, 4);
    const app::StudyWalls all = app::read_study_walls(whole.path, {});
    const app::StudyWalls shard = app::read_study_walls(part.path, {});
    CHECK(shard.name.ends_with(", shard 1 of 4"));
    std::size_t walls = 0;
    for (std::size_t l = 0; l < 2; ++l) {
        CHECK(shard.levels[l].walls.size() + shard.levels[l].missing == 3);
        for (const app::StudyWall& w : shard.levels[l].walls) {
            ++walls;
            const auto same = std::find_if(
                all.levels[l].walls.begin(), all.levels[l].walls.end(),
                [&](const app::StudyWall& x) { return x.key.sample == w.key.sample; });
            REQUIRE(same != all.levels[l].walls.end());
            CHECK(app::peak_force(w.reading) == app::peak_force(same->reading));
            CHECK(w.inputs == same->inputs);
        }
    }
    CHECK(walls == 2); // numbers 0 and 4 of 0 ... 5
    const auto output = app::study_output(shard);
    CHECK(output.source.find("shard 1 of 4: 2 walls, 4 not in this file") != std::string::npos);
    CHECK(output.remarks.find("drystone merge") != std::string::npos);
    CHECK(app::study_output(all).remarks.find("drystone merge") == std::string::npos);
}

TEST_CASE(
    "fragility of a study: its file is read although a default follows from a rounded mean",
    "[app][fragility_study]")
{
    const File file;
    const app::Study s = study_scenes::study("samples = 1");
    const dem::Model model = app::model_of(app::prepare(s));
    const std::vector<std::uint32_t> sizes = {1};
    app::StoreHead head = app::head_of(
        s, model.layout, sample_plan(s, s.load, s.source, model.layout, sizes), sizes);
    const std::size_t at = head.configuration.find("residual_friction_angle");
    REQUIRE(at != std::string::npos);
    const std::size_t end = head.configuration.find('\n', at);
    head.configuration.replace(at, end - at, "residual_friction_angle = 89 deg  # default");
    app::Store(file.path, head).compact();
    CHECK(app::read_study_walls(file.path, {}).levels.size() == 2);
}

TEST_CASE("fragility of a study: only its own keys can be set", "[app][fragility_study]")
{
    const File file;
    run_study(file.path, 0);
    const std::vector<std::string> good = {"fragility.limit_states=ec8"}, bad = {"uq.seed=2"};
    CHECK(app::read_study_walls(file.path, good).states.size() == 3);
    CHECK_THROWS_AS(app::read_study_walls(file.path, bad), app::ConfigError);
}

TEST_CASE(
    "fragility of a table: the command writes a folder, refuses what a study has and lacks",
    "[app][fragility_study]")
{
    const scenes::TemporaryFolder temporary;
    const fs::path& folder = temporary.path;
    const std::string csv = (folder / "walls.csv").string(), out = (folder / "out").string();
    std::ofstream(csv) << "drift [%],stopped,mode\n1.0,0,a\n2.0,1,a\n1.5,no,a\n0.8,0,b\n";
    CHECK(run({"fragility", csv, "--drift", "drift", "--censored", "stopped", "--group", "mode",
               "--set", "fragility.bootstrap=100", "--out", out}) == 0);
    CHECK(fs::exists(folder / "out" / "performance_limits.csv"));
    CHECK_THROWS_WITH(run({"fragility", csv, "--out", out}),
                      Catch::Contains("--drift: missing"));
    CHECK_THROWS_WITH(run({"fragility", "x.h5", "--drift", "d", "--out", out}),
                      Catch::Contains("a study has no columns"));
    CHECK_THROWS_WITH(run({"fragility", csv, "--drift", "drift", "--set",
                           "fragility.crossing=last", "--out", out}),
                      Catch::Contains("for a table, only"));
    CHECK_THROWS_WITH(run({"fragility", csv, "--drift", "drift", "--set",
                           "fragility.bootstrap=99", "--out", out}),
                      Catch::Contains("fragility.bootstrap: 99 samples cannot reject a law"));
    CHECK_THROWS_WITH(run({"fragility", csv, "--intensity", "drift", "--state", "stopped",
                           "--set", "fragility.law=weibull", "--out", out}),
                      Catch::Contains("fragility.law: has no effect on counts"));
}

TEST_CASE(
    "fragility of a study: the mode of a finite push is read at ultimate_share, which is part "
    "of the study then",
    "[app][fragility_study]")
{
    const std::string text = study_scenes::kSmall;
    const std::string small = text + "kinematics = small\n"; // its last section is the solver's
    const auto with_share = [&](const std::string& base, const std::string& share) {
        return study_scenes::study("samples = 1\n[fragility]\nultimate_share = " + share, base);
    };
    CHECK(app::push_plan(with_share(text, "0.7")).drop == 0.7);
    CHECK(app::push_plan(with_share(text, "0.8")).drop == 0.8);
    CHECK(app::push_plan(with_share(small, "0.7")).drop == 0.0);
    CHECK(app::identity_text(with_share(text, "0.7")) !=
          app::identity_text(with_share(text, "0.8")));
    // small displacements: the facts that are stored know nothing of it
    CHECK(app::identity_text(with_share(small, "0.7")) ==
          app::identity_text(with_share(small, "0.8")));
}

TEST_CASE("fragility of a table: without a column of drifts the message names those there are",
          "[app][fragility_study]")
{
    const scenes::TemporaryFolder folder;
    const std::string table = (folder.path / "walls.csv").string();
    std::ofstream(table) << "wall,drift [%]\nA,1.5\n";
    CHECK_THROWS_WITH(run({"fragility", table, "--out", (folder.path / "out").string()}),
                      Catch::Contains("its columns are \"wall\", \"drift [%]\""));
    CHECK_FALSE(fs::exists(folder.path / "out"));
}
