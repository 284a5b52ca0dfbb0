#include "app/output/series_folder.hpp"

#include "app/text/number_text.hpp"
#include "tests/app/output/series_scene.hpp"
#include "tests/scenes/snapshot_scenes.hpp"
#include "tests/scenes/temporary_folder.hpp"
#include "tests/scenes/vtu_array.hpp"

#include <catch2/catch.hpp>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <stdexcept>

namespace fs = std::filesystem;
using scenes::attribute;
using scenes::elements;
using scenes::parse_xml;
using scenes::read_text;
using scenes::vtu_array;

namespace {

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

TEST_CASE("vtk series: time is the way of the load line in mm", "[app][vtk_series]")
{
    const scenes::TemporaryFolder folder;
    std::vector<dem::Snapshot> walls = a_push();
    walls.push_back(scenes::stair_step_rocking(-0.01)); // back again
    scenes::write_series(folder.path / "vtk", walls);
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
    scenes::write_series(folder.path / "vtk", walls);
    CHECK(listed(folder.path / "vtk" / "wall.pvd", "file").size() == 3);
    CHECK(vtu_array(read_text(folder.path / "vtk" / "wall_0002.vtu"), "force").at(0) == 77.0);
}

TEST_CASE("vtk series: no file of an earlier series stays", "[app][vtk_series]")
{
    const scenes::TemporaryFolder folder;
    const fs::path series = folder.path / "series";
    scenes::write_series(series, a_push());
    scenes::write_series(series, {scenes::wall_at_rest(), scenes::diagonal_crack(0.02, 0.6)});
    CHECK(std::distance(fs::directory_iterator(series), {}) == 6);
    std::ofstream(series / "notes.txt") << "mine";
    app::write_results(folder.path, {});
    CHECK(std::distance(fs::directory_iterator(series), {}) == 1);
}

TEST_CASE("vtk series: a value that is not finite is refused, and the earlier series stays",
          "[app][vtk_series]")
{
    const scenes::TemporaryFolder folder;
    std::vector<dem::Snapshot> walls = a_push();
    scenes::write_series(folder.path / "series", walls);
    const std::string before = read_text(folder.path / "series" / "wall_0001.vtu");
    const double nan = std::numeric_limits<double>::quiet_NaN();
    SECTION("in a block") { walls[1].blocks[5].displacement[0].z = nan; }
    SECTION("in a joint") { walls[1].faces[5].contacts[0].sigma = nan; }
    SECTION("in the load") { walls[1].force = nan; }
    CHECK_THROWS_AS(scenes::write_series(folder.path / "series", walls), std::invalid_argument);
    CHECK(std::distance(fs::directory_iterator(folder.path), {}) == 2); // and the list
    CHECK(listed(folder.path / "series" / "joints.pvd", "file").size() == 3);
    CHECK(read_text(folder.path / "series" / "wall_0001.vtu") == before);
}

// Hidden: writes a series for check_vtk.py, which reads it with VTK.
TEST_CASE("vtk series: for the reader of VTK", "[.][vtk_reader]")
{
    const char* folder = std::getenv("DRYSTONE_VTK_FOLDER");
    REQUIRE(folder != nullptr);
    const std::vector<dem::Snapshot> walls = a_push();
    scenes::write_series(folder, walls);
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
