#include "dem/solver/state/recorder.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <vector>

using dem::Recorder;

TEST_CASE("recorder: a point is due once the way since the last one is long enough",
          "[dem][recorder]")
{
    Recorder r(1.0, 0.0);
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

TEST_CASE("recorder: points keep to their spacing, however the steps fall", "[dem][recorder]")
{
    Recorder r(1.0, 0.0);
    int points = 0;
    for (int step = 1; step <= 96; ++step) { // 60 intervals of 1
        r.add(0.625, 1, 1, 1);
        if (!r.due()) continue;
        (void)r.take(0.625 * step, {});
        ++points;
    }
    CHECK(points == 60);
}

TEST_CASE("recorder: after a turn points are closer as far as two of the usual ones reach",
          "[dem][recorder]")
{
    Recorder r(1.0, 0.0);
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

TEST_CASE("recorder: forces of a point are means over the way, not over the steps, and that of "
          "top and base is its force",
          "[dem][recorder]")
{
    Recorder r(1.0, 0.0);
    r.add(1.0, 10, 20, 4); // mean force 15
    r.add(3.0, 20, 30, 8); // 25
    const dem::CurvePoint p = r.take(4.0, {});
    const double top = (15 * 1.0 + 25 * 3.0) / 4;
    CHECK(p.force == Approx(0.5 * (top + p.base_shear)).epsilon(1e-14));
    CHECK(p.base_shear == Approx((4 * 1.0 + 8 * 3.0) / 4).epsilon(1e-14));
}

TEST_CASE("recorder: unbalance is the size of the gap, whichever of the two is larger",
          "[dem][recorder]")
{
    Recorder r(1.0, 0.0);
    r.add(1.0, 0, 10, 7);   // +3
    r.add(1.0, 10, 10, 15); // -5
    CHECK(r.take(2.0, {}).unbalance == Approx(4.0).epsilon(1e-14));
}

TEST_CASE(
    "recorder: force times way over all points is the work of the drive on a wall in balance",
    "[dem][recorder]")
{
    const auto force = [](double x) { return 1000.0 * x - 300.0 * x * x; };
    Recorder r(0.1, 0.0);
    double x = 0.0, work = 0.0, from_points = 0.0;
    for (int i = 0; i < 997; ++i) {
        const double step = 1e-3 * (1 + i % 3);
        work += 0.5 * (force(x) + force(x + step)) * step;
        r.add(step, force(x), force(x + step), 0.5 * (force(x) + force(x + step)));
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
    Recorder r(1.0, 0.0);
    r.add(0.75, 0, 0, 0);
    r.add(0.75, 0, 0, 0);
    CHECK(r.take(1.5, {}).displacement == 0.75);
    r.begin_way(); // and back
    r.add(-1.0, 0, 0, 0);
    CHECK(r.take(0.5, {}).displacement == 1.0);
}

TEST_CASE("recorder: pulled to the left, a wall that resists has a negative force",
          "[dem][recorder]")
{
    Recorder r(1.0, 0.0);
    r.add(-1.0, -10, -30, -20);
    const dem::CurvePoint p = r.take(-1.0, {});
    CHECK(p.displacement == -0.5);
    CHECK(p.force == -20.0);
    CHECK(p.base_shear == -20.0);
    CHECK(p.unbalance == 10.0);
}

TEST_CASE("recorder: the ledger of a point is the one given", "[dem][recorder]")
{
    Recorder r(1.0, 0.0);
    r.add(1.0, 0, 0, 0);
    dem::Energy e;
    e.work = 7.0;
    CHECK(r.take(1.0, e).energy.work == 7.0);
}

namespace {

/// Points of two steps each, from forces of top and base alike, one for each point.
std::vector<dem::CurvePoint> points_of(const std::vector<double>& forces, double still)
{
    Recorder r(1.0, still);
    std::vector<dem::CurvePoint> points;
    double x = 0.0;
    for (const double f : forces) {
        for (int i = 0; i < 2; ++i) r.add(0.5, f, f, f);
        x += 1.0;
        points.push_back(r.take(x, {}));
    }
    return points;
}

} // namespace

TEST_CASE(
    "recorder: where the force stands still a point is the mean over more steps, in order",
    "[dem][recorder]")
{
    std::vector<double> rings;
    for (int i = 0; i < 80; ++i) rings.push_back(i % 2 == 0 ? 100.4 : 99.6);
    const auto points = points_of(rings, 0.01);
    for (std::size_t i = 1; i < points.size(); ++i)
        CHECK(points[i].displacement > points[i - 1].displacement);
    CHECK(points.front().force == 100.4);
    for (std::size_t i = 60; i < points.size(); ++i)
        CHECK(points[i].force == Approx(100.0).margin(0.1));
    const auto alone = points_of(rings, 0.001); // they do not stand still
    for (std::size_t i = 0; i < alone.size(); ++i) {
        CHECK(alone[i].force == rings[i]);
        CHECK(alone[i].displacement == static_cast<double>(i) + 0.5);
    }
}

TEST_CASE("recorder: no point reaches back over a change of the force, or over a turn",
          "[dem][recorder]")
{
    std::vector<double> drops(40, 100.0);
    drops.resize(80, 90.0);
    const auto points = points_of(drops, 0.01);
    for (std::size_t i = 0; i < points.size(); ++i) CHECK(points[i].force == drops[i]);
    CHECK(points[40].displacement == 40.5);

    Recorder r(1.0, 1.0);
    for (int i = 0; i < 10; ++i) {
        r.add(1.0, 100, 100, 100);
        (void)r.take(i + 1.0, {});
    }
    r.begin_way();
    r.add(-1.0, 60, 60, 60);
    CHECK(r.take(9.0, {}).force == 60.0);
}

TEST_CASE("recorder: the force at the end of an interval is led there by its last parts, also "
          "where the force has just ceased to grow",
          "[dem][recorder]")
{
    const int steps = GENERATE(4096, 64); // 64: parts of few steps
    const double step = 1.0 / steps;
    const auto grows = [](double x) { return 100.0 * x; };
    const auto bends = [](double x) { return std::min(100.0 * x, 70.0); };
    const auto last = [&](const auto& force) {
        Recorder r(1.0, 0.0);
        for (int i = 0; i < steps; ++i) {
            const double a = force(i * step), b = force((i + 1) * step);
            r.add(step, a, b, 0.5 * (a + b));
        }
        (void)r.take(1.0, {});
        return r.at_end();
    };
    REQUIRE(last(grows));
    CHECK(last(grows)->force == Approx(100.0).epsilon(1e-12));
    CHECK(last(grows)->base == Approx(100.0).epsilon(1e-12));
    CHECK(last(bends)->force == Approx(70.0).epsilon(1e-12));

    Recorder coarse(1.0, 0.0); // too few steps to tell
    for (int i = 0; i < 9; ++i) coarse.add(1.0 / 9.0, 1, 1, 1);
    (void)coarse.take(1.0, {});
    CHECK_FALSE(coarse.at_end());
}
