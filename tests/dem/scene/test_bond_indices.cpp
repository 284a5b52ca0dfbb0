#include "dem/scene/bond_indices.hpp"

#include "dem/scene/drawn_layout.hpp"
#include "dem/scene/rubble.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <stdexcept>

namespace {

/// Bond indices of the paper's wall, with whole units.
dem::BondIndices indices_of(double bond_offset, int courses = 10)
{
    dem::WallGeometry wall;
    wall.courses = courses;
    wall.bond_offset = bond_offset;
    wall.cracks.pattern.kind = dem::CrackPattern::Kind::none;
    return dem::bond_indices(dem::lay_out(wall, 0.1));
}

} // namespace

TEST_CASE("bond indices: running bond by hand, stack bond has straight joints",
          "[dem][bond_indices]")
{
    const dem::BondIndices running = indices_of(0.5);
    CHECK(running.trace == Approx(1.9)); // ten head joints of 0.1 m, nine half units of 0.1 m
    CHECK(running.trace_ratio == Approx(1.9));
    CHECK(running.level_trace_ratio == Approx(1.0));
    CHECK(running.least_overlap == Approx(1.0)); // half of 200 mm over 100 mm
    CHECK(running.mean_overlap == Approx(1.0));
    CHECK(running.mean_length == Approx(10.0 / 55.0));
    CHECK(running.mean_height == Approx(0.1));
    const dem::BondIndices quarter = indices_of(0.25);
    CHECK(quarter.trace == Approx(1.45));
    CHECK(quarter.least_overlap == Approx(0.5));
    const dem::BondIndices stack = indices_of(0.0);
    CHECK(stack.trace_ratio == Approx(1.0));
    CHECK(stack.least_overlap == Approx(0.0).margin(1e-12));
    CHECK(std::isnan(indices_of(0.5, 1).mean_overlap));
}

TEST_CASE("bond indices: from side to side, longer through rubble, without overlaps",
          "[dem][bond_indices]")
{
    dem::DrawnWall wall;
    for (const dem::Outline& stone : dem::rubble({.length = 1.2, .height = 1.0}))
        wall.units.push_back({stone, 0});
    const dem::BondIndices rubble = dem::bond_indices(dem::drawn_layout(wall, 0.0));
    CHECK(rubble.level_trace_ratio > 1.01);
    CHECK(rubble.trace_ratio > 1.01);
    CHECK(std::isnan(rubble.least_overlap));
}

TEST_CASE("bond indices: units that are in pieces are refused", "[dem][bond_indices]")
{
    CHECK_THROWS_AS(dem::bond_indices(dem::lay_out({}, 0.1)), std::invalid_argument);
}
