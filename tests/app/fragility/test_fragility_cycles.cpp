#include "app/fragility/fragility_cycles.hpp"

#include "app/fragility/fragility_means.hpp"
#include "tests/app/fragility/fragility_scenes.hpp"

#include <catch2/catch.hpp>

#include <numbers>

namespace {

/// A closed loop: +-f at +-d, energy `share` of 4 f d, force zero at +-residual.
fragility::Cycle loop(double d, double f, double share, double residual)
{
    fragility::Cycle c;
    c.closed = true;
    c.displacement_plus = d;
    c.displacement_minus = -d;
    c.force_plus = c.force_at_plus = f;
    c.force_minus = c.force_at_minus = -f;
    c.energy = 4.0 * f * d * share;
    c.residual_plus = residual;
    c.residual_minus = -residual;
    return c;
}

/// Two cycles of each wall, of 5.5 and 11 mm; every other wall ends in the second.
app::StudyWalls cyclic_walls(std::size_t n)
{
    app::StudyWalls walls = scenes::study_walls(n);
    walls.pushed_one_way = false;
    for (app::StudyLevel& level : walls.levels)
        for (std::size_t i = 0; i < n; ++i) {
            const double share = i % 2 == 0 ? 0.2 : 0.4;
            app::StudyWall& w = level.walls[i];
            w.reading.mode = i < 4 ? dem::FailureMode::rocking : dem::FailureMode::mixed;
            w.cycles = {loop(0.0055, 40e3, share, 0.001), loop(0.011, 50e3, share, 0.002)};
            w.cycles[1].closed = i % 2 == 0;
        }
    return walls;
}

} // namespace

TEST_CASE("fragility cycles: means of damping, stiffness and half width by cycle and mode",
          "[app][fragility_cycles]")
{
    const app::StudyWalls walls = cyclic_walls(8);
    const auto all = app::cycle_points(walls, walls.levels[0], app::kAllModes);
    REQUIRE(all.size() == 2);
    CHECK(all[0].walls == 8);
    CHECK(all[0].drift == Approx(0.5)); // 5.5 mm over 1.1 m
    CHECK(all[0].damping.value == Approx(100.0 * 2.0 / std::numbers::pi * 0.3));
    CHECK(all[0].damping.interval.lower < all[0].damping.value);
    CHECK(all[0].stiffness.value == Approx(1.0));
    CHECK(all[0].residual.value == Approx(100.0 * 0.001 / 1.1));
    CHECK(all[1].cycle == 2);
    CHECK(all[1].walls == 4); // those that came back
    CHECK(all[1].damping.value == Approx(100.0 * 2.0 / std::numbers::pi * 0.2));
    CHECK(all[1].stiffness.value == Approx(0.5 * 50.0 / 40.0));
    CHECK(all[1].energy == Approx(4.0 * 50e3 * 0.011 * 0.2));
    const auto rocking = app::cycle_points(walls, walls.levels[0], app::kRocking);
    CHECK(rocking[0].walls == 4);
    CHECK(app::cycle_points(walls, walls.levels[0], app::kSliding).empty());
}

TEST_CASE(
    "fragility cycles: the table has a row for each cycle of each mode, a push one way none",
    "[app][fragility_cycles]")
{
    const app::Table t = app::cycle_table(cyclic_walls(8));
    CHECK(t.rows.size() == 2 * 3 * 2); // stresses; rocking, mixed, all; cycles
    CHECK(scenes::sound(t));
    CHECK(scenes::cell(t, 0, "walls") == "rocking");
    CHECK(app::cycle_pictures(cyclic_walls(8)).size() == 3);
    CHECK(app::cycle_table(scenes::study_walls(8)).rows.empty());
    CHECK(app::cycle_pictures(scenes::study_walls(8)).empty());
}

TEST_CASE("fragility cycles: one wall has a mean without interval", "[app][fragility_cycles]")
{
    const app::StudyWalls walls = cyclic_walls(1);
    const auto points = app::cycle_points(walls, walls.levels[0], app::kAllModes);
    REQUIRE(points.size() == 2);
    CHECK_FALSE(points[0].damping.interval.lower < points[0].damping.interval.upper);
    CHECK(scenes::sound(app::cycle_table(walls)));
}
