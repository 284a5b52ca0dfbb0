#include "dem/scene/mechanism/snapshot_vtu.hpp"

#include "tests/scenes/snapshot_scenes.hpp"
#include "tests/scenes/vtu_array.hpp"

#include <catch2/catch.hpp>

#include <limits>
#include <stdexcept>

using scenes::vtu_array;

TEST_CASE("snapshot vtu: every double of a block reads back the same", "[dem][snapshot_vtu]")
{
    const dem::Snapshot wall = scenes::stair_step_rocking(0.01 / 3.0);
    const std::string vtu = dem::blocks_vtu(wall);
    const std::vector<double> points = vtu_array(vtu, "Points"),
                              moved = vtu_array(vtu, "displacement");
    std::size_t i = 0;
    for (const dem::BlockState& block : wall.blocks)
        for (std::size_t k = 0; k < block.outline.size(); ++k, i += 3) {
            REQUIRE(points.at(i) == block.outline[k].x);
            REQUIRE(points.at(i + 1) == 0.0);
            REQUIRE(points.at(i + 2) == block.outline[k].z);
            REQUIRE(moved.at(i) == block.displacement[k].x);
            REQUIRE(moved.at(i + 2) == block.displacement[k].z);
        }
    CHECK(i == points.size());
    CHECK(vtu_array(vtu, "offsets").size() == wall.blocks.size());
    CHECK(vtu_array(vtu, "unit").back() == 0.0); // the beam
    CHECK(vtu_array(vtu, "course").at(99) == 10.0);
    CHECK(vtu_array(vtu, "block").at(42) == 42.0);
    CHECK(vtu_array(vtu, "force").at(0) == wall.force);
}

TEST_CASE("snapshot vtu: every contact is a point with its state, every face a cell",
          "[dem][snapshot_vtu]")
{
    const dem::Snapshot wall = scenes::diagonal_crack(0.02, 0.6);
    const std::string vtu = dem::joints_vtu(wall);
    std::size_t i = 0, cell = 0;
    const auto opening = vtu_array(vtu, "opening"), slip = vtu_array(vtu, "slip"),
               sigma = vtu_array(vtu, "sigma"), tau = vtu_array(vtu, "tau"),
               damage = vtu_array(vtu, "damage"), area = vtu_array(vtu, "area"),
               id = vtu_array(vtu, "id"), a = vtu_array(vtu, "block_a"),
               b = vtu_array(vtu, "block_b"), kind = vtu_array(vtu, "kind"),
               offsets = vtu_array(vtu, "offsets");
    for (const dem::FaceState& face : wall.faces) {
        for (const dem::ContactState& c : face.contacts) {
            REQUIRE(opening.at(i) == c.opening);
            REQUIRE(slip.at(i) == c.slip);
            REQUIRE(sigma.at(i) == c.sigma);
            REQUIRE(tau.at(i) == c.tau);
            REQUIRE(damage.at(i) == c.damage);
            REQUIRE(area.at(i) == c.area);
            ++i;
        }
        REQUIRE(id.at(cell) == face.id);
        REQUIRE(a.at(cell) == face.block_a);
        REQUIRE(b.at(cell) == face.block_b);
        REQUIRE((kind.at(cell) == 2.0) == (face.kind == dem::FaceKind::unit_crack));
        REQUIRE(offsets.at(cell) == static_cast<double>(i));
        ++cell;
    }
    CHECK(offsets.size() == cell);
    CHECK(opening.size() == i);
}

TEST_CASE("snapshot vtu: a joint is drawn midway between its two sides", "[dem][snapshot_vtu]")
{
    dem::Snapshot wall = scenes::wall_at_rest();
    for (dem::Point& u : wall.blocks.at(10).displacement) u = {0.002, 0.004}; // second course
    const std::vector<double> moved = vtu_array(dem::joints_vtu(wall), "displacement");
    std::size_t i = 0;
    for (const dem::FaceState& face : wall.faces)
        for (std::size_t k = 0; k < face.contacts.size(); ++k, i += 3)
            if (face.block_a == 10 || face.block_b == 10) {
                REQUIRE(moved.at(i) == 0.001);
                REQUIRE(moved.at(i + 2) == 0.002);
            }
}

TEST_CASE("snapshot vtu: faces with one contact or none are written as VTK wants them",
          "[dem][snapshot_vtu]")
{
    dem::Snapshot wall = scenes::wall_at_rest();
    const std::size_t faces = wall.faces.size();
    wall.faces[0].contacts.clear();
    wall.faces[1].contacts.resize(1);
    const std::vector<double> types = vtu_array(dem::joints_vtu(wall), "types");
    REQUIRE(types.size() == faces - 1);
    CHECK(types[0] == 1.0); // vertex
    CHECK(types[1] == 4.0); // poly-line
}

TEST_CASE("snapshot vtu: a value that is not finite is refused", "[dem][snapshot_vtu]")
{
    dem::Snapshot wall = scenes::wall_at_rest();
    const double nan = std::numeric_limits<double>::quiet_NaN();
    SECTION("in a block")
    {
        wall.blocks[5].displacement[0].z = nan;
        CHECK_THROWS_AS(dem::blocks_vtu(wall), std::invalid_argument);
    }
    SECTION("in a joint")
    {
        wall.faces[5].contacts[0].sigma = nan;
        CHECK_THROWS_AS(dem::joints_vtu(wall), std::invalid_argument);
    }
    SECTION("in the load")
    {
        wall.force = nan;
        CHECK_THROWS_AS(dem::blocks_vtu(wall), std::invalid_argument);
        CHECK_THROWS_AS(dem::joints_vtu(wall), std::invalid_argument);
    }
}

TEST_CASE("snapshot vtu: a series names its files with their times, to the last bit",
          "[dem][snapshot_vtu]")
{
    const std::vector<double> times = {0.0, 0.01 / 3.0 * 1e3, 1e21};
    const auto entries = scenes::elements(
        scenes::parse_xml(dem::pvd_text(times, {"a.vtu", "b.vtu", "c.vtu"})), "DataSet");
    REQUIRE(entries.size() == 3);
    for (std::size_t i = 0; i < times.size(); ++i)
        CHECK(std::stod(scenes::attribute(entries[i], "timestep")) == times[i]);
    CHECK(scenes::attribute(entries[1], "file") == "b.vtu");
    CHECK_THROWS_AS(dem::pvd_text(times, {"a.vtu"}), std::out_of_range);
}
