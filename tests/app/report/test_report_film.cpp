#include "app/report/report_film.hpp"
#include "scenes/snapshot_scenes.hpp"

#include <catch2/catch.hpp>

#include <stdexcept>
#include <vector>

TEST_CASE("report film: a block that moves without strain is drawn where it is",
          "[app][report_film]")
{
    dem::BlockState block;
    block.outline = {{0.2, 0.1}, {0.3, 0.1}, {0.4, 0.1}, {0.4, 0.2}, {0.2, 0.2}};
    const double turn = 0.01, x0 = 0.003, z0 = -0.002; // linear in the angle, as the solver
    for (const dem::Point p : block.outline)
        block.displacement.push_back({x0 + turn * p.z, z0 - turn * p.x});
    const app::BlockMotion m = app::MotionFit(block.outline).motion(block.displacement);
    CHECK(m.a.x == Approx(x0 + turn * 0.15).epsilon(1e-14));
    CHECK(m.a.z == Approx(z0 - turn * 0.30).epsilon(1e-14));
    CHECK(m.b.z == Approx(-turn * 0.10).epsilon(1e-12));
    CHECK(m.c.x == Approx(turn * 0.05).epsilon(1e-12));
    CHECK(m.b.x == Approx(0.0).margin(1e-17));
    CHECK(m.c.z == Approx(0.0).margin(1e-17));
}

TEST_CASE("report film: a block that is no rectangle is drawn where it is",
          "[app][report_film]")
{
    dem::BlockState block; // box 0..0.4 x 0..0.2; no corner at two corners of the box
    block.outline = {{0.1, 0.0}, {0.4, 0.0}, {0.3, 0.2}, {0.15, 0.2}, {0.0, 0.1}};
    for (const dem::Point p : block.outline)
        block.displacement.push_back({0.003 + 0.5 * p.x - 0.2 * p.z, 0.01 * p.x + 0.1 * p.z});
    const app::BlockMotion m = app::MotionFit(block.outline).motion(block.displacement);
    CHECK(m.a.x == Approx(0.003 + 0.5 * 0.2 - 0.2 * 0.1).epsilon(1e-12));
    CHECK(m.a.z == Approx(0.01 * 0.2 + 0.1 * 0.1).epsilon(1e-12));
    CHECK(m.b.x == Approx(0.5 * 0.2).epsilon(1e-12));
    CHECK(m.b.z == Approx(0.01 * 0.2).epsilon(1e-12));
    CHECK(m.c.x == Approx(-0.2 * 0.1).epsilon(1e-12));
    CHECK(m.c.z == Approx(0.1 * 0.1).epsilon(1e-12));
}

TEST_CASE("report film: the strain of a block is kept too", "[app][report_film]")
{
    dem::BlockState block;
    block.outline = {{0.0, 0.0}, {2.0, 0.0}, {2.0, 1.0}, {0.0, 1.0}};
    for (const dem::Point p : block.outline)
        block.displacement.push_back({0.1 * p.x, -0.2 * p.z});
    const app::BlockMotion m = app::MotionFit(block.outline).motion(block.displacement);
    CHECK(m.b.x == Approx(0.1));
    CHECK(m.c.z == Approx(-0.1));
    CHECK_THROWS_AS(app::MotionFit({}), std::invalid_argument);
}

TEST_CASE(
    "report film: as many frames as there are, no coarser than 10 um unless the wall comes "
    "down",
    "[app][report_film]")
{
    std::vector<dem::Snapshot> frames = {scenes::wall_at_rest()};
    for (const double d : {0.01, 0.02, 0.03}) frames.push_back(scenes::diagonal_crack(d, 0.6));
    const app::Film film = app::film_of(frames);
    CHECK(film.frames == 4);
    CHECK(film.step == 1e-5);
    CHECK(film.data.size() < 8000);
    CHECK_FALSE(film.crushing);
    frames[2].faces.front().contacts.front().crushed = 1e-6;
    CHECK(app::film_of(frames).crushing);
    CHECK(app::film_of(frames).data.size() > film.data.size());
    frames.back().displacement = 0.64;
    CHECK(app::film_of(frames).step == Approx(2e-5));
    CHECK_THROWS_AS(app::film_of({}), std::invalid_argument);
}
