/// The energy balance of a history.

#include "dem/shaking/history_ledger.hpp"

#include <catch2/catch.hpp>

#include <limits>

namespace {

dem::HistoryEnergy moving(double work, double kinetic)
{
    dem::HistoryEnergy e;
    e.all.work = work;
    e.all.kinetic = kinetic;
    e.all.friction = work - kinetic;
    return e;
}

} // namespace

TEST_CASE("history ledger: a wall is still where nothing moves at two readings",
          "[dem][shaking][history_ledger]")
{
    dem::HistoryLedger ledger(0.0, 1.0);
    REQUIRE(ledger.read(moving(10.0, 5.0)));
    CHECK_FALSE(ledger.still());
    REQUIRE(ledger.read(moving(10.0, 0.0))); // a swing turns
    CHECK_FALSE(ledger.still());
    REQUIRE(ledger.read(moving(10.0, 5.0)));
    REQUIRE(ledger.read(moving(10.0, 0.0)));
    CHECK_FALSE(ledger.still());
    REQUIRE(ledger.read(moving(10.0, 4e-8)));
    CHECK(ledger.still());
}

TEST_CASE("history ledger: the error is the largest so far, over the energy that passed",
          "[dem][shaking][history_ledger]")
{
    dem::HistoryLedger ledger(2.0, 1.0); // 2 J are stored, and count as nothing that passed
    dem::HistoryEnergy e = moving(2.5, 0.0);
    e.all.friction += 0.1;
    REQUIRE(ledger.read(e));
    CHECK(ledger.residual() == Approx(0.1));
    REQUIRE(ledger.read(moving(12.0, 1.0)));
    CHECK(ledger.residual() == Approx(0.1 / 10.0));
    e = moving(12.0, 1.0);
    e.ground_work = -40.0;
    REQUIRE(ledger.read(e));
    CHECK(ledger.residual() == Approx(0.1 / 40.0));
    e.all.kinetic = std::numeric_limits<double>::quiet_NaN();
    CHECK_FALSE(ledger.read(e));
}
