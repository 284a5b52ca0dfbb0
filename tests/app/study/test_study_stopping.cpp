#include "app/study/study_stopping.hpp"

#include "app/reading/wall_numbers.hpp"
#include "app/wall_scenes.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <string>
#include <string_view>

namespace {

/// Walls that fall at 10.0, 10.1, ... mm, and walls that stand at the end of the push, at 30
/// mm.
app::StudyWalls walls_of(int fell, int stood, std::string_view response, double half_width)
{
    app::StudyWalls study;
    study.levels = {scenes::level(0.5e6)};
    for (int i = 0; i < fell + stood; ++i)
        study.levels[0].walls.push_back(
            scenes::read_wall({0, static_cast<std::uint32_t>(i)}, 40e3,
                              i < fell ? 0.010 + 1e-4 * i : 0.030, i >= fell));
    const auto row = std::ranges::find(app::kWallNumbers, response, &app::WallNumber::name);
    study.study.uq.stop = static_cast<int>(row - app::kWallNumbers.begin());
    study.study.uq.samples = fell + stood;
    study.study.uq.stop_half_width = half_width;
    study.study.load.height = 1.0;
    return study;
}

bool says(const app::StoppingState& s, const std::string& what)
{
    return s.remark.find(what) != std::string::npos;
}

} // namespace

TEST_CASE(
    "study stopping: walls that outlast the push do not count as if they had fallen there",
    "[app][study_stopping]")
{
    // 21 of 30 stand at 30 mm: the mean of all numbers is narrow, the median is not known
    const auto response = GENERATE("ultimate_displacement", "ultimate_drift");
    const app::StoppingState s = app::stopping_state(walls_of(9, 21, response, 0.3));
    CHECK(s.next == 45);
    CHECK(says(s, "21 of them outlast the push"));
    CHECK(says(s, "median: its interval has no limit"));
}

TEST_CASE("study stopping: a median that walls fix ends the study, by the interval of ranks",
          "[app][study_stopping]")
{
    // 40 of 44 fell: the ranks of the 95 % interval of the median of 44 are 16 and 29
    const app::StudyWalls walls = walls_of(40, 4, "ultimate_displacement", 0.08);
    const app::StoppingState s = app::stopping_state(walls);
    CHECK(s.next == 0);
    CHECK(says(s, "4 of them outlast the push"));
    const double median = 0.010 + 21e-4, upper = 0.010 + 28e-4, lower = 0.010 + 15e-4;
    const double half = std::max(upper - median, median - lower) / median;
    CHECK(says(s, "half width 0.0579 "));
    CHECK(half == Approx(0.0579).margin(5e-5));
    CHECK(app::stopping_state(walls_of(40, 4, "ultimate_displacement", 0.057)).next == 66);
}

TEST_CASE("study stopping: peaks that still rise at the end are bounds of their displacement",
          "[app][study_stopping]")
{
    app::StudyWalls walls = walls_of(30, 0, "peak_displacement", 0.3);
    CHECK(app::stopping_state(walls).next == 0);
    for (app::StudyWall& w : walls.levels[0].walls) w.reading.peak->at_end = true;
    CHECK(app::stopping_state(walls).next == 45);
    walls.study.uq.stop = 0; // the peak force itself: its mean, as in the tables
    CHECK(app::stopping_state(walls).next == 0);
}

TEST_CASE("study stopping: no study ends at fewer than ten walls, however narrow they lie",
          "[app][study_stopping]")
{
    app::StudyWalls walls = walls_of(3, 0, "peak_force", 0.3);
    CHECK(app::stopping_state(walls).next == 10);
    walls.study.uq.most_samples = 6; // the limit of walls is the user's
    CHECK(app::stopping_state(walls).next == 6);
    CHECK(app::stopping_state(walls_of(10, 0, "peak_force", 0.3)).next == 0);
}
