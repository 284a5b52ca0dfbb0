#include "app/input/study/material_presets.hpp"

#include "app/text/words.hpp"

#include <algorithm>
#include <vector>

namespace app {
namespace {

constexpr std::string_view kTable =
    "Circolare 7/2019, Table C8.5.I, from memory: compare with your copy";
constexpr std::string_view kScatter =
    "range of that table as mean and one standard deviation each way";
constexpr std::string_view kCrushes =
    "strength of the masonry in that table, taken as that of the faces of joints";
constexpr std::string_view kBond = "1.5 tau_0 of that table, taken as that of the joints";
constexpr std::string_view kFriction =
    "coefficient of 0.577, usual for such joints; scatter assumed";
constexpr std::string_view kAssumed = "no source";
constexpr std::string_view kAsSandstone = "as the sandstone of the tests";
constexpr std::string_view kWeight = "weight of the masonry in Table C8.5.I, from memory";

// clang-format off
constexpr MaterialValue kRubbleLime[] = {
    {"stone.young_modulus", "20 GPa", kAssumed, true},
    {"stone.poisson_ratio", "0.2", kAssumed, true},
    {"stone.density", "1940 kg/m3", kWeight, true},
    {"joint.wall_modulus", "870 MPa", kTable, true},
    {"joint.stiffness_factor", "lognormal(mean 1, cov 0.21)", kScatter, true},
    {"joint.friction_angle", "normal(mean 30 deg, cov 0.15)", kFriction, true},
    {"joint.cohesion", "lognormal(mean 0.038 MPa, cov 0.28)", kBond, true},
    {"joint.tensile_strength", "lognormal(mean 0.038 MPa, cov 0.28)", kBond, true},
    {"joint.fracture_energy", "10 N/m", kAssumed, true},
    {"joint.compressive_strength", "lognormal(mean 1.5 MPa, cov 0.33)", kCrushes, true},
    {"unit.tensile_strength", "lognormal(mean 5 MPa, cov 0.30)", kAssumed, true},
    {"unit.fracture_energy", "110 N/m", kAsSandstone, true},
    {"unit.friction_angle", "normal(mean 35 deg, cov 0.20)", kAsSandstone, true},
};
constexpr MaterialValue kRoughlySquared[] = {
    {"stone.young_modulus", "20 GPa", kAssumed, true},
    {"stone.poisson_ratio", "0.2", kAssumed, true},
    {"stone.density", "2040 kg/m3", kWeight, true},
    {"joint.wall_modulus", "1230 MPa", kTable, true},
    {"joint.stiffness_factor", "lognormal(mean 1, cov 0.17)", kScatter, true},
    {"joint.friction_angle", "normal(mean 30 deg, cov 0.15)", kFriction, true},
    {"joint.cohesion", "lognormal(mean 0.065 MPa, cov 0.19)", kBond, true},
    {"joint.tensile_strength", "lognormal(mean 0.065 MPa, cov 0.19)", kBond, true},
    {"joint.fracture_energy", "10 N/m", kAssumed, true},
    {"joint.compressive_strength", "lognormal(mean 2.0 MPa, cov 0.20)", kCrushes, true},
    {"unit.tensile_strength", "lognormal(mean 5 MPa, cov 0.30)", kAssumed, true},
    {"unit.fracture_energy", "110 N/m", kAsSandstone, true},
    {"unit.friction_angle", "normal(mean 35 deg, cov 0.20)", kAsSandstone, true},
};
constexpr MaterialValue kAshlarLime[] = {
    {"stone.young_modulus", "20 GPa", kAssumed, true},
    {"stone.poisson_ratio", "0.2", kAssumed, true},
    {"stone.density", "2240 kg/m3", kWeight, true},
    {"joint.wall_modulus", "2850 MPa", kTable, true},
    {"joint.stiffness_factor", "lognormal(mean 1, cov 0.16)", kScatter, true},
    {"joint.friction_angle", "normal(mean 30 deg, cov 0.15)", kFriction, true},
    {"joint.cohesion", "lognormal(mean 0.23 MPa, cov 0.22)", "f_v0 of that table", true},
    {"joint.tensile_strength", "lognormal(mean 0.16 MPa, cov 0.14)", kBond, true},
    {"joint.fracture_energy", "15 N/m", kAssumed, true},
    {"joint.compressive_strength", "lognormal(mean 7.0 MPa, cov 0.17)", kCrushes, true},
    {"unit.tensile_strength", "lognormal(mean 5 MPa, cov 0.30)", kAssumed, true},
    {"unit.fracture_energy", "110 N/m", kAsSandstone, true},
    {"unit.friction_angle", "normal(mean 35 deg, cov 0.20)", kAsSandstone, true},
};
constexpr MaterialValue kDrySandstone[] = {
    {"stone.young_modulus", "15.5 GPa", "paper, section 3.1"},
    {"stone.poisson_ratio", "0.2", "paper, Table 4"},
    {"stone.density", "2300 kg/m3", "a sandstone", true},
    {"joint.closure", "exponential", "the moduli of the paper are tangents (docs/joint_laws.md)"},
    {"joint.initial_stiffness", "4.8665 GPa/m", "fitted to the four moduli of the paper's Table 3 (configs/closure.ini)"},
    {"joint.maximum_closure", "0.15374 mm", "fitted to the four moduli of the paper's Table 3 (configs/closure.ini)"},
    {"joint.stiffness_factor", "normal(mean 1, cov 0.25)", "paper, Table 5"},
    {"joint.friction_angle", "normal(mean 31.8 deg, cov 0.20)", "paper, Table 5"},
    {"unit.stiffness_ratio", "10", "paper, Table 4"},
    {"unit.tensile_strength", "lognormal(mean 3.7 MPa, cov 0.30)", "paper, Table 5"},
    {"unit.fracture_energy", "110 N/m", "paper, Table 4"},
    {"unit.friction_angle", "normal(mean 35 deg, cov 0.20)", "paper, Table 5"},
    {"unit.stiffness_factor", "normal(mean 1, cov 0.25)", "paper, Table 5"},
};
constexpr MaterialValue kDryGranite[] = {
    {"stone.young_modulus", "20 GPa", kAssumed, true},
    {"stone.poisson_ratio", "0.2", kAssumed, true},
    {"stone.density", "2650 kg/m3", "a granite", true},
    {"joint.closure", "exponential", kAsSandstone, true},
    {"joint.initial_stiffness", "4.8665 GPa/m", kAsSandstone, true},
    {"joint.maximum_closure", "0.15374 mm", kAsSandstone, true},
    {"joint.stiffness_factor", "normal(mean 1, cov 0.25)", kAsSandstone, true},
    {"joint.friction_angle", "normal(mean 33 deg, cov 0.15)", "coefficient of 0.65 of sawn granite, from memory; scatter assumed", true},
    {"joint.compressive_strength", "lognormal(mean 69 MPa, cov 0.20)", "of the stone, from memory; scatter assumed", true},
    {"unit.tensile_strength", "lognormal(mean 2.8 MPa, cov 0.30)", "from memory; scatter assumed", true},
    {"unit.fracture_energy", "110 N/m", kAsSandstone, true},
    {"unit.friction_angle", "normal(mean 35 deg, cov 0.20)", kAsSandstone, true},
};
constexpr MaterialPreset kMaterialPresets[] = {
    {kMaterialNames[1], "irregular rubble in lime mortar", kRubbleLime},
    {kMaterialNames[2], "roughly squared stones in lime mortar, leaves of uneven thickness", kRoughlySquared},
    {kMaterialNames[3], "squared blocks in lime mortar", kAshlarLime},
    {kMaterialNames[4], "sawn sandstone without mortar, of the paper and its tests", kDrySandstone},
    {kMaterialNames[5], "sawn granite without mortar", kDryGranite},
};
// clang-format on

/// Keys that say together how stiff joints are.
constexpr std::array<std::string_view, 6> kStiffnessKeys = {
    "joint.wall_modulus",        "joint.normal_stiffness",  "joint.closure",
    "joint.wall_modulus_stress", "joint.initial_stiffness", "joint.maximum_closure"};

bool tells_stiffness(std::string_view key)
{
    return std::ranges::find(kStiffnessKeys, key) != kStiffnessKeys.end();
}

std::string words_of(const std::vector<std::string_view>& keys)
{
    std::string text;
    for (const std::string_view key : keys)
        text += (text.empty() ? "" : ", ") + std::string(key);
    return text;
}

} // namespace

std::span<const MaterialPreset> material_presets() { return kMaterialPresets; }

const MaterialPreset* find_material(std::string_view name)
{
    for (const MaterialPreset& preset : kMaterialPresets)
        if (preset.name == name) return &preset;
    return nullptr;
}

StudyFile with_material(StudyFile file)
{
    const Entry* const given = find_entry(file, "wall.material");
    const MaterialPreset* const preset =
        given == nullptr ? nullptr : find_material(given->value);
    if (preset == nullptr) return file;
    const int line = given->line;
    const bool stiff =
        std::ranges::any_of(kStiffnessKeys, [&](auto key) { return is_given(file, key); });
    for (const MaterialValue& v : preset->values) {
        if (is_given(file, v.key) || (stiff && tells_stiffness(v.key))) continue;
        file.entries.push_back({std::string(v.key), std::string(v.value), line, true});
    }
    return file;
}

std::string material_text(const StudyFile& file)
{
    const Entry* const given = find_entry(file, "wall.material");
    const MaterialPreset* const preset =
        given == nullptr ? nullptr : find_material(given->value);
    if (preset == nullptr) return "";
    std::size_t keys = 0;
    std::vector<std::string_view> guesses;
    for (const MaterialValue& v : preset->values) {
        const Entry* const entry = find_entry(file, v.key);
        if (entry == nullptr || entry->value != v.value) continue;
        ++keys;
        if (v.guess) guesses.push_back(v.key);
    }
    if (keys == 0) return "";
    const std::string text = std::string(preset->meaning) +
                             " (wall.material = " + std::string(preset->name) +
                             "), which gives " + counted(keys, "value", "values");
    if (guesses.empty()) return text;
    return text +
           "; guesses among them: " + (guesses.size() == keys ? "all" : words_of(guesses));
}

std::string materials_page()
{
    std::string page =
        "# Materials by type\n\n"
        "Written by `drystone help materials > docs/materials.md`; a test keeps it current. "
        "One line of a study, such as\n"
        "`wall.material = roughly_squared`, takes all values of a material as distributions. A "
        "key "
        "written in the study itself takes precedence.\n"
        "If a study sets the stiffness of its joints (`joint.wall_modulus`, "
        "`joint.normal_stiffness`, or a closure), the material gives no key of stiffness.\n\n"
        "**Guess** marks our own assumptions, and values remembered from a source that was not "
        "at hand: compare them with your copy, and your copy with the wall.\n"
        "*Paper*: \"In-Plane Structural Performance of Dry-Joint Stone Masonry Walls\" "
        "(docs/theory.md, References).\n";
    for (const MaterialPreset& preset : kMaterialPresets) {
        page += "\n## " + std::string(preset.name) + "\n" + std::string(preset.meaning) +
                ".\n\n| key | value | source |\n|---|---|---|\n";
        for (const MaterialValue& v : preset.values)
            page += "| " + std::string(v.key) + " | " + std::string(v.value) + " | " +
                    (v.guess ? "**guess**: " : "") + std::string(v.source) + " |\n";
    }
    return page;
}

} // namespace app
