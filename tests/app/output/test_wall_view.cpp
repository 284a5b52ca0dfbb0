#include "app/output/picture/wall_view.hpp"

#include "dem/scene/mechanism/snapshot_reading.hpp"
#include "tests/scenes/snapshot_scenes.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <stdexcept>

namespace {

double largest_opening(const dem::Snapshot& wall)
{
    double largest = 0.0;
    for (const dem::FaceState& face : wall.faces)
        for (const dem::ContactState& c : face.contacts) largest = std::max(largest, c.opening);
    return largest;
}

} // namespace

TEST_CASE("wall view: the wall stays a wall, and its mechanism is seen", "[app][wall_view]")
{
    const double displacement = GENERATE(1e-5, 3e-4, 2e-3, 0.01, 0.03); // [m]
    const dem::Snapshot wall = GENERATE_COPY(scenes::stair_step_rocking(displacement),
                                             scenes::diagonal_crack(displacement, 1.0));
    const double scale = app::drawing_scale(wall);
    const double size = 1.0; // [m] the smaller side
    CAPTURE(displacement, scale);
    CHECK(scale * dem::largest_displacement(wall) <= 0.15 * size);
    CHECK(scale * largest_opening(wall) <= 0.12 * size);
    // round factors are at most 2 apart, and the two bounds differ by less than 3
    if (scale < 1000.0) CHECK(scale * dem::largest_displacement(wall) >= 0.15 * size / 6.0);
}

TEST_CASE("wall view: a wall that leans without a gap leans visibly and no more",
          "[app][wall_view]")
{
    dem::Snapshot wall = scenes::wall_at_rest();
    for (dem::BlockState& block : wall.blocks)
        for (std::size_t i = 0; i < block.outline.size(); ++i)
            block.displacement[i].x = 0.001 * block.outline[i].z;
    CHECK(app::drawing_scale(wall) == 100.0); // 0.11 m; 200 would be 0.22 m
}

TEST_CASE("wall view: blocks that part either way do not part by more than a stone",
          "[app][wall_view]")
{
    dem::Snapshot wall = scenes::wall_at_rest();
    wall.faces.at(100).contacts.at(1).opening = 0.012; // [m]
    CHECK(app::drawing_scale(wall) == 10.0);           // 0.12 m; 20 would be 0.24 m
    wall.faces.at(100).contacts.at(1).opening = 0.0;
    wall.faces.at(100).contacts.at(1).slip = -0.012;
    CHECK(app::drawing_scale(wall) == 10.0);
}

TEST_CASE("wall view: displacements are never drawn smaller than they are", "[app][wall_view]")
{
    CHECK(app::drawing_scale(scenes::stair_step_rocking(0.9)) == 1.0);
}

TEST_CASE("wall view: factors are 1, 2, 3 or 5 times a power of ten", "[app][wall_view]")
{
    CHECK(app::drawing_scale(scenes::wall_at_rest()) == 1000.0);
    CHECK(app::drawing_scale(scenes::stair_step_rocking(0.03)) == 3.0);
    CHECK(app::drawing_scale(scenes::stair_step_rocking(0.009)) == 10.0);
}

TEST_CASE("wall view: a gap is drawn as wide as the opening times the factor",
          "[app][wall_view]")
{
    const dem::Snapshot wall = scenes::stair_step_rocking(0.02);
    const app::WallView view{3.0, 400.0, {50.0, 600.0}, 1.0};
    int open = 0;
    for (const dem::FaceState& face : wall.faces)
        for (const dem::ContactState& c : face.contacts) {
            if (c.opening < 1e-4) continue;
            const app::ContactPixels at = app::place_contact(wall, view, face, c);
            const double across =
                (at.b.x - at.a.x) * face.normal.x - (at.b.y - at.a.y) * face.normal.z;
            CHECK(across == Approx(3.0 * 400.0 * c.opening).epsilon(1e-9));
            ++open;
        }
    CHECK(open > 50);
}

TEST_CASE("wall view: z is up on the page", "[app][wall_view]")
{
    const app::WallView view{2.0, 100.0, {10.0, 500.0}, 1.0};
    const app::Pixel p = view.place({1.0, 2.0}, {0.5, 0.25});
    CHECK(p.x == Approx(10.0 + 100.0 * (1.0 + 2.0 * 0.5)).epsilon(1e-14));
    CHECK(p.y == Approx(500.0 - 100.0 * (2.0 + 2.0 * 0.25)).epsilon(1e-14));
}

TEST_CASE("wall view: the box of a wall holds every displaced point", "[app][wall_view]")
{
    const dem::Snapshot wall = scenes::stair_step_rocking(0.1);
    const app::WallBox rest = app::box_of(wall.blocks, 0.0),
                       moved = app::box_of(wall.blocks, 1.0);
    CHECK(rest.low.x == 0.0);
    CHECK(rest.high.z == Approx(1.1).epsilon(1e-14));
    CHECK(moved.high.x == Approx(1.1).epsilon(1e-14)); // load line, 0.1 m on
    CHECK(moved.high.z ==
          Approx(1.1 + 0.1 / 1.1).epsilon(1e-14)); // upper left corner lifts by theta L
    CHECK(app::join(rest, moved).low.x == 0.0);
}

TEST_CASE("wall view: a wall without blocks is refused", "[app][wall_view]")
{
    CHECK_THROWS_AS(app::box_of({}, 0.0), std::invalid_argument);
}
