#include "dem/scene/mechanism/snapshot_reading.hpp"

#include <catch2/catch.hpp>

#include <cmath>

namespace {

/// Two blocks on the ground and the crack between them.
dem::Snapshot wall_with(dem::FaceKind kind, const std::vector<dem::ContactState>& contacts)
{
    dem::Snapshot wall;
    wall.blocks.resize(2);
    wall.blocks[0].course = 1;
    wall.faces.push_back({kind, 1, 0, 1, {0.0, 1.0}, {0.0, 1.0}, contacts});
    return wall;
}

} // namespace

TEST_CASE("snapshot reading: compression counts what presses, by its area",
          "[dem][snapshot_reading]")
{
    const dem::Snapshot wall =
        wall_with(dem::FaceKind::bed_joint, {{.area = 0.01, .sigma = -2e5},
                                             {.area = 0.02, .sigma = 1e5},
                                             {.area = 0.03, .sigma = -1e5}});
    CHECK(dem::compression_of(wall.faces[0]) == Approx(5e3));
    CHECK(dem::largest_compression(wall) == Approx(5e3));
    CHECK(dem::toe_stress(wall, dem::Base::fixed).value() == 2e5);
    CHECK_FALSE(dem::toe_stress(wall, dem::Base::joint).has_value()); // no joint on the ground
}

TEST_CASE("snapshot reading: a contact slides where it is closed and its slip is beyond the "
          "threshold",
          "[dem][snapshot_reading]")
{
    const std::vector<dem::ContactState> contacts = {
        {.slip = -0.02}, {.opening = 0.01, .slip = 0.03}, {.slip = 0.0004}};
    dem::Snapshot wall = wall_with(dem::FaceKind::bed_joint, contacts);
    CHECK(dem::largest_slip(wall, 5e-4) == 0.02);
    CHECK(dem::largest_movement(wall) == 0.03);
    wall.faces[0].kind = dem::FaceKind::unit_crack;
    CHECK(dem::largest_slip(wall, 5e-4) == 0.0);
    wall.blocks[1].displacement = {{0.0, 0.0}, {0.003, -0.004}};
    CHECK(dem::largest_displacement(wall) == Approx(0.005));
}

TEST_CASE("snapshot reading: cracked through where every contact is, crushed where one is",
          "[dem][snapshot_reading]")
{
    dem::Snapshot wall =
        wall_with(dem::FaceKind::unit_crack, {{.damage = 1.0}, {.damage = 0.99}});
    CHECK_FALSE(dem::is_cracked_through(wall.faces[0]));
    CHECK_FALSE(dem::any_crushed(wall));
    wall.faces[0].contacts[1] = {.damage = 1.0, .crushed = 1e-6};
    CHECK(dem::is_cracked_through(wall.faces[0]));
    CHECK(dem::any_crushed(wall));
    CHECK_FALSE(dem::is_cracked_through({}));
}

TEST_CASE("snapshot reading: a joint has slid far by a share of its own length",
          "[dem][snapshot_reading]")
{
    dem::Snapshot wall = wall_with(dem::FaceKind::head_joint,
                                   {{}, {.at = {0.1, 0.0}, .slip = -0.026, .sigma = -1e6}});
    const auto joint = dem::slid_joint(wall, 0.25);
    REQUIRE(joint.has_value());
    CHECK(joint->length == 0.1);
    CHECK(joint->slip == 0.026);
    CHECK_FALSE(dem::slid_joint(wall, 0.27).has_value());
    wall.faces[0].contacts[1].sigma = 0.0; // an open joint carries nothing
    CHECK_FALSE(dem::slid_joint(wall, 0.25).has_value());
}

TEST_CASE(
    "snapshot reading: the strength is used up at the tensile strength and on the Coulomb line",
    "[dem][snapshot_reading]")
{
    const dem::CrackMaterial crack{.ft = 1e6, .cohesion = 2e6, .tan_phi = 0.5};
    CHECK(dem::strength_used({.sigma = 0.5e6}, crack) == Approx(0.5));
    CHECK(dem::strength_used({.sigma = -2e6, .tau = -3e6}, crack) == Approx(1.0));
    CHECK(dem::strength_used({.sigma = -2e6}, crack) == 0.0);
    CHECK(std::isinf(dem::strength_used({.sigma = 4e6}, crack)));
}
