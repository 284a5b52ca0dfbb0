#include "app/input/key_effects.hpp"

#include "app/input/keys/key_values.hpp"
#include "app/input/study/material_presets.hpp"
#include "app/input/study_reading.hpp"
#include "app/input/wall/joint_laws.hpp"
#include "app/input/wall/wall_geometry.hpp"
#include "app/text/number_text.hpp"
#include "dem/scene/symmetry.hpp"

#include <algorithm>
#include <utility>
#include <vector>

namespace app {

bool reads(const Verb& verb, const Key& key)
{
    return is_listed(section_of(key.name), verb.sections) &&
           (key.verbs.empty() || key.verbs.has(verb.name));
}

namespace {

/// Whether the study gives the key the value that it would have without it.
bool is_default(const Key& key, const Study& study)
{
    const auto& [rule, apply, follow] = key.derived;
    Study without;
    if (is_used(key, study) && (apply != nullptr || follow != nullptr)) {
        without = study;
        key.field.set(without, key.field.get(Study{})); // the rule may leave it as it is
        if (apply != nullptr) apply(without);
        if (follow != nullptr) follow(without.parameters, study.wall.course_height);
    }
    return value_text(key, study) == value_text(key, without);
}

} // namespace

std::string effect_notes(const Study& study, const Verb& verb)
{
    std::vector<std::pair<std::string_view, std::string>> reasons; // and their keys
    for (const Key& key : study_keys()) {
        const Entry* const entry = find_entry(study.source, key.name);
        if (!reads(verb, key) || entry == nullptr || entry->preset) continue;
        const std::string_view why = why_no_effect(key, study);
        // The study of a pushed wall writes out all defaults, and nothing is lost with one that
        // plays no part.
        if (why.empty() || is_default(key, study)) continue;
        const auto found =
            std::ranges::find_if(reasons, [&](const auto& r) { return r.first == why; });
        if (found == reasons.end())
            reasons.emplace_back(why, key.name);
        else
            found->second += ", " + std::string(key.name);
    }
    std::string notes;
    for (const auto& [why, keys] : reasons)
        notes += "note: " + keys + ": no effect, because " + std::string(why) + "\n";
    return notes;
}

void refuse_drawn(const UqInput& uq, const StudyFile& source)
{
    if (!uq.drawn.empty())
        throw error_at(
            source, "uq.drawn",
            "names one wall of the study, and only push and sheet read it; remove it");
}

namespace {

/// A response is that of one push.
void refuse_both_ways(const PreparedStudy& ready, const Verb& verb)
{
    const Study& study = ready.study;
    constexpr VerbSet kOnce = "reliability serve";
    if (study.load.direction == Direction::both && is_given(study.source, "load.direction") &&
        kOnce.has(verb.name) && push_way(study.load).direction != 0 &&
        !dem::is_symmetric(ready.layout))
        throw error_at(study.source, "load.direction",
                       "both is for push, sheet and study; here a wall is pushed once: write "
                       "right or left, and run it for each");
}

} // namespace

std::string study_notes(const PreparedStudy& ready, const Verb* verb)
{
    if (verb == nullptr) return "";
    const Study& study = ready.study;
    if (!reads(*verb, *find_key("uq.drawn"))) refuse_drawn(study.uq, study.source);
    refuse_both_ways(ready, *verb);
    std::string notes = effect_notes(study, *verb);
    const std::string material = material_text(study.source);
    if (reads(*verb, *find_key("wall.material")) && !material.empty())
        notes += "note: the wall is of " + material + ". Sources: drystone help materials\n";
    if (reads(*verb, *find_key("joint.closure"))) notes += joint_law_notes(study, study.source);
    if (!study.load.scaled.empty())
        notes +=
            "note: load.protocol_scale: the protocol goes to " +
            fixed(study.load.max_displacement * 1e3, 2) +
            " mm; ultimate displacement of the mean wall pushed one way: " + study.load.scaled +
            '\n';
    const bool pushes = reads(*verb, *find_key("output.record_every"));
    notes += cost_note(ready, pushes ? Purpose::push : Purpose::drawing);
    if (verb->name == "push" || verb->name == "sheet") notes += push_note(ready);
    const std::string key = study.geometry.file.empty() ? "wall.outlines" : "wall.geometry";
    for (const std::string& note : study.geometry.notes)
        notes += "note: " + key + ": " + note + '\n';
    return notes;
}

} // namespace app
