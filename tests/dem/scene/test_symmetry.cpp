/// Walls that are their own mirror image.

#include "dem/scene/drawn_layout.hpp"
#include "dem/scene/symmetry.hpp"

#include <catch2/catch.hpp>

TEST_CASE(
    "symmetry: a wall is symmetric if and only if every unit has its like on the other side",
    "[dem][symmetry]")
{
    dem::WallGeometry wall;
    const auto symmetric = [](const dem::WallGeometry& w) {
        return dem::is_symmetric(dem::lay_out(w, 0.1));
    };
    CHECK(symmetric(wall)); // running bond of whole and half units
    wall.bond_offset = 0.25;
    CHECK_FALSE(symmetric(wall));
    wall.bond_offset = 0.5;
    wall.openings = {{0.4, 0.2, 0.2, 0.3}};
    CHECK(symmetric(wall));
    wall.openings = {{0.2, 0.2, 0.2, 0.3}};
    CHECK_FALSE(symmetric(wall));
    wall.openings = {{0.2, 0.2, 0.2, 0.3}, {0.6, 0.2, 0.2, 0.3}};
    CHECK(symmetric(wall));
    wall.openings.clear();
    wall.length_cov = 0.1;
    CHECK_FALSE(symmetric(wall));
}

TEST_CASE("symmetry: a stone of another kind breaks it, and so does a crack", "[dem][symmetry]")
{
    dem::Layout layout = dem::lay_out(dem::WallGeometry{}, 0.1);
    layout.blocks.front().material = 1;
    CHECK_FALSE(dem::is_symmetric(layout));
    layout = dem::lay_out(dem::WallGeometry{}, 0.1);
    std::erase_if(layout.faces, [first = true](const dem::Face& f) mutable {
        return f.kind == dem::FaceKind::unit_crack && std::exchange(first, false);
    });
    CHECK_FALSE(dem::is_symmetric(layout));
}

TEST_CASE("symmetry: a stone that leans is not symmetric, though its middle and its size are",
          "[dem][symmetry]")
{
    const auto symmetric = [](double lean) {
        dem::DrawnWall wall;
        wall.units = {{{{0.0, 0.0}, {0.4, 0.0}, {0.4 + lean, 1.2}, {lean, 1.2}}}};
        return dem::is_symmetric(dem::drawn_layout(wall, 0.0));
    };
    CHECK(symmetric(0.0));
    CHECK_FALSE(symmetric(-0.15));
    CHECK_FALSE(symmetric(0.15));
}
