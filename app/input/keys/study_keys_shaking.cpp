#include "app/input/keys/study_key_table.hpp"

#include <algorithm>

namespace app {
namespace {

constexpr std::array kShakingDesigns = {named("crossed", ShakingDesign::crossed),
                                        named("paired", ShakingDesign::paired)};

// clang-format off
constexpr std::array kShakingKeys = {
    Key{.name = "shaking.records", .kind = Kind::text, .verbs = "study shake",
        .derived = {"none: the ground is at rest"},
        .meaning = "motions of the ground: files of records (from the folder of the study, with --set from the current folder), pulses such as half_sine(peak 0.5 g, duration 0.3 s), or kanai_tajimi(peak 0.3 g, records 20), with commas between",
        .field = kAt<&Study::shaking, &ShakingInput::records>},
    Key{.name = "shaking.intensities", .kind = Kind::text, .used = kShaken, .verbs = "study shake",
        .derived = {"the motions as they are"},
        .meaning = "values of shaking.measure to which each record is scaled: 0.1, 0.2 g",
        .field = kAt<&Study::shaking, &ShakingInput::intensities>},
    Key{.name = "shaking.measure", .kind = Kind::text, .used = kShaken, .verbs = "study shake",
        .meaning = "measure of the intensities: pga, pgv or sa(0.3 s)",
        .field = kAt<&Study::shaking, &ShakingInput::measure>},
    Key{.name = "shaking.scale", .range = {'(', 0, 1e6, ']'}, .used = kShaken, .verbs = "study shake",
        .meaning = "factor on all motions",
        .field = kAt<&Study::shaking, &ShakingInput::scale>},
    Key{.name = "shaking.vertical", .kind = Kind::text, .used = kShaken, .verbs = "study shake",
        .meaning = "vertical motion, a file (found as shaking.records) or a pulse, scaled as the horizontal one; none",
        .field = kAt<&Study::shaking, &ShakingInput::vertical>},
    Key{.name = "shaking.contact_damping", .range = {'[', 0, 1000, ']'}, .used = kShaken, .verbs = "study shake",
        .meaning = "share of critical damping in dry contacts, for the normal motion of two blocks (docs/dynamics.md)",
        .field = kAt<&Study::shaking, &ShakingInput::contact_damping>},
    Key{.name = "shaking.push", .kind = Kind::word, .names = kYesNo, .used = kShaken, .verbs = "study",
        .meaning = "push each wall as well, for its ultimate drift: 80 % of it is a damage state of the same wall when it is shaken",
        .field = kAt<&Study::shaking, &ShakingInput::push>},
    Key{.name = "shaking.design", .kind = Kind::word, .names = kShakingDesigns, .used = kShaken, .verbs = "study",
        .meaning = "crossed: each wall under each record; paired: wall k under record k, and under the first ones again after the last",
        .field = kAt<&Study::shaking, &ShakingInput::design>},
};
// clang-format on

} // namespace

std::span<const Key> shaking_keys() { return kShakingKeys; }

} // namespace app
