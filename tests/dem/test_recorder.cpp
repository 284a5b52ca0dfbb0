#include "dem/solver/recorder.hpp"

#include <catch2/catch.hpp>

#include <vector>

using dem::Recorder;

TEST_CASE("recorder: a point is due once the way since the last one is long enough",
          "[dem][recorder]")
{
    Recorder r(1.0);
    CHECK_FALSE(r.any());
    CHECK_FALSE(r.due());
    r.add(0.0, 1, 1, 1); // waiting is no way
    CHECK_FALSE(r.any());
    r.add(0.5, 1, 1, 1);
    CHECK(r.any());
    CHECK_FALSE(r.due());
    r.add(-0.5, 1, 1, 1); // back is way too
    CHECK(r.due());
    (void)r.take(0.0, {});
    CHECK_FALSE(r.any());
    CHECK_FALSE(r.due());
    r.add(1.0, 1, 1, 1); // the spacing is kept
    CHECK(r.due());
}

TEST_CASE("recorder: after a turn points are closer as far as two of the usual ones reach",
          "[dem][recorder]")
{
    Recorder r(1.0);
    r.begin_way();
    double way = 0.0;
    int points = 0;
    for (; way < 4.0 - 1e-9; way += 1.0 / 64.0) {
        r.add(1.0 / 64.0, 1, 1, 1);
        if (!r.due()) continue;
        (void)r.take(way, {});
        ++points;
    }
    CHECK(points == 2 * 16 + 2);
}

TEST_CASE("recorder: forces of a point are means over the way, not over the steps",
          "[dem][recorder]")
{
    Recorder r(1.0);
    r.add(1.0, 10, 20, 4); // mean force 15
    r.add(3.0, 20, 30, 8); // 25
    const dem::CurvePoint p = r.take(4.0, {});
    CHECK(p.force == Approx((15 * 1.0 + 25 * 3.0) / 4).epsilon(1e-14));
    CHECK(p.base_shear == Approx((4 * 1.0 + 8 * 3.0) / 4).epsilon(1e-14));
}

TEST_CASE("recorder: unbalance is the size of the gap, whichever of the two is larger",
          "[dem][recorder]")
{
    Recorder r(1.0);
    r.add(1.0, 0, 10, 7);   // +3
    r.add(1.0, 10, 10, 15); // -5
    CHECK(r.take(2.0, {}).unbalance == Approx(4.0).epsilon(1e-14));
}

TEST_CASE("recorder: force times way over all points is the work of the drive",
          "[dem][recorder]")
{
    const auto force = [](double x) { return 1000.0 * x - 300.0 * x * x; };
    Recorder r(0.1);
    double x = 0.0, work = 0.0, from_points = 0.0;
    for (int i = 0; i < 997; ++i) {
        const double step = 1e-3 * (1 + i % 3);
        work += 0.5 * (force(x) + force(x + step)) * step;
        r.add(step, force(x), force(x + step), 0);
        x += step;
        if (r.due() || i == 996) {
            const dem::CurvePoint p = r.take(x, {});
            // Twice the way from the point to the end of its interval is its length.
            from_points += p.force * 2.0 * (x - p.displacement);
        }
    }
    CHECK(from_points == Approx(work).epsilon(1e-12));
}

TEST_CASE("recorder: a point sits in the middle of its interval", "[dem][recorder]")
{
    Recorder r(1.0);
    r.add(0.75, 0, 0, 0);
    r.add(0.75, 0, 0, 0);
    CHECK(r.take(1.5, {}).displacement == 0.75);
    r.add(-1.0, 0, 0, 0); // the way back
    CHECK(r.take(0.5, {}).displacement == 1.0);
}

TEST_CASE("recorder: pulled to the left, a wall that resists has a negative force",
          "[dem][recorder]")
{
    Recorder r(1.0);
    r.add(-1.0, -10, -30, -20);
    const dem::CurvePoint p = r.take(-1.0, {});
    CHECK(p.displacement == -0.5);
    CHECK(p.force == -20.0);
    CHECK(p.base_shear == -20.0);
    CHECK(p.unbalance == 10.0);
}

TEST_CASE("recorder: the ledger of a point is the one given", "[dem][recorder]")
{
    Recorder r(1.0);
    r.add(1.0, 0, 0, 0);
    dem::Energy e;
    e.work = 7.0;
    CHECK(r.take(1.0, e).energy.work == 7.0);
}
