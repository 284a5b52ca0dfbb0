#pragma once
/// Materials by type: values, scatter and source of the keys of a study, which wall.material
/// takes over in one line.

#include "app/input/study/study_file.hpp"

#include <array>
#include <span>
#include <string>
#include <string_view>

namespace app {

/// Values of wall.material, in the order of material_presets(); the first is none of them.
inline constexpr std::array<std::string_view, 6> kMaterialNames = {
    "none", "rubble_lime", "roughly_squared", "ashlar_lime", "dry_sandstone", "dry_granite"};

/// One key that a material gives.
struct MaterialValue {
    std::string_view key, value;
    std::string_view source;
    bool guess = false; ///< ours, or remembered from a source that is not at hand
};

struct MaterialPreset {
    std::string_view name;
    std::string_view meaning; ///< "irregular rubble in lime mortar"
    std::span<const MaterialValue> values;
};

[[nodiscard]] std::span<const MaterialPreset> material_presets();

/// nullptr if there is none.
[[nodiscard]] const MaterialPreset* find_material(std::string_view name);

/// The file with the keys of its wall.material behind its own; a key that the file writes
/// itself wins. A file that says how stiff its joints are says all of it: then the material
/// gives no key of stiffness. A name that is no material is left to the reader of keys.
[[nodiscard]] StudyFile with_material(StudyFile file);

/// "irregular rubble in lime mortar (wall.material = rubble_lime), which gives 13 values;
/// guesses among them: all", without a full stop. Empty where the material gives nothing.
[[nodiscard]] std::string material_text(const StudyFile& file);

/// docs/materials.md.
[[nodiscard]] std::string materials_page();

} // namespace app
