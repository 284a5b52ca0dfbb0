#include "dem/scene/mechanism/rigid_wall.hpp"

#include <catch2/catch.hpp>

#include <cmath>

namespace {

/// Ten courses of 0.4 kN on a fixed base, under a beam of 0.5 kN.
struct Wall {
    dem::WallGeometry geometry;
    dem::Beam beam;
    dem::Elastic stone{.density = 2000.0};
    dem::Loads loads;
    Wall()
    {
        beam.material.density = 2500.0;
        loads.gravity = 10.0;
        loads.vertical_stress = 0.5e6;
        loads.height = 1.1;
    }
};

} // namespace

TEST_CASE("rigid wall: turning about the toe and sliding on the weakest bed joint, by hand",
          "[dem][rigid_wall]")
{
    Wall w;
    const dem::RigidWall fixed =
        dem::rigid_wall(w.geometry, w.beam, w.stone, w.loads, {0.1, 0.1, 0.1});
    CHECK(fixed.turning == 9);
    CHECK(fixed.vertical_load == Approx(100.5e3));
    CHECK(fixed.weight == Approx(3.6e3));
    CHECK(fixed.rocking_limit == Approx(104.1e3 * 0.5 / 1.0));
    CHECK(fixed.sliding_limit == Approx(0.1 * 100.9e3));
    w.geometry.base = dem::Base::joint;
    const dem::RigidWall free =
        dem::rigid_wall(w.geometry, w.beam, w.stone, w.loads, {0.1, 0.1, 0.1});
    CHECK(free.turning == 10);
    CHECK(free.rocking_limit == Approx(104.5e3 * 0.5 / 1.1));
}

TEST_CASE(
    "rigid wall: it slides where friction gives way first, on its base or under its beam too",
    "[dem][rigid_wall]")
{
    Wall w;
    const dem::WallFriction friction{0.6, 0.2, 0.1};
    const auto limit = [&] {
        return dem::rigid_wall(w.geometry, w.beam, w.stone, w.loads, friction).sliding_limit;
    };
    CHECK(limit() == Approx(0.6 * 100.9e3)); // neither base nor beam has a joint
    w.geometry.base = dem::Base::joint;
    CHECK(limit() == Approx(0.6 * 100.9e3)); // the toe is held
    w.geometry.toe = dem::Toe::free;
    CHECK(limit() == Approx(0.2 * 104.5e3));
    w.beam.interface = dem::BeamInterface::joint;
    CHECK(limit() == Approx(0.1 * 100.5e3));
}

TEST_CASE("rigid wall: body forces turn and push what lies above the lowest joint",
          "[dem][rigid_wall]")
{
    Wall w;
    w.loads.vertical_stress = 0.0;
    w.loads.pattern = dem::LoadPattern::body;
    const dem::RigidWall r =
        dem::rigid_wall(w.geometry, w.beam, w.stone, w.loads, {0.1, 0.1, 0.1}, 4.5e3);
    CHECK(r.rocking_limit == Approx(4.5e3 * 2.05 / (3.6 * 0.45 + 0.5 * 0.95)));
    CHECK(r.sliding_limit == Approx(0.1 * 4.5e3));
}

TEST_CASE("rigid wall: weights are those of the blocks, by what holds them",
          "[dem][rigid_wall]")
{
    const Wall w;
    const dem::Weights weights = dem::weights_of(dem::lay_out(w.geometry, w.beam.height),
                                                 w.stone, w.beam.material, w.loads.gravity);
    CHECK(weights.area == Approx(1.0));
    CHECK(weights.masonry == Approx(4.0e3));
    CHECK(weights.free == Approx(3.6e3));
    CHECK(weights.beam == Approx(0.5e3));
}

TEST_CASE("rigid wall: the centre of gravity is that of what is there, by its density",
          "[dem][rigid_wall]")
{
    Wall w; // 1 m x 1 m of 2000 kg/m3 under 0.1 m of 2500 kg/m3
    const auto height = [&] {
        return dem::gravity_height(dem::lay_out(w.geometry, w.beam.height), w.stone,
                                   w.beam.material);
    };
    CHECK(height() == Approx((2000.0 * 0.5 + 250.0 * 1.05) / 2250.0).epsilon(1e-14));
    w.geometry.openings = {{0.4, 0.2, 0.2, 0.3}}; // 0.06 m2 around 0.35 m
    w.geometry.lintel_bearing = 0.1;
    w.geometry.lintel = {30e9, 0.2, 2600.0}; // 600 kg/m3 more on 0.4 m x 0.1 m around 0.55 m
    CHECK(height() ==
          Approx((2000.0 * (0.5 - 0.06 * 0.35) + 600.0 * 0.04 * 0.55 + 250.0 * 1.05) /
                 (2000.0 * 0.94 + 600.0 * 0.04 + 250.0))
              .epsilon(1e-14));
    w.stone.density = w.geometry.lintel.density = w.beam.material.density = 0.0;
    CHECK(height() == 0.0);
}
