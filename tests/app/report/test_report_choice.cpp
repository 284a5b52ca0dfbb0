#include "app/report/report_choice.hpp"
#include "app/report/report_replay.hpp"
#include "app/wall_scenes.hpp"

#include <catch2/catch.hpp>

#include <cstdint>
#include <string>
#include <vector>

using Places = std::vector<std::size_t>;

namespace {

/// Two stresses, ten samples each; 0 failed, 7 rocked.
app::StudyWalls twenty_walls()
{
    app::StudyWalls study;
    for (std::uint32_t level = 0; level < 2; ++level) {
        study.levels.push_back(scenes::level(1e6));
        for (std::uint32_t sample = 0; sample < 10; ++sample) {
            app::StudyWall w = scenes::read_wall({level, sample}, 1e3, 0.01, true,
                                                 sample == 7 ? dem::FailureMode::rocking
                                                             : dem::FailureMode::mixed);
            w.failed = sample == 0;
            (w.failed ? study.levels[level].failed_walls : study.levels[level].walls)
                .push_back(w);
        }
    }
    return study;
}

/// 10 x level + sample of each wall.
Places places(const app::WallList& walls)
{
    Places found;
    for (const app::StudyWall* w : walls) found.push_back(10 * w->key.level + w->key.sample);
    return found;
}

} // namespace

TEST_CASE("report choice: of many walls, of each stress as many are listed, failed ones too",
          "[app][report_choice]")
{
    const app::StudyWalls study = twenty_walls();
    CHECK(places(app::walls_to_list(study, 6)) == Places{0, 1, 2, 10, 11, 12});
    CHECK(app::walls_to_list(study, 20).size() == 20);
    CHECK(app::walls_to_list({}, 20).empty());
}

TEST_CASE("report choice: walls are shown in turns from each stress and mode",
          "[app][report_choice]")
{
    const app::StudyWalls study = twenty_walls();
    const app::WallList all = app::walls_to_list(study, 100);
    CHECK(places(app::walls_to_show(all, 4)) == Places{7, 1, 17, 11});
    CHECK(places(app::walls_to_show(all, 7)) == Places{7, 1, 17, 11, 2, 12, 3});
    CHECK(app::walls_to_show(all, 100).size() == 18);
    CHECK(app::walls_to_show(all, 0).empty());
}

TEST_CASE("report choice: only walls that are listed are shown", "[app][report_choice]")
{
    const app::StudyWalls study = twenty_walls();
    CHECK(places(app::walls_to_show(app::walls_to_list(study, 6), 100)) ==
          Places{1, 11, 2, 12});
}

TEST_CASE("report choice: films that a page has no room for are left out, the last first",
          "[app][report_choice]")
{
    app::Replay replay;
    const app::StudyWalls study = twenty_walls();
    replay.walls = app::walls_to_list(study, 3);
    for (int i = 0; i < 3; ++i) replay.films.push_back({61, 1e-5, std::string(1000, 'x')});
    const std::size_t each = 1000 + app::kFilmEntryBytes;
    app::keep_first(replay, 3 * each);
    CHECK(replay.films.size() == 3);
    app::keep_first(replay, 3 * each - 1);
    CHECK(places(replay.walls) == Places{0, 1});
    app::keep_first(replay, 10);
    CHECK(replay.walls.empty());
}
