#include "dem/solver/state/energy.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>

using dem::Energy;

TEST_CASE("energy: a ledger that balances has no residual, each entry counted once",
          "[dem][energy]")
{
    Energy e;
    e.kinetic = 1.0;
    e.elastic = 20.0;
    e.friction = 300.0;
    e.fracture = 4000.0;
    e.damping = 50000.0;
    e.work = 54321.0;
    CHECK(e.residual() == 0.0);
}

TEST_CASE("energy: the residual is the share of the work not found", "[dem][energy]")
{
    Energy e;
    e.work = 100.0;
    e.friction = 99.0;
    CHECK(e.residual() == Approx(0.01).epsilon(1e-14));
    e.friction = 125.0; // more found than put in: a share of what was found
    CHECK(e.residual() == Approx(-0.2).epsilon(1e-14));
}

TEST_CASE("energy: what the drive has put into weight and load has passed through the wall too",
          "[dem][energy]")
{
    Energy e; // the drive has done 1000 J, of which 900 J lifted the load
    e.work = 100.0;
    e.friction = 99.0;
    e.lifted = 900.0;
    CHECK(e.residual() == Approx(1e-3).epsilon(1e-14));
}

TEST_CASE("energy: a load that has sunk gives back no share of the scale", "[dem][energy]")
{
    Energy e; // the load has done 40 J of it
    e.work = 100.0;
    e.friction = 99.0;
    e.lifted = -40.0;
    CHECK(e.residual() == Approx(0.01).epsilon(1e-14));
    CHECK(e.stored() == -40.0);
}

TEST_CASE("energy: work given back counts with its sign", "[dem][energy]")
{
    Energy e;
    e.work = -8.0; // a wall that unloads against the drive
    e.elastic = 3.0;
    CHECK(e.residual() == Approx(-11.0 / 8.0).epsilon(1e-14));
}

TEST_CASE("energy: nothing done leaves no residual", "[dem][energy]")
{
    CHECK(Energy{}.residual() == 0.0);
}

TEST_CASE("energy: a broken entry breaks the residual, whichever it is", "[dem][energy]")
{
    double Energy::*entry =
        GENERATE(&Energy::work, &Energy::kinetic, &Energy::elastic, &Energy::friction,
                 &Energy::fracture, &Energy::damping, &Energy::lifted);
    Energy e;
    e.work = e.elastic = 1.0;
    e.*entry = std::numeric_limits<double>::quiet_NaN();
    CHECK(std::isnan(e.residual()));
}
