#include "dem/block/build_cost.hpp"

#include "dem/scene/layout.hpp"

#include <catch2/catch.hpp>

#include <tuple>

namespace {

/// 0.4 m of three courses, blocks that stay rigid.
dem::BuildCost cost(int contact_points, double course_height, int modes = 3)
{
    dem::WallGeometry wall;
    wall.length = 0.4;
    wall.courses = 3;
    wall.course_height = course_height;
    wall.unit_length = 0.2;
    wall.thickness = 0.2;
    dem::Discretisation d;
    d.contact_points = contact_points;
    d.zones_per_interval = 2;
    d.block_modes = modes;
    d.beam_modes = modes;
    return dem::build_cost(dem::lay_out(wall, 0.1), d);
}

} // namespace

TEST_CASE("build cost: within a factor of three of what was measured", "[dem][build_cost]")
{
    // core seconds and MB of a push of 0.2 mm, without the 18 MB and 0.01 s of the program
    const auto [points, height, seconds, megabytes] =
        GENERATE(table<int, double, double, double>({{20, 0.1, 1.0, 76.0},
                                                     {30, 0.1, 4.1, 247.0},
                                                     {40, 0.1, 14.1, 568.0},
                                                     {5, 2.0, 1.2, 30.0},
                                                     {5, 4.0, 13.8, 125.0},
                                                     {5, 7.0, 32.0, 360.0},
                                                     {5, 10.0, 67.0, 687.0}}));
    INFO(points << " points, " << height << " m");
    const dem::BuildCost c = cost(points, height);
    CHECK(c.seconds > seconds / 3.0);
    CHECK(c.seconds < seconds * 3.0);
    CHECK(c.bytes > 1e6 * megabytes / 3.0);
    CHECK(c.bytes < 1e6 * megabytes * 3.0);
}

TEST_CASE("build cost: ordinary walls cost next to nothing, and finer blocks more",
          "[dem][build_cost]")
{
    CHECK(cost(5, 0.1).seconds < 0.1);
    CHECK(cost(5, 0.1, 12).seconds < 0.5);
    for (const int points : {10, 20, 30}) {
        CHECK(cost(points + 10, 0.1).seconds > 2.0 * cost(points, 0.1).seconds);
        CHECK(cost(points + 10, 0.1).bytes > 1.5 * cost(points, 0.1).bytes);
    }
}

TEST_CASE("build cost: a high beam on a short wall is told, and that it is the beam",
          "[dem][build_cost]")
{
    // core seconds and MB of a push of 0.01 mm of one course of units of 10 mm under a beam of
    // 5 m
    const auto [length, seconds, megabytes] =
        GENERATE(table<double, double, double>({{0.01, 1.6, 560.0}, {0.02, 5.8, 1300.0}}));
    dem::WallGeometry wall;
    wall.length = length;
    wall.courses = 1;
    wall.course_height = 0.01;
    wall.unit_length = 0.01;
    const dem::BuildCost c =
        dem::build_cost(dem::lay_out(wall, 5.0), dem::discretisation_of(dem::Fidelity::simple));
    CHECK(c.beam);
    CHECK(c.seconds > seconds / 2.0);
    CHECK(c.seconds < seconds * 2.0);
    CHECK(c.bytes > 1e6 * megabytes / 1.5);
    CHECK(c.bytes < 1e6 * megabytes * 1.5);
    CHECK_FALSE(cost(5, 10.0).beam);
}
