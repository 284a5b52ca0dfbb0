#include "app/scene/reading_again.hpp"

#include "app/drawing/outlines/raw_drawing.hpp"
#include "app/input/keys/study_keys.hpp"
#include "app/input/study/study.hpp"
#include "app/input/wall/wall_geometry.hpp"
#include "app/output/picture/markup.hpp"
#include "app/text/number_text.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string_view>

namespace app {
namespace {

/// As wall.length_unit calls it.
std::string_view unit_name(double metres)
{
    const auto difference = [&](const LengthUnit& u) { return std::abs(u.metres - metres); };
    return std::ranges::min_element(kLengthUnits, {}, difference)->name;
}

std::string stone_text(const dem::Elastic& stone)
{
    return number(stone.young_modulus * 1e-9, 12) + " GPa, " + number(stone.poisson_ratio, 12) +
           ", " + number(stone.density, 12) + " kg/m3";
}

std::string layer_stones_text(const Masonry& masonry)
{
    std::string text;
    for (std::size_t k = 0; k < masonry.geometry.layers.size(); ++k) {
        const dem::Elastic& stone =
            in_courses(masonry.geometry) ? masonry.wall.lintel : masonry.geometry.stones[k];
        text += (k == 0 ? "" : "; ") + masonry.geometry.layers[k] + ": " + stone_text(stone);
    }
    return text;
}

/// Keys of the study that are refused beside a drawing: "wall.length, wall.courses".
std::string refused_keys(Study drawn)
{
    drawn.geometry.file = "scene.dxf";
    drawn.geometry.outlines.clear();
    drawn.geometry.openings.clear();
    drawn.geometry.rubble = false;
    std::string text;
    for (const Key& key : study_keys()) {
        const Entry* const entry = find_entry(drawn.source, key.name);
        if (entry == nullptr || entry->preset) continue;
        const bool refused = key.used.refused && !is_used(key, drawn);
        if (refused || key.name == "wall.outlines")
            text += (text.empty() ? "" : ", ") + std::string(key.name);
    }
    return text;
}

} // namespace

std::string reading_again_text(const Study& study, bool cracked)
{
    const std::string unit(unit_name(study.geometry.length_unit));
    std::string text =
        "Their lengths are in " + unit +
        ". A study that reads one of them needs in [wall]:\nlength_unit = " + unit + '\n';
    if (cracked) text += "unit_length = " + number(study.wall.unit_length, 12) + " m\n";
    const bool lintels = !in_courses(study.geometry) || study.wall.lintel_bearing > 0.0;
    if (lintels && !study.geometry.layers.empty())
        text += "layer_stones = " + layer_stones_text(study) + '\n';
    if (const std::string refused = refused_keys(study); !refused.empty())
        text += wrapped("Take out of the study: " + refused + '\n', terminal_width());
    return text;
}

} // namespace app
