#include "dem/scene/mechanism/block_displacement.hpp"

#include "tests/scenes/snapshot_scenes.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <stdexcept>

TEST_CASE("block displacement: the ground does not move, a block moves as at its nearest point",
          "[dem][block_displacement]")
{
    const dem::Snapshot wall = scenes::stair_step_rocking(0.011); // turns by 0.01
    const int top_right = 99;
    const dem::Point u = dem::displacement_at(wall, top_right, {1.0, 1.0});
    CHECK(u.x == Approx(0.01).epsilon(1e-12));
    CHECK(std::abs(u.z) < 1e-15);
    CHECK(dem::displacement_at(wall, -1, {1.0, 0.0}).x == 0.0);
    CHECK_THROWS_AS(dem::displacement_at(wall, 1000, {0.0, 0.0}), std::out_of_range);
}
