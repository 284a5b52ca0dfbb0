#include "app/input/study_key_table.hpp"

#include <algorithm>

namespace app {
namespace {

constexpr Condition kShaken{[](const Study& s) { return !s.shaking.records.empty(); },
                            "there is no shaking.records; write it, or remove this key", true};

// clang-format off
constexpr std::array kShakingKeys = {
    Key{.name = "shaking.records", .kind = Kind::text, .verbs = "shake",
        .derived = {"none: the ground is at rest"},
        .meaning = "motions of the ground: files of records, seen from the folder of the study, or pulses such as half_sine(peak 0.5 g, duration 0.3 s), with commas between",
        .field = kAt<&Study::shaking, &ShakingInput::records>},
    Key{.name = "shaking.intensities", .kind = Kind::text, .used = kShaken, .verbs = "shake",
        .derived = {"the motions as they are"},
        .meaning = "values of shaking.measure to which each record is scaled: 0.1, 0.2 g",
        .field = kAt<&Study::shaking, &ShakingInput::intensities>},
    Key{.name = "shaking.measure", .kind = Kind::text, .used = kShaken, .verbs = "shake",
        .meaning = "measure of the intensities: pga, pgv or sa(0.3 s)",
        .field = kAt<&Study::shaking, &ShakingInput::measure>},
    Key{.name = "shaking.scale", .range = {'(', 0, 1e6, ']'}, .used = kShaken, .verbs = "shake",
        .meaning = "factor on all motions",
        .field = kAt<&Study::shaking, &ShakingInput::scale>},
    Key{.name = "shaking.vertical", .kind = Kind::text, .used = kShaken, .verbs = "shake",
        .meaning = "vertical motion, a file or a pulse, scaled as the horizontal one; none",
        .field = kAt<&Study::shaking, &ShakingInput::vertical>},
    Key{.name = "shaking.contact_damping", .range = {'[', 0, 1000, ']'}, .used = kShaken, .verbs = "shake",
        .meaning = "share of critical damping in dry contacts, for the normal motion of two blocks (docs/dynamics.md)",
        .field = kAt<&Study::shaking, &ShakingInput::contact_damping>},
};
// clang-format on

} // namespace

std::span<const Key> shaking_keys() { return kShakingKeys; }

} // namespace app
