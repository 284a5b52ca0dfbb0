#include "app/study/study_identity.hpp"

#include "app/input/key_values.hpp"
#include "app/input/wall_geometry.hpp"
#include "app/version.hpp"

#include <algorithm>
#include <array>

namespace app {
namespace {

/// Of no consequence for a wall.
constexpr std::array<std::string_view, 6> kFree = {"uq.samples",
                                                   "uq.stop",
                                                   "uq.stop_half_width",
                                                   "uq.most_samples",
                                                   "output.snapshot_every",
                                                   "output.paraview"};

std::string value_of(const Key& key, const Study& study)
{
    if (key.name == "wall.outlines" && is_drawn(study)) return outlines_mark(study);
    const bool random = std::ranges::count(study.random, key.name, &RandomInput::key) > 0;
    return random ? find_entry(study.source, key.name)->value : value_text(key, study);
}

} // namespace

std::string identity_text(const Study& study)
{
    std::string text = "drystone = " + std::string(kVersion) + "\n";
    for (const Key& key : study_keys()) {
        if (!is_used(key, study)) continue;
        if (std::ranges::count(kFree, key.name) > 0) continue;
        const std::string_view section = section_of(key.name);
        // How a wall has moved is read, and stored, where the force came down to this share.
        const bool stored =
            key.name == "fragility.ultimate_share" && push_plan(study).drop > 0.0;
        if (section == "reliability" || (section == "fragility" && !stored)) continue;
        if (is_drawn(study) && says_how_a_file_is_read(key))
            continue; // its outlines stand for it
        const std::string value = value_of(key, study);
        if (!value.empty()) text += std::string(key.name) + " = " + value + "\n";
    }
    return text;
}

} // namespace app
