#include "app/input/keys_page.hpp"
#include "app/input/prepared_study.hpp"
#include "app/input/study/material_presets.hpp"

#include "app/input/key_effects.hpp"
#include "app/input/keys/key_reading.hpp"
#include "app/input/keys/study_keys.hpp"
#include "app/input/study_reading.hpp"
#include "app/input/wall/wall_geometry.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

namespace {

using app::Study;

/// A wall whose material is left open.
const std::string kWall = R"([wall]
length = 1 m
courses = 10
course_height = 0.1 m
unit_length = 0.2 m
thickness = 0.2 m
[beam]
height = 0.1 m
young_modulus = 30 GPa
density = 2500 kg/m3
[load]
vertical_stress = 0.30, 0.50 MPa
)";

Study read(const std::vector<std::string>& overrides)
{
    return app::prepare(app::read_study(app::with_overrides(
                            app::parse_study_text("study.ini", kWall), overrides)))
        .study;
}

std::string refusal(const std::vector<std::string>& overrides)
{
    try {
        static_cast<void>(read(overrides));
    } catch (const app::ConfigError& e) {
        return e.what();
    }
    return "";
}

std::string page(const std::string& name)
{
    std::ifstream in(std::string(DRYSTONE_SOURCE_DIR) + "/" + name);
    return {std::istreambuf_iterator<char>(in), {}};
}

} // namespace

TEST_CASE("material presets: each one alone is a whole material", "[app][material_presets]")
{
    for (const app::MaterialPreset& preset : app::material_presets()) {
        INFO(preset.name);
        const Study s = read({"wall.material=" + std::string(preset.name)});
        for (const app::MaterialValue& v : preset.values) {
            INFO(v.key);
            REQUIRE(app::find_key(v.key) != nullptr);
            CHECK(app::find_entry(s.source, v.key)->value == v.value);
            CHECK_FALSE(v.source.empty());
        }
        CHECK(s.random.size() >= 4);
        CHECK(app::kMaterialNames[static_cast<std::size_t>(s.geometry.material)] ==
              preset.name);
    }
    CHECK(app::material_presets().size() + 1 == app::kMaterialNames.size());
}

TEST_CASE("material presets: the sandstone is that of configs/closure.ini",
          "[app][material_presets]")
{
    const std::string file = std::string(DRYSTONE_SOURCE_DIR) + "/configs/closure.ini";
    const Study paper = app::prepare(app::read_study(file, {})).study;
    const Study preset = read({"wall.material=dry_sandstone"});
    const app::Parameters &a = paper.parameters, &b = preset.parameters;
    CHECK(b.joint.closure == a.joint.closure);
    CHECK(b.joint.closing.initial_stiffness ==
          Approx(a.joint.closing.initial_stiffness).epsilon(2e-5));
    CHECK(b.joint.closing.maximum == Approx(a.joint.closing.maximum).epsilon(2e-5));
    CHECK(b.stone.young_modulus == a.stone.young_modulus);
    REQUIRE(paper.random.size() == preset.random.size());
    for (std::size_t i = 0; i < paper.random.size(); ++i) {
        CHECK(paper.random[i].key == preset.random[i].key);
        for (const double p : {0.02, 0.5, 0.98})
            CHECK(quantile(paper.random[i].marginal, p) ==
                  quantile(preset.random[i].marginal, p));
    }
}

TEST_CASE("material presets: a key that the study writes wins", "[app][material_presets]")
{
    const Study s = read({"wall.material=rubble_lime", "joint.cohesion=0.1 MPa",
                          "joint.normal_stiffness=3, 4 GPa/m"});
    CHECK(s.parameters.joint.cohesion == 0.1e6);
    CHECK(s.parameters.joint.wall_modulus.empty()); // one stiffness, one origin
    CHECK(s.parameters.joint.normal_stiffness == std::vector{3e9, 4e9});
    CHECK(app::find_entry(s.source, "joint.stiffness_factor") != nullptr);
    const std::string said = app::material_text(s.source);
    CHECK(said ==
          "irregular rubble in lime mortar (wall.material = rubble_lime), which gives 11 "
          "values; guesses among them: all");
    CHECK(app::material_text(read({"wall.material=dry_sandstone"}).source) ==
          "sawn sandstone without mortar, of the paper and its tests (wall.material = "
          "dry_sandstone), which gives 13 values; guesses among them: stone.density");
}

TEST_CASE("material presets: a study that is written out is the same study",
          "[app][material_presets]")
{
    for (const char* const more :
         {"joint.friction_angle=25 deg", "joint.wall_modulus=500 MPa"}) {
        const Study s = read({"wall.material=ashlar_lime", more});
        const std::string text = app::effective_configuration(s);
        CHECK(text.find("# wall.material\n") != std::string::npos);
        const Study again =
            app::prepare(app::read_study(app::parse_study_text("study.ini", text))).study;
        for (const app::Key& key : app::study_keys()) {
            INFO(key.name);
            CHECK(key.field.get(again) == key.field.get(s));
        }
        CHECK(again.random.size() == s.random.size());
    }
}

TEST_CASE("material presets: bad words are answered", "[app][material_presets]")
{
    CHECK(refusal({"wall.material=rubble_limes"}).find("did you mean \"rubble_lime\"?") !=
          std::string::npos);
    CHECK(refusal({}).find("stone.young_modulus: missing") != std::string::npos);
    CHECK(refusal({"wall.material=dry_sandstone", "joint.closure=linear"})
              .find("joint.wall_modulus: missing") != std::string::npos);
}

TEST_CASE("material presets: values without effect are no remark on the study",
          "[app][material_presets]")
{
    constexpr app::Verb kPush{.name = "push", .sections = app::kWallSections};
    const Study s = read({"wall.material=rubble_lime", "wall.unit_cracks=no"});
    CHECK(app::effect_notes(s, kPush).find("unit.tensile_strength") == std::string::npos);
}

TEST_CASE("material presets: docs/materials.md is current", "[app][material_presets]")
{
    INFO("write it anew: ./drystone help materials > docs/materials.md");
    CHECK(page("docs/materials.md") == app::materials_page());
}

TEST_CASE("keys page: docs/keys.md is current", "[app][keys_page]")
{
    INFO("write it anew: ./drystone help keys > docs/keys.md");
    CHECK(page("docs/keys.md") == app::keys_page());
}
