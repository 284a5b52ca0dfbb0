#include "app/input/study_reading.hpp"

#include "app/input/keys/key_reading.hpp"
#include "app/input/keys/key_values.hpp"
#include "app/input/keys/limit_state_text.hpp"
#include "app/input/keys/push_end.hpp"
#include "app/input/keys/study_keys.hpp"
#include "app/input/study/code_file.hpp"
#include "app/input/study/material_presets.hpp"
#include "app/input/study_checks.hpp"
#include "app/input/wall/joint_laws.hpp"
#include "app/input/wall/wall_geometry.hpp"
#include "app/text/number_text.hpp"
#include "app/text/text_file.hpp"
#include "app/text/words.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <filesystem>
#include <string_view>

namespace app {
namespace {

using KeyPair = std::array<std::string_view, 2>;

/// Two keys that give one thing. The one that --set gives takes the place of the other in the
/// file.
constexpr std::array<KeyPair, 2> kOneOfTwo = {
    {{"joint.wall_modulus", "joint.normal_stiffness"}, {"load.targets", "load.amplitudes"}}};

/// The same where joints close, which wall moduli tell, or a law.
constexpr std::array<KeyPair, 4> kOneOfTwoClosures = {
    {{"joint.wall_modulus", "joint.initial_stiffness"},
     {"joint.wall_modulus", "joint.maximum_closure"},
     {"joint.normal_stiffness", "joint.initial_stiffness"},
     {"joint.normal_stiffness", "joint.maximum_closure"}}};

StudyFile without_replaced(StudyFile file)
{
    std::vector<KeyPair> pairs(kOneOfTwo.begin(), kOneOfTwo.end());
    const Entry* closure = find_entry(file, "joint.closure");
    if (closure != nullptr && closure->value != "linear")
        pairs.insert(pairs.end(), kOneOfTwoClosures.begin(), kOneOfTwoClosures.end());
    for (const auto& [a, b] : pairs) {
        const Entry *const first = find_entry(file, a), *const second = find_entry(file, b);
        if (first == nullptr || second == nullptr) continue;
        if ((first->line == 0) == (second->line == 0)) continue; // a check refuses both
        const std::string_view replaced = first->line == 0 ? b : a;
        std::erase_if(file.entries, [&](const Entry& e) { return e.key == replaced; });
    }
    return file;
}

/// A friction that no joint has is a misunderstanding; data of units that cannot crack are not.
void refuse_unused(const Key& key, const Study& study)
{
    if (is_used(key, study) || find_entry(study.source, key.name) == nullptr) return;
    if (key.used.refused) throw error_at(study.source, key.name, key.used.otherwise);
}

bool is_derived(const Key& key, const Study& study)
{
    const bool given = find_entry(study.source, key.name) != nullptr;
    const bool rule = key.derived.apply != nullptr || key.derived.follow != nullptr;
    return !given && rule && is_used(key, study);
}

/// Fills in the values that were not given, in the order of the keys, and keeps the rules that
/// draws need.
void derive(Study& study)
{
    for (const Key& key : study_keys()) {
        if (!is_derived(key, study)) continue;
        if (key.derived.apply != nullptr) key.derived.apply(study);
        if (key.derived.follow == nullptr) continue;
        key.derived.follow(study.parameters, study.wall.course_height);
        study.rules.push_back({key.derived.follow, key.varies});
    }
}

void leave_out_unfit_height(Study& study)
{
    study.load.unfit_height = unfit_height(study.load, study.beam, wall_height(study));
    if (!study.load.unfit_height.empty()) find_key("load.height")->derived.apply(study);
}

} // namespace

Study read_study(const StudyFile& file, Purpose purpose)
{
    if (is_program_study(file))
        throw ConfigError(file.path, find_section(file, "model")->line, "[model]",
                          "only the verb reliability takes a study of another program");
    refuse_unknown(file, study_keys());
    Study study;
    study.source = with_material(without_replaced(file));
    for (const Key& key : study_keys()) read_key(key, study);
    read_own_codes(study);
    for (const Key& key : study_keys()) refuse_unused(key, study);
    check_cycles(study.load, study.source);
    study.wall.toe_at_left = push_way(study.load).direction < 0;
    read_geometry(study);
    check_stiffness(study, study.load, study.source);
    derive(study);
    if (purpose == Purpose::drawing) leave_out_unfit_height(study);
    check_relations(study);
    static_cast<void>(reading_rules(study)); // a wrong rule is found before any wall is run
    return study;
}

Study read_study(const std::string& path, std::span<const std::string> overrides,
                 Purpose purpose)
{
    return read_study(with_overrides(read_study_file(path), overrides), purpose);
}

namespace {

/// Files of records by their whole paths: the text may be read from another folder. A path that
/// would not be read back as it is stays as given.
std::string with_whole_paths(const Entry& entry, const StudyFile& file)
{
    const std::string& records = entry.value;
    bool any = false;
    std::string text;
    for (const std::string& part : split_outside_brackets(records)) {
        const std::string path = whole_path(path_from(file, entry.key, part).string());
        const bool is_whole =
            !path.empty() && path.find_first_of("#;,()\"") == std::string::npos;
        any = any || is_whole;
        text += (text.empty() ? "" : ", ") + (is_whole ? path : part);
    }
    return any ? text : records;
}

/// A study stands alone: what was read from a drawing, or found out, stands in it.
std::string written_value(const Key& key, const Entry* entry, const Study& study)
{
    if (is_drawn(study.geometry)) {
        if (key.name == "wall.outlines") return outlines_text(study.geometry);
        if (says_how_a_file_is_read(key)) return {};
    }
    if (key.name == "unit.cracks_where") return study.cracks.where;
    if (key.name == "fragility.codes" && entry != nullptr) return study.fragility.codes;
    if (entry != nullptr && (key.name == "shaking.records" || key.name == "shaking.vertical"))
        return with_whole_paths(*entry, study.source);
    if (!study.load.scaled.empty()) {
        if (key.name == "load.protocol_scale") return "given";
        if (key.name == "load.max_displacement") return value_text(key, study);
    }
    return entry != nullptr ? entry->value : value_text(key, study);
}

/// How often a draw would lie outside the range of its key, where it is cut off.
std::string cut_text(const Key& key, const std::vector<RandomInput>& inputs, bool first)
{
    for (const RandomInput& random : inputs)
        if (random.key == key.name && random.cut > 0.0)
            return std::string(first ? "" : ", ") + "a share of " + number(random.cut, 2) +
                   " lies outside the range of this key and is cut off";
    return "";
}

} // namespace

std::string effective_configuration(const Study& study)
{
    std::string text;
    std::string_view section;
    for (const Key& key : study_keys()) {
        const Entry* entry = find_entry(study.source, key.name);
        if (entry == nullptr && !is_used(key, study)) continue;
        const std::string value = written_value(key, entry, study);
        if (value.empty()) continue;
        if (section_of(key.name) != section) {
            section = section_of(key.name);
            text += (text.empty() ? "[" : "\n[") + std::string(section) + "]\n";
        }
        // Read as given, a value that follows from others would no longer follow their draws.
        const bool follows =
            !study.random.empty() && is_derived(key, study) && !says_push_end(key);
        // Nor may the law of closure stand beside the moduli to which it is fitted.
        const bool fitted =
            entry == nullptr && is_fitted_closure(study.parameters.joint) &&
            (key.name == "joint.initial_stiffness" || key.name == "joint.maximum_closure");
        // How results are read is no part of the walls: a later version reads them its own way.
        const bool reading =
            entry == nullptr &&
            (section == "fragility" || section == "reliability" || section == "calibration");
        // The height of body forces is no choice: it would be refused.
        const bool told = entry == nullptr && key.name == "load.height" &&
                          study.load.pattern == dem::LoadPattern::body;
        std::string line((follows || fitted || reading || told ? "# " : "") +
                         std::string(name_in_section(key.name)));
        line.resize(std::max<std::size_t>(line.size(), 24), ' ');
        line += "= " + value;
        std::string mark = follows            ? "default, follows the draws"
                           : entry == nullptr ? "default"
                           : entry->preset    ? "wall.material"
                           : entry->line == 0 ? "--set"
                                              : "";
        if (key.name == "load.max_displacement" && !study.load.scaled.empty())
            mark =
                "ultimate displacement of the mean wall pushed one way: " + study.load.scaled;
        if (fitted) mark += ", fitted: residuals " + fit_residuals(study);
        mark += cut_text(key, study.random, mark.empty());
        if (!mark.empty()) line.resize(std::max<std::size_t>(line.size() + 2, 56), ' ');
        text += line + (mark.empty() ? "" : "# ") + mark + "\n";
    }
    return text;
}

} // namespace app
