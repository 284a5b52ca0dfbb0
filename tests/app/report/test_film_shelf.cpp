#include "app/report/film_shelf.hpp"
#include "app/report/report_choice.hpp"
#include "scenes/snapshot_scenes.hpp"

#include <catch2/catch.hpp>

#include <vector>

TEST_CASE("film shelf: it keeps the lowest sample numbers of each stress and mode, in whatever "
          "order they come",
          "[app][film_shelf]")
{
    scenes::SnapshotWall wall; // so many blocks that a page has room for few
    wall.courses = 100;
    wall.half_units = 40;
    const std::vector<dem::Snapshot> frames = {scenes::wall_at_rest(wall)};
    const auto most = static_cast<std::uint32_t>(app::walls_in_page(frames[0].blocks.size()));
    REQUIRE(most == app::kFewestFilmed);
    app::FilmShelf shelf;
    for (std::uint32_t i = 0; i < 3 * most; ++i) {
        const std::uint32_t sample = (7 * i) % (3 * most); // 0 to 3 most - 1, mixed up
        shelf.put({0, sample}, dem::FailureMode::rocking, frames);
        shelf.put({1, sample},
                  sample % 2 == 0 ? dem::FailureMode::rocking : dem::FailureMode::sliding,
                  frames);
    }
    for (std::uint32_t sample = 0; sample < 3 * most; ++sample) {
        CHECK((shelf.find({0, sample}) != nullptr) == (sample < most));
        CHECK((shelf.find({1, sample}) != nullptr) == (sample < 2 * most));
    }
    CHECK(shelf.find({2, 0}) == nullptr);
}
