#include "app/output/vtk_series.hpp"

#include "app/output/series_folder.hpp"
#include "app/text/number_text.hpp"
#include "tests/scenes/snapshot_scenes.hpp"
#include "tests/scenes/temporary_folder.hpp"
#include "tests/scenes/xml_tree.hpp"

#include <catch2/catch.hpp>

#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <sstream>
#include <stdexcept>

namespace fs = std::filesystem;
using scenes::attribute;
using scenes::elements;
using scenes::parse_xml;
using scenes::read_text;

namespace {

template <class T> std::vector<double> numbers(const char* bytes, std::size_t size)
{
    std::vector<double> values;
    for (std::size_t at = 0; at < size; at += sizeof(T)) {
        T value;
        std::memcpy(&value, bytes + at, sizeof(T));
        values.push_back(static_cast<double>(value));
    }
    return values;
}

std::vector<double> array(const std::string& vtu, const std::string& name)
{
    const std::string tag = "<AppendedData encoding=\"raw\">\n_";
    const std::size_t bytes = vtu.find(tag) + tag.size();
    for (const scenes::Xml& data :
         elements(parse_xml(vtu.substr(0, bytes) + "</AppendedData></VTKFile>"), "DataArray")) {
        if (attribute(data, "Name") != name) continue;
        const char* at = vtu.data() + bytes + std::stoul(attribute(data, "offset"));
        std::uint64_t size = 0;
        std::memcpy(&size, at, sizeof(size));
        at += sizeof(size);
        const std::string type = attribute(data, "type");
        if (type == "Float64") return numbers<double>(at, size);
        if (type == "Int64") return numbers<std::int64_t>(at, size);
        if (type == "Int32") return numbers<std::int32_t>(at, size);
        return numbers<std::uint8_t>(at, size);
    }
    return {};
}

std::vector<dem::Snapshot> a_push()
{
    return {scenes::wall_at_rest(), scenes::stair_step_rocking(0.01 / 3.0),
            scenes::diagonal_crack(0.02, 0.6)};
}

std::vector<std::string> listed(const fs::path& pvd, const std::string& what)
{
    std::vector<std::string> found;
    for (const scenes::Xml& entry : elements(parse_xml(read_text(pvd)), "DataSet"))
        found.push_back(attribute(entry, what));
    return found;
}

/// For check_vtk.py: what each file must hold.
std::string expectation(const std::string& file, const std::vector<double>& values,
                        std::size_t cells)
{
    double sum = 0.0;
    for (const double v : values) sum += v;
    return file + ' ' + std::to_string(cells) + ' ' + std::to_string(values.size()) + ' ' +
           app::number(sum, 17) + '\n';
}

} // namespace

TEST_CASE("vtk series: every double of a block reads back the same", "[app][vtk_series]")
{
    const dem::Snapshot wall = scenes::stair_step_rocking(0.01 / 3.0);
    const std::string vtu = app::blocks_vtu(wall);
    const std::vector<double> points = array(vtu, "Points"), moved = array(vtu, "displacement");
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
    CHECK(array(vtu, "offsets").size() == wall.blocks.size());
    CHECK(array(vtu, "unit").back() == 0.0); // the beam
    CHECK(array(vtu, "course").at(99) == 10.0);
    CHECK(array(vtu, "block").at(42) == 42.0);
    CHECK(array(vtu, "force").at(0) == wall.force);
}

TEST_CASE("vtk series: every contact is a point with its state, every face a cell",
          "[app][vtk_series]")
{
    const dem::Snapshot wall = scenes::diagonal_crack(0.02, 0.6);
    const std::string vtu = app::joints_vtu(wall);
    std::size_t i = 0, cell = 0;
    const auto opening = array(vtu, "opening"), slip = array(vtu, "slip"),
               sigma = array(vtu, "sigma"), tau = array(vtu, "tau"),
               damage = array(vtu, "damage"), area = array(vtu, "area"), id = array(vtu, "id"),
               a = array(vtu, "block_a"), b = array(vtu, "block_b"), kind = array(vtu, "kind"),
               offsets = array(vtu, "offsets");
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

TEST_CASE("vtk series: a joint is drawn midway between its two sides", "[app][vtk_series]")
{
    dem::Snapshot wall = scenes::wall_at_rest();
    for (dem::Point& u : wall.blocks.at(10).displacement) u = {0.002, 0.004}; // second course
    const std::vector<double> moved = array(app::joints_vtu(wall), "displacement");
    std::size_t i = 0;
    for (const dem::FaceState& face : wall.faces)
        for (std::size_t k = 0; k < face.contacts.size(); ++k, i += 3)
            if (face.block_a == 10 || face.block_b == 10) {
                REQUIRE(moved.at(i) == 0.001);
                REQUIRE(moved.at(i + 2) == 0.002);
            }
}

TEST_CASE("vtk series: time is the way of the load line in mm", "[app][vtk_series]")
{
    const scenes::TemporaryFolder folder;
    std::vector<dem::Snapshot> walls = a_push();
    walls.push_back(scenes::stair_step_rocking(-0.01)); // back again
    app::write_vtk_series(folder.path / "vtk", walls);
    for (const char* name : {"wall", "joints"}) {
        const fs::path pvd = folder.path / "vtk" / (std::string(name) + ".pvd");
        CHECK(listed(pvd, "timestep") ==
              std::vector<std::string>{"0", app::number(0.01 / 3.0 * 1e3, 17), "20", "50"});
        for (const std::string& file : listed(pvd, "file"))
            CHECK(fs::exists(folder.path / "vtk" / file));
        CHECK(listed(pvd, "file").at(2) == std::string(name) + "_0002.vtu");
    }
}

TEST_CASE("vtk series: of walls at the same time the last is kept", "[app][vtk_series]")
{
    const scenes::TemporaryFolder folder;
    std::vector<dem::Snapshot> walls = a_push();
    walls.push_back(walls.back());
    walls.back().force = 77.0;
    app::write_vtk_series(folder.path, walls);
    CHECK(listed(folder.path / "wall.pvd", "file").size() == 3);
    CHECK(array(read_text(folder.path / "wall_0002.vtu"), "force").at(0) == 77.0);
}

TEST_CASE("vtk series: no file of an earlier series stays", "[app][vtk_series]")
{
    const scenes::TemporaryFolder folder;
    const fs::path series = folder.path / "series";
    app::write_vtk_series(series, a_push());
    app::write_vtk_series(series, {scenes::wall_at_rest(), scenes::diagonal_crack(0.02, 0.6)});
    CHECK(std::distance(fs::directory_iterator(series), {}) == 6);
    std::ofstream(series / "notes.txt") << "mine";
    app::remove_vtk_series(series);
    CHECK(std::distance(fs::directory_iterator(series), {}) == 1);
}

TEST_CASE("vtk series: a value that is not finite is refused, and the earlier series stays",
          "[app][vtk_series]")
{
    const scenes::TemporaryFolder folder;
    std::vector<dem::Snapshot> walls = a_push();
    app::write_vtk_series(folder.path / "series", walls);
    const std::string before = read_text(folder.path / "series" / "wall_0001.vtu");
    const double nan = std::numeric_limits<double>::quiet_NaN();
    SECTION("in a block") { walls[1].blocks[5].displacement[0].z = nan; }
    SECTION("in a joint") { walls[1].faces[5].contacts[0].sigma = nan; }
    SECTION("in the load") { walls[1].force = nan; }
    CHECK_THROWS_AS(app::write_vtk_series(folder.path / "series", walls),
                    std::invalid_argument);
    CHECK(std::distance(fs::directory_iterator(folder.path), {}) == 1);
    CHECK(listed(folder.path / "series" / "joints.pvd", "file").size() == 3);
    CHECK(read_text(folder.path / "series" / "wall_0001.vtu") == before);
}

TEST_CASE("vtk series: faces with one contact or none are written as VTK wants them",
          "[app][vtk_series]")
{
    dem::Snapshot wall = scenes::wall_at_rest();
    const std::size_t faces = wall.faces.size();
    wall.faces[0].contacts.clear();
    wall.faces[1].contacts.resize(1);
    const std::vector<double> types = array(app::joints_vtu(wall), "types");
    REQUIRE(types.size() == faces - 1);
    CHECK(types[0] == 1.0); // vertex
    CHECK(types[1] == 4.0); // poly-line
}

// Hidden: writes a series for check_vtk.py, which reads it with VTK.
TEST_CASE("vtk series: for the reader of VTK", "[.][vtk_reader]")
{
    const char* folder = std::getenv("DRYSTONE_VTK_FOLDER");
    REQUIRE(folder != nullptr);
    const std::vector<dem::Snapshot> walls = a_push();
    app::write_vtk_series(folder, walls);
    std::ofstream out(fs::path(folder) / "expected.txt");
    for (std::size_t i = 0; i < walls.size(); ++i) {
        std::vector<double> heights, openings;
        for (const dem::BlockState& block : walls[i].blocks)
            for (const dem::Point& u : block.displacement) heights.push_back(u.z);
        for (const dem::FaceState& face : walls[i].faces)
            for (const dem::ContactState& c : face.contacts) openings.push_back(c.opening);
        const std::string end = "_000" + std::to_string(i) + ".vtu";
        out << expectation("wall" + end, heights, walls[i].blocks.size())
            << expectation("joints" + end, openings, walls[i].faces.size());
    }
}
