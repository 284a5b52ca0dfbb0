/// load.direction: pushes to the right, to the left, and both.

#include "app/input/key_effects.hpp"
#include "app/input/prepared_study.hpp"
#include "app/input/study_reading.hpp"
#include "app/input/verb.hpp"
#include "app/input/wall/wall_geometry.hpp"
#include "app/study/other_way.hpp"
#include "app/study/pushed/push_walls.hpp"
#include "app/study/stored/study_identity.hpp"
#include "tests/app/push_scenes.hpp"
#include "tests/app/study_texts.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace {

using Overrides = std::vector<std::string>;
using scenes::pushed;

app::Study with(Overrides overrides, const Overrides& more)
{
    overrides.insert(overrides.end(), more.begin(), more.end());
    return study_texts::read(study_texts::kSmallWall, overrides);
}

const Overrides kDoor = {"wall.openings=0.10 m, 0 m, 0.10 m, 0.20 m"},
                kMirroredDoor = {"wall.openings=0.40 m, 0 m, 0.10 m, 0.20 m"};

} // namespace

TEST_CASE("direction: left mirrors every displacement and the toe that is held",
          "[app][direction]")
{
    const app::Study left = with({"load.direction=left"}, {});
    CHECK(app::push_way(left.load).direction == -1);
    CHECK(app::push_plan(left).targets == std::vector{-1e-3});
    const dem::Layout layout = study_texts::laid(left);
    CHECK(std::ranges::count(layout.blocks, dem::Motion::held_left_corner,
                             &dem::Block::motion) == 1);
    CHECK(layout.blocks.front().motion == dem::Motion::held_left_corner);
    const app::Study cycles = with({"load.direction=left", "load.amplitudes=1 mm"}, {});
    CHECK(app::push_plan(cycles).targets == std::vector{-1e-3, 1e-3, 0.0});
    const app::Study back = with({"load.direction=left", "load.targets=-1 mm"}, {});
    CHECK(app::push_way(back.load).direction == 1);
    CHECK_FALSE(back.wall.toe_at_left);
}

TEST_CASE("direction: a wall pushed to the left is its mirror image pushed to the right",
          "[app][direction]")
{
    const Overrides base = {GENERATE("wall.base=joint", "wall.base=fixed"),
                            GENERATE("solver.fidelity=rigid", "solver.fidelity=simple"),
                            "solver.accuracy=1 %"};
    const app::PushedWall right = pushed(with(kDoor, base));
    Overrides to_the_left = base;
    to_the_left.emplace_back("load.direction=left");
    const app::PushedWall left = pushed(with(kMirroredDoor, to_the_left));
    REQUIRE(right.force.size() == left.force.size());
    const double peak = peak_force(right.reading);
    for (std::size_t i = 0; i < right.force.size(); ++i)
        CHECK(std::abs(right.force[i] + left.force[i]) < 3e-3 * peak);
    CHECK(peak_force(left.reading) == Approx(peak).epsilon(1e-3));
}

TEST_CASE(
    "direction: both is worked out where the mirrored wall is another one, and nowhere else",
    "[app][direction]")
{
    CHECK(app::has_other_way(with(kDoor, {}).load, study_texts::laid(with(kDoor, {}))));
    const app::Study symmetric = with({"load.direction=both"}, {});
    CHECK_FALSE(app::has_other_way(symmetric.load, study_texts::laid(symmetric)));
}

TEST_CASE("direction: the worse of both is taken number by number, and says which it was",
          "[app][direction]")
{
    const app::Study study = with(kDoor, {});
    app::PushedWall wall;
    wall.reading.peak = fragility::Peak{80e3, 0.01, false};
    const auto at = [](double d) {
        return fragility::LimitDisplacement{d, fragility::Reading::observed, {}};
    };
    wall.reading.limits = {at(0.02), at(0.01), at(0.005)};
    wall.reading.mode = dem::FailureMode::rocking;
    CHECK(peak_force(app::worse_way(wall)) == 80e3);
    CHECK(app::worse_way_name(1, wall, 0) == "right");
    app::PushedWall other = wall;
    other.reading.peak->force = 50e3;
    other.reading.limits = {at(0.015), at(0.02), at(0.005)};
    other.reading.mode = dem::FailureMode::sliding;
    other.reading.mode_so_far = true;
    wall.other_way.push_back(other);
    const app::WallReading worse = app::worse_way(wall);
    CHECK(peak_force(worse) == 50e3);
    CHECK(worse.mode == dem::FailureMode::sliding);
    CHECK(worse.mode_so_far);
    CHECK(worse.limits[0].displacement == 0.015);
    CHECK(worse.limits[1].displacement == 0.01);
    CHECK(app::worse_way_name(1, wall, 0) == "left");
    CHECK(app::worse_way_name(1, wall, 1) == "right");
    CHECK(app::worse_way_name(1, wall, 2) == "both");
}

TEST_CASE("direction: right is no part of a study's identity, left and a toe at the left are",
          "[app][direction]")
{
    const std::string none = identity_text(with({}, {}));
    CHECK(identity_text(with({"load.direction=right"}, {})) == none);
    CHECK(identity_text(with({"load.direction=left"}, {})) != none);
    CHECK(identity_text(with({"load.targets=-1 mm"}, {})).find("toe_at_left") !=
          std::string::npos);
    CHECK(effective_configuration(with({}, {})).find("direction") == std::string::npos);
}

TEST_CASE("direction: a reliability analysis of a wall that is not symmetric refuses both",
          "[app][direction]")
{
    const app::Verb verb{.name = "reliability", .sections = app::kWallSections};
    const Overrides both = {"load.direction=both"};
    CHECK_THROWS_WITH(app::study_notes(app::prepare(with(kDoor, both)), &verb),
                      Catch::Contains("load.direction") &&
                          Catch::Contains("write right or left"));
    CHECK_NOTHROW(app::study_notes(app::prepare(with({}, both)), &verb));
    CHECK_NOTHROW(app::study_notes(app::prepare(with(kDoor, {"load.direction=left"})), &verb));
}
