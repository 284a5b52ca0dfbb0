#include "app/commands.hpp"
#include "app/input/key_effects.hpp"
#include "app/input/prepared_study.hpp"
#include "app/input/study_reading.hpp"
#include "app/input/wall/wall_geometry.hpp"
#include "app/scene/scene_units.hpp"
#include "dem/scene/geometry/polygon.hpp"
#include "scenes/temporary_folder.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;
using scenes::read_text;

const std::string kWall = std::string(DRYSTONE_SOURCE_DIR) + "/configs/wall.ini";

/// Text that a command writes on a stream.
template <class Run> std::string said(std::ostream& stream, Run run)
{
    std::ostringstream text;
    std::streambuf* screen = stream.rdbuf(text.rdbuf());
    run();
    stream.rdbuf(screen);
    return text.str();
}

app::Command command_of(const std::string& study, const fs::path& out,
                        std::vector<std::string> overrides)
{
    app::Command c;
    c.study = study;
    c.out = out.string();
    c.overrides = std::move(overrides);
    c.quiet = true;
    return c;
}

std::string scene(const std::string& study, const fs::path& out,
                  std::vector<std::string> overrides = {})
{
    return said(std::cout, [&] {
        CHECK(app::scene_command(command_of(study, out, std::move(overrides))) == 0);
    });
}

double peak(const std::string& study, const fs::path& out, std::vector<std::string> overrides)
{
    for (const char* coarse : {"solver.contact_points=2", "solver.block_modes=6",
                               "solver.steps_per_mm=200", "load.max_displacement=15 mm"})
        overrides.emplace_back(coarse);
    said(std::cout,
         [&] { CHECK(app::push_command(command_of(study, out, std::move(overrides))) == 0); });
    return nlohmann::json::parse(read_text(out / "summary.json"))["peak_force_kN"];
}

/// The paper's wall with a drawing in place of its courses.
std::string drawn_study(const fs::path& folder, const std::string& drawing)
{
    std::istringstream text(read_text(kWall));
    std::ofstream study(folder / (drawing + ".ini"));
    for (std::string line; std::getline(text, line);) {
        const std::string key = line.substr(0, line.find_first_of(" ="));
        const std::vector<std::string> courses = {"length", "courses", "course_height",
                                                  "bond",   "toe",     "first_course"};
        if (std::ranges::find(courses, key) == courses.end()) study << line << '\n';
        if (line == "[wall]") study << "geometry = " << drawing << '\n';
    }
    return (folder / (drawing + ".ini")).string();
}

app::Study study_of(const std::string& file, const std::vector<std::string>& overrides = {})
{
    return app::prepare(
               app::read_study(app::with_overrides(app::read_study_file(file), overrides)))
        .study;
}

} // namespace

TEST_CASE("scene command: the paper's wall, exported and read again, is the same wall",
          "[app][scene]")
{
    const scenes::TemporaryFolder folder;
    const std::string text = scene(kWall, folder.path);
    CHECK(text.starts_with("55 units in 100 blocks, 135 joints, 45 potential cracks, "));
    CHECK(text.find("1.90 times the height") != std::string::npos);
    const double as_keys = peak(kWall, folder.path / "keys", {"wall.toe=free"});
    for (const char* drawing : {"scene.dxf", "scene.json"}) {
        INFO(drawing);
        const std::string file = drawn_study(folder.path, drawing);
        const app::Study read = study_of(file);
        const dem::Layout layout = app::layout_of(read, read.source);
        CHECK(layout.n_joints == 135);
        CHECK(layout.n_cracks == 45);
        CHECK(layout.blocks.size() == 101);
        CHECK(std::ranges::all_of(layout.blocks,
                                  [](const dem::Block& b) { return b.outline.empty(); }));
        CHECK(peak(file, folder.path / "drawn", {}) == Approx(as_keys).epsilon(1e-3));
    }
}

TEST_CASE("scene command: laws.svg draws the laws that the contacts of the wall follow",
          "[app][scene]")
{
    const scenes::TemporaryFolder folder;
    const auto laws = [&](const std::string& study, const std::vector<std::string>& overrides) {
        scene(study, folder.path, overrides);
        return read_text(folder.path / "laws.svg");
    };
    const auto has = [](const std::string& text, const char* words) {
        return text.find(words) != std::string::npos;
    };
    const std::string wall = laws(kWall, {});
    CHECK((has(wall, "Crack in a unit, opened") && has(wall, "Dry joint, strength")));
    CHECK(has(wall, "Mean values under 0.5 MPa"));
    CHECK_FALSE(has(laws(kWall, {"wall.unit_cracks=no"}), "Crack in a unit"));
    CHECK(laws(kWall, {"unit.contact_law=uncoupled"}) ==
          wall); // differs where both act at once
    CHECK(laws(kWall, {"unit.envelope=hyperbolic"}) != wall);
    CHECK(laws(kWall, {"unit.unloading=elastic"}) != wall);
    const std::string closing = std::string(DRYSTONE_SOURCE_DIR) + "/configs/closure.ini";
    CHECK(laws(closing, {}) != laws(closing, {"joint.closure_loss=0.3"}));
    const std::string mortar = std::string(DRYSTONE_SOURCE_DIR) + "/configs/picture.ini";
    CHECK(has(laws(mortar, {}), "Joint with mortar, slipping"));
}

TEST_CASE("scene command: joints.csv says where each value per joint belongs", "[app][scene]")
{
    const scenes::TemporaryFolder folder;
    scene(kWall, folder.path);
    std::istringstream table(read_text(folder.path / "joints.csv"));
    std::vector<std::string> lines;
    for (std::string line; std::getline(table, line);) lines.push_back(line);
    REQUIRE(lines.size() == 1 + 135 + 45);
    CHECK(lines[0] == "kind,id,course,unit,x [m],z [m],length [m]");
    CHECK(lines[1] == "head joint,1,1,1,0.2,0.05,0.1");
    CHECK(lines[5] == "bed joint,5,1,1,0.05,0.1,0.1");
    CHECK(lines[136].starts_with("crack,1,1,1,0.1,0.05,"));
}

TEST_CASE("scene command: the export is in the unit of the study", "[app][scene]")
{
    const scenes::TemporaryFolder folder;
    scene(kWall, folder.path);
    const auto json = nlohmann::json::parse(read_text(folder.path / "scene.json"));
    CHECK(json["blocks"].size() == 55);
    CHECK(json["blocks"][54]["outline"].size() == 4);
    double farthest = 0.0;
    for (const auto& block : json["blocks"])
        for (const auto& corner : block["outline"])
            farthest = std::max(farthest, corner[0].get<double>());
    CHECK(farthest == Approx(1000.0)); // [mm]
}

TEST_CASE("scene command: layers keep their names, and a layer called wall its own stone",
          "[app][scene]")
{
    const scenes::TemporaryFolder folder;
    const std::string named = GENERATE(R"("layer": "other", )", "");
    std::ofstream(folder.path / "two.json")
        << R"({"blocks": [{"layer": "wall", "outline": [[0, 0], [1000, 0], [1000, 500], [0, 500]]},
                          {)"
        << named << R"("outline": [[0, 500], [1000, 500], [1000, 1000], [0, 1000]]}]})";
    const std::vector<std::string> stone = {"wall.layer_stones=wall: 5 GPa, 0.2, 1800 kg/m3"};
    const app::Study study = study_of(drawn_study(folder.path, "two.json"), stone);
    const std::string text =
        scene(drawn_study(folder.path, "two.json"), folder.path / "out", stone);
    CHECK(text.find("layer_stones = wall: 5 GPa, 0.2, 1800 kg/m3\n") != std::string::npos);
    CHECK(text.find("length_unit = mm\n") != std::string::npos);
    for (const char* drawing : {"out/scene.dxf", "out/scene.json"}) {
        fs::copy_file(folder.path / drawing, folder.path / fs::path(drawing).filename());
        const app::Study again =
            study_of(drawn_study(folder.path, fs::path(drawing).filename().string()), stone);
        const dem::Layout a = app::layout_of(study, study.source),
                          b = app::layout_of(again, again.source);
        REQUIRE(a.blocks.size() == b.blocks.size());
        for (std::size_t k = 0; k < a.blocks.size(); ++k)
            CHECK(a.blocks[k].material == b.blocks[k].material);
        const std::vector<app::DrawnBlock> units =
            app::scene_units(again.geometry, app::whole_units(again, again.source));
        CHECK(units[0].layer == "wall");
        if (!named.empty()) CHECK(units[1].layer == "other");
    }
}

TEST_CASE("scene command: lintels, exported and read again, stay whole", "[app][scene]")
{
    const scenes::TemporaryFolder folder;
    const std::vector<std::string> window = {"wall.openings=0.4 m, 0.2 m, 0.2 m, 0.2 m",
                                             "wall.toe=free"};
    const std::string text = scene(kWall, folder.path, window);
    const std::string stones = "layer_stones = lintel: 15.5 GPa, 0.2, 2300 kg/m3";
    CHECK(text.find(stones + '\n') != std::string::npos);
    CHECK(text.find("unit_length = 0.2 m\n") != std::string::npos);
    const app::Study study = study_of(kWall, window),
                     again = study_of(drawn_study(folder.path, "scene.dxf"),
                                      {"wall.layer_stones=lintel: 15.5 GPa, 0.2, 2300 kg/m3"});
    CHECK(app::layout_of(again, again.source).n_cracks ==
          app::layout_of(study, study.source).n_cracks);
    CHECK(app::layout_of(again, again.source).faces.size() ==
          app::layout_of(study, study.source).faces.size());
}

TEST_CASE("scene command: the keys to take out leave a study that reads the drawing",
          "[app][scene]")
{
    const scenes::TemporaryFolder folder;
    std::string text = scene(kWall, folder.path, {"wall.openings=0.4 m, 0.2 m, 0.2 m, 0.2 m"});
    std::ranges::replace(text, '\n', ' ');
    const std::string begin = "Take out of the study: ";
    REQUIRE(text.find(begin) != std::string::npos);
    std::istringstream keys(text.substr(text.find(begin) + begin.size()));
    std::vector<std::string> overrides = {"wall.geometry=" +
                                          (folder.path / "scene.dxf").string()};
    bool openings = false;
    for (std::string key; keys >> key;) {
        if (key.ends_with(',')) key.pop_back();
        if (key == "wall.openings")
            openings = true; // which the file does not have
        else
            overrides.push_back(key + "=");
    }
    CHECK(openings);
    CHECK_NOTHROW(study_of(kWall, overrides));
}

TEST_CASE("study: an opening that does not fit is named, with the heights that would",
          "[app][scene]")
{
    const auto wall = [](const std::string& openings) {
        return study_of(kWall, {"wall.openings=" + openings});
    };
    CHECK_THROWS_WITH(
        wall("0.4 m, 0 m, 0.2 m, 0.2 m; 0.7 m, 0.2 m, 0.2 m, 25 cm"),
        Catch::Contains("opening 2 (0.7 m, 0.2 m, 0.2 m, 0.25 m) must begin and end "
                        "between two courses; it ends at z = 0.45 m: 0.4 m or "
                        "0.5 m would fit"));
    CHECK_THROWS_WITH(wall("0.4 m, 0.25 m, 0.2 m, 0.15 m"),
                      Catch::Contains("it begins at z = 0.25 m: 0.2 m or 0.3 m would fit"));
    CHECK_THROWS_WITH(wall("0.4 m, 0 m, 0.2 m, 1 m"),
                      Catch::Contains("opening 1 (0.4 m, 0 m, 0.2 m, 1 m) must lie within the "
                                      "wall, from x = 0 to 1 m, and below its top course, from "
                                      "z = 0 to 0.9 m"));
}

TEST_CASE("scene units: a unit that a crack parts is whole again, with its own corners",
          "[app][scene]")
{
    const scenes::TemporaryFolder folder;
    std::ofstream(folder.path / "two.json")
        << R"({"blocks": [[[0, 0], [200, 0], [180, 60], [200, 110], [0, 90]],
                          [[200, 0], [400, 0], [400, 110], [200, 110], [180, 60]]]})";
    const app::Study study =
        study_of(drawn_study(folder.path, "two.json"), {"load.height=0.21 m"});
    const dem::Layout layout = app::layout_of(study, study.source);
    REQUIRE(layout.n_cracks == 2);
    const std::vector<app::DrawnBlock> units =
        app::scene_units(study.geometry, app::whole_units(study, study.source));
    REQUIRE(units.size() == 2);
    CHECK(units[0].outline.size() == 5);
    CHECK(units[1].outline.size() == 5);
    CHECK(dem::polygon_area(units[0].outline) == Approx(0.0189));
    CHECK(units[0].layer == "wall");
}

TEST_CASE("scene command: what was closed or simplified of a drawing is said", "[app][scene]")
{
    const app::Verb verb{.name = "scene", .sections = "wall"};
    const app::Study study =
        study_of(std::string(DRYSTONE_SOURCE_DIR) + "/configs/picture.ini");
    const std::string text = app::study_notes(app::prepare(study), &verb);
    CHECK(text.find("note: wall.geometry: 49 stones") != std::string::npos);
}

TEST_CASE("scene command: a load that does not fit the wall is told, and the wall is drawn",
          "[app][scene]")
{
    const scenes::TemporaryFolder folder;
    const auto run = [&] { scene(kWall, folder.path, {"load.height=2.2 m"}); };
    const std::string notes = said(std::cerr, run);
    CHECK_THAT(notes,
               Catch::Contains("note: load.height: must lie within the loading beam, from "
                               "1 m to 1.1 m; without this key it is the top"));
    CHECK(fs::exists(folder.path / "scene.svg"));
    CHECK(said(std::cerr, [&] { scene(kWall, folder.path, {}); }).find("load.height") ==
          std::string::npos);
    CHECK_THROWS_WITH(app::push_command(command_of(kWall, folder.path, {"load.height=2.2 m"})),
                      Catch::Contains("load.height: must lie within the loading beam"));
}

TEST_CASE(
    "scene command: what no memory holds is refused by a push, by the key to change, and drawn",
    "[app][scene]")
{
    const app::Study fine =
        study_of(kWall, {"solver.contact_points=100", "solver.zones_per_interval=1",
                         "wall.length=50 m"});
    CHECK_THROWS_WITH(app::cost_note(app::prepare(fine), app::Purpose::push),
                      Catch::Contains("solver.contact_points: the blocks would take about"));
    CHECK_THAT(app::cost_note(app::prepare(fine), app::Purpose::drawing),
               Catch::StartsWith("note: making"));
    const app::Study high =
        study_of(kWall, {"wall.length=60 mm", "wall.unit_length=6 mm", "wall.courses=2",
                         "wall.course_height=6 mm", "beam.height=10 m", "load.height=10 m"});
    CHECK_THROWS_WITH(app::cost_note(app::prepare(high), app::Purpose::push),
                      Catch::Contains("beam.height: the beam would take about"));
    CHECK(app::cost_note(app::prepare(study_of(kWall)), app::Purpose::push).empty());
}

TEST_CASE("push: what takes long is told before it is paid for", "[app][scene]")
{
    CHECK(app::push_note(app::prepare(study_of(kWall))).empty());
    const std::string note = app::push_note(app::prepare(
        study_of(kWall, {"solver.contact_points=20", "solver.steps_per_mm=20000"})));
    CHECK_THAT(note, Catch::StartsWith("note: a push to its end takes about ") &&
                         Catch::Contains(" min of a core") &&
                         Catch::Contains("fewer solver.contact_points"));
    // a picture has no units to be made longer
    const app::PreparedStudy rubble = app::prepare(study_of(
        std::string(DRYSTONE_SOURCE_DIR) + "/configs/picture.ini", {"wall.simplify=2 mm"}));
    CHECK_THAT(app::push_note(rubble), Catch::Contains("a larger wall.simplify"));
    CHECK_THAT(app::cost_note(rubble, app::Purpose::push),
               Catch::Contains("a larger wall.simplify"));
    const app::Verb push{.name = "push"}, study{.name = "study"};
    CHECK_THAT(app::study_notes(rubble, &push), Catch::Contains("a push to its end takes"));
    CHECK_THAT(app::study_notes(rubble, &study), !Catch::Contains("a push to its end takes"));
}
