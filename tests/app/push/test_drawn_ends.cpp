#include "app/input/prepared_study.hpp"
#include "app/input/study_reading.hpp"
#include "app/input/wall/drawn_ends.hpp"
#include "app/input/wall/layer_stones.hpp"
#include "app/input/wall/wall_geometry.hpp"
#include "app/scene/scene_units.hpp"
#include "dem/scene/bond_indices.hpp"
#include "scenes/temporary_folder.hpp"
#include "tests/app/drawing/drawing_scenes.hpp"

#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <exception>
#include <fstream>
#include <string>
#include <vector>

namespace {

using scenes::rectangle;

const std::string kWall = R"([wall]
geometry = w.json
length_unit = mm
thickness = 0.40 m
base = joint
[stone]
young_modulus = 15 GPa
poisson_ratio = 0.2
density = 2000 kg/m3
[joint]
normal_stiffness = 8 GPa/m
friction_angle = 30 deg
[load]
max_displacement = 5 mm
)";
const std::string kBeam = R"(vertical_stress = 0.05 MPa
[beam]
height = 0.20 m
young_modulus = 30 GPa
density = 2500 kg/m3
)";

app::Study wall_of(const std::vector<scenes::Outline>& blocks, const std::string& load = kBeam)
{
    const scenes::TemporaryFolder folder;
    std::ofstream(folder.path / "w.json") << scenes::json_text(blocks);
    std::ofstream(folder.path / "study.ini") << kWall << load;
    return app::prepare(
               app::read_study(app::read_study_file((folder.path / "study.ini").string())))
        .study;
}

/// Stack bond: two courses of five stones, with these feet and tops [mm].
std::vector<scenes::Outline> stack(std::array<double, 5> feet, std::array<double, 5> tops)
{
    std::vector<scenes::Outline> blocks;
    for (std::size_t i = 0; i < 5; ++i) {
        const double left = 400.0 * static_cast<double>(i), right = left + 400.0;
        blocks.push_back(rectangle(left, feet[i], right, 300.0));
        blocks.push_back(rectangle(left, 300.0, right, tops[i]));
    }
    return blocks;
}

bool has_note(const app::Study& study, const std::string& text)
{
    for (const std::string& note : study.geometry.notes)
        if (note.find(text) != std::string::npos) return true;
    return false;
}

/// A study of two stones drawn in DXF, with these layers below and above.
app::PreparedStudy dxf_wall(const std::string& below, const std::string& above,
                            const std::string& more = "", const std::string& unit = "")
{
    const scenes::TemporaryFolder folder;
    std::ofstream(folder.path / "w.dxf")
        << scenes::dxf_text(scenes::lwpolyline(rectangle(0, 0, 400, 300), true, below) +
                            scenes::lwpolyline(rectangle(0, 300, 400, 400), true, above));
    std::string study = kWall;
    study.replace(study.find("w.json"), 6, "w.dxf");
    study.insert(study.find("thickness"), more);
    std::ofstream(folder.path / "study.ini") << study << kBeam << unit;
    return app::prepare(
        app::read_study(app::read_study_file((folder.path / "study.ini").string())));
}

/// Refusal of a study of one block with these lines more in [wall].
std::string refusal_of(const std::string& wall, const std::string& file = "w.json")
{
    const scenes::TemporaryFolder folder;
    std::ofstream(folder.path / "w.json")
        << R"({"blocks": [{"layer": "wall", "outline": [[0, 0], [400, 0], [400, 300], [0, 300]]},
{"layer": "sill", "outline": [[0, 300], [400, 300], [400, 400], [0, 400]]}]})";
    std::ofstream(folder.path / "w.png", std::ios::binary)
        << scenes::png_bytes(scenes::pixels(40, 40, 0x600000));
    std::string study = kWall;
    study.replace(study.find("geometry = w.json\nlength_unit = mm\n"), 35,
                  (file.empty() ? "" : "geometry = " + file + "\n") + wall);
    std::ofstream(folder.path / "study.ini") << study << kBeam;
    try {
        static_cast<void>(app::prepare(app::read_study(app::read_study_file(
                                           (folder.path / "study.ini").string())))
                              .study);
    } catch (const std::exception& e) {
        return e.what();
    }
    return "read";
}

constexpr std::array<double, 5> kFlatFoot{}, kFlatTop{600, 600, 600, 600, 600};

} // namespace

TEST_CASE(
    "drawn ends: a top that scatters by less than wall.snap carries the beam from end to end",
    "[app][drawn_ends]")
{
    const app::Study study = wall_of(stack(kFlatFoot, {600, 599.7, 600.3, 599.8, 600}));
    CHECK(app::layout_of(study, study.source).length == Approx(2.0).epsilon(1e-12));
    CHECK_FALSE(has_note(study, "The beam lies"));
}

TEST_CASE(
    "drawn ends: what a beam lies on and what stands on the floor is told where it is not all",
    "[app][drawn_ends]")
{
    CHECK(wall_of(stack(kFlatFoot, kFlatTop)).geometry.notes.empty());
    const app::Study top = wall_of(stack(kFlatFoot, {600, 598, 602, 599, 600}));
    CHECK(has_note(top, "The beam rests on 0.40 m of the wall's 2.00 m: only the level sides"));
    const app::Study foot = wall_of(stack({3, 0, 2, 4, 2}, kFlatTop));
    CHECK(has_note(foot, "1 of 5 lowest blocks stand on the floor"));
    CHECK(has_note(foot, "begin up to 4 mm above it"));
}

TEST_CASE("drawn ends: a beam that nothing level can carry is refused with what to write",
          "[app][drawn_ends]")
{
    const std::vector<scenes::Outline> gable{{0, 0, 600, 0, 300, 300}};
    CHECK_THROWS_WITH(wall_of(gable), Catch::Contains("beam.present = no"));
    CHECK_NOTHROW(
        wall_of(gable, "vertical_stress = 0 MPa\npattern = body\n[beam]\npresent = no\n"));
}

TEST_CASE("drawn ends: straight joints of an uneven wall are ways from the floor to the top",
          "[app][drawn_ends]")
{
    for (const auto& blocks :
         {stack(kFlatFoot, {600, 598, 602, 599, 600}), stack({3, 0, 2, 4, 2}, kFlatTop)}) {
        const app::Study study = wall_of(blocks);
        const dem::Layout whole = app::whole_units(study, study.source);
        CHECK(dem::bond_indices(whole).trace_ratio == Approx(1.0).epsilon(1e-9));
    }
    std::vector<scenes::Outline>
        covered; // a stone over the straight joint, ending 10 mm higher
    covered.push_back(rectangle(0, 0, 400, 590));
    covered.push_back(rectangle(400, 0, 800, 590));
    covered.push_back(rectangle(0, 590, 800, 600));
    const app::Study study = wall_of(covered);
    const dem::Layout whole = app::whole_units(study, study.source);
    CHECK(std::isnan(dem::bond_indices(whole).trace));
}

TEST_CASE("layer stones: names, values and layers that cannot be meant are refused",
          "[app][drawn_ends]")
{
    const std::string sill = "layer_stones = sill: 30 GPa, 0.2, 2500 kg/m3";
    CHECK(refusal_of(sill + "\n") == "read");
    CHECK_THAT(refusal_of(sill + "; sill: 20 GPa, 0.2, 2500 kg/m3\n"),
               Catch::Contains("the layer \"sill\" has two stones"));
    CHECK_THAT(refusal_of("layer_stones = sill: 30 GPa, 0.2, 1000000000 kg/m3\n"),
               Catch::Contains("the density in [0, 20000] kg/m3"));
    CHECK_THAT(refusal_of("layer_stones = lintel: 30 GPa, 0.2, 2500 kg/m3\n"),
               Catch::Contains("has no layer \"lintel\"; it has: sill, wall"));
    CHECK_THAT(refusal_of("picture_width = 1 m\npicture_height = 1 m\n" + sill + "\n", "w.png"),
               Catch::Contains("a picture has none: draw the wall"));
}

TEST_CASE("layers: DXF does not tell upper from lower case", "[app][drawn_ends]")
{
    CHECK(dxf_wall("Stone", "STONE").study.geometry.drawn_layers ==
          std::vector<std::string>{"Stone"});
    const app::Study sill =
        dxf_wall("Stone", "SILL", "layer_stones = Sill: 30 GPa, 0.2, 2500 kg/m3\n").study;
    CHECK(sill.geometry.drawn_layers == std::vector<std::string>{"Stone", "Sill"});
    CHECK(sill.geometry.units.at(0).material == 0);
    CHECK(sill.geometry.units.at(1).material == 1);
    // a layer of lintels, whose stones never crack
    const std::string halves = "unit_length = 0.40 m\n";
    const std::string stone = ": 30 GPa, 0.2, 2500 kg/m3\n";
    const std::string unit = R"([unit]
tensile_strength = 3.7 MPa
fracture_energy = 110 N/m
friction_angle = 35 deg
)";
    const auto cracks = [&](const std::string& layer) {
        return dxf_wall("Stone", layer, halves + "layer_stones = " + layer + stone, unit)
            .layout.n_cracks;
    };
    CHECK(cracks("SILL") == 2);
    CHECK(cracks("LINTEL") == 1);
    CHECK(cracks("lintel") == 1);
}

TEST_CASE("layers: a drawing with several says how many stones each has", "[app][drawn_ends]")
{
    app::Drawing drawing;
    for (const char* const layer : {"brick", "mortar", "brick", "sill", ""})
        drawing.blocks.emplace_back().layer = layer;
    const std::vector<std::string> sill = {"sill"};
    CHECK_THAT(
        app::layers_note(drawing, sill),
        Catch::Contains("stones: 1 stone without a layer, 2 stones on \"brick\", 1 stone "
                        "on \"mortar\". Turn a layer off"));
    drawing.blocks.resize(1);
    CHECK(app::layers_note(drawing, {}).empty());
    drawing.blocks.emplace_back().layer = "sill";
    CHECK(app::layers_note(drawing, sill).empty());
    for (const char* const layer : {"a", "b", "c", "d", "e", "f"})
        drawing.blocks.emplace_back().layer = layer;
    CHECK_THAT(app::layers_note(drawing, sill),
               Catch::Contains("on \"e\" and more on 1 layer. Turn") &&
                   !Catch::Contains("\"f\""));
}

TEST_CASE("outlines of a study are refused without advice about a key that plays no part",
          "[app][drawn_ends]")
{
    const std::string why = refusal_of(
        "outlines = 0 0, 0.4 0, 0.4 0.3, 0 0.3; 0.3 0, 0.7 0, 0.7 0.3, 0.3 0.3\n", "");
    CHECK_THAT(why, Catch::Contains("this block overlaps the block at (0, 0)"));
    CHECK_THAT(why, !Catch::Contains("wall.snap"));
    CHECK_THAT(
        refusal_of("outlines = 0 0, 0.4 0, 0.4 0.3, 0 0.3; 0 0.5, 1 0.5, 1 1, 0 1\n", ""),
        Catch::EndsWith("close the gap of 200 mm to the block at (0, 0)"));
}
