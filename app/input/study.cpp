#include "app/input/study.hpp"

#include "app/input/key_values.hpp"
#include "app/input/number_text.hpp"
#include "app/input/study_checks.hpp"
#include "app/input/study_keys.hpp"
#include "app/input/units.hpp"
#include "app/input/words.hpp"
#include "dem/block/model.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string_view>

namespace app {
namespace {

std::vector<std::string_view> section_names()
{
    std::vector<std::string_view> names;
    for (const Key& key : study_keys()) {
        const std::string_view section = section_of(key.name);
        if (names.empty() || names.back() != section) names.push_back(section);
    }
    return names;
}

void refuse_unknown_section(const StudyFile& file, int line, std::string_view section)
{
    const std::string_view path = line > 0 ? std::string_view(file.path) : "--set";
    const std::string shown = "[" + std::string(section) + "]";
    const auto names = section_names();
    if (std::find(names.begin(), names.end(), section) == names.end()) {
        throw ConfigError(path, line, shown, "unknown section; " + suggestion(section, names));
    }
}

void refuse_unknown_key(const StudyFile& file, const Entry& entry)
{
    std::vector<std::string_view> all, in_section;
    for (const Key& key : study_keys()) {
        if (key.name == entry.key) return;
        all.push_back(key.name);
        if (section_of(key.name) == section_of(entry.key)) {
            in_section.push_back(name_in_section(key.name));
        }
    }
    const std::string_view nearest = nearest_word(entry.key, all);
    throw error_at(file, entry.key,
                   "unknown key; " + (nearest.empty()
                                          ? "use " + listed(in_section)
                                          : "did you mean " + in_quotes(nearest) + "?"));
}

void refuse_unknown(const StudyFile& file)
{
    for (const SectionHeader& s : file.sections) refuse_unknown_section(file, s.line, s.name);
    for (const Entry& e : file.entries) {
        refuse_unknown_section(file, e.line, section_of(e.key));
        refuse_unknown_key(file, e);
    }
}

/// A field whose value is a distribution holds its mean.
void read_value(const Key& key, const std::string& text, Study& study)
{
    if (auto random = parse_random(key, text)) {
        key.field.set(study, {random->mean});
        study.random.push_back(std::move(*random));
    } else {
        key.field.set(study, parse_value(key, text));
    }
}

void read_given(const Key& key, Study& study)
{
    if (const Entry* entry = find_entry(study.source, key.name)) {
        try {
            read_value(key, entry->value, study);
        } catch (const BadValue& bad) {
            throw error_at(study.source, key.name, bad.what());
        }
    } else if (!key.example.empty() && is_used(key, study)) {
        throw error_at(study.source, key.name,
                       "missing; write e.g. \"" + std::string(name_in_section(key.name)) +
                           " = " + std::string(key.example) + "\" under [" +
                           std::string(section_of(key.name)) + "]");
    }
}

/// A friction that no joint has is a misunderstanding; data of units that cannot crack are not.
void refuse_unused(const Key& key, const Study& study)
{
    if (is_used(key, study) || find_entry(study.source, key.name) == nullptr) return;
    if (key.used == Used::with_base_joint) {
        throw error_at(study.source, key.name,
                       "there is no base joint; write wall.base = joint, or remove it");
    }
    if (key.used == Used::with_beam_joint) {
        throw error_at(study.source, key.name,
                       "there is no beam joint; write beam.interface = joint, or remove it");
    }
}

bool is_derived(const Key& key, const Study& study)
{
    const bool given = find_entry(study.source, key.name) != nullptr;
    return !given && key.derived.apply != nullptr && is_used(key, study);
}

/// Value of one level of a list that has one value for all levels, or one for each.
double at_level(const std::vector<double>& values, int level)
{
    return values.size() == 1 ? values.front() : values.at(static_cast<std::size_t>(level));
}

dem::JointParameters joint_parameters(const Study& study, int level)
{
    const JointInput& joint = study.joint;
    const double kn = joint.wall_modulus.empty()
                          ? at_level(joint.normal_stiffness, level)
                          : dem::joint_stiffness(study.wall.course_height,
                                                 at_level(joint.wall_modulus, level),
                                                 study.stone.young_modulus);
    return {kn, at_level(joint.shear_stiffness, level), joint.stiffness_factor,
            joint.friction_angle};
}

} // namespace

Study read_study(const StudyFile& file)
{
    refuse_unknown(file);
    Study study;
    study.source = file;
    for (const Key& key : study_keys()) read_given(key, study);
    for (const Key& key : study_keys()) refuse_unused(key, study);
    check_stiffness(study);
    for (const auto& apply : derivations(study)) apply(study);
    check_relations(study);
    return study;
}

std::vector<void (*)(Study&)> derivations(const Study& study, std::string_view section)
{
    std::vector<void (*)(Study&)> all;
    for (const Key& key : study_keys())
        if (is_derived(key, study) && (section.empty() || section == section_of(key.name)))
            all.push_back(key.derived.apply);
    return all;
}

namespace {

/// How often a draw would lie outside the range of its key, where it is cut off.
std::string cut_text(const Key& key, const Study& study, bool first)
{
    for (const RandomInput& random : study.random)
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
        const std::string value = entry != nullptr ? entry->value : value_text(key, study);
        if (value.empty()) continue;
        if (section_of(key.name) != section) {
            section = section_of(key.name);
            text += (text.empty() ? "[" : "\n[") + std::string(section) + "]\n";
        }
        // Read as given, a value that follows from others would no longer follow their draws.
        const bool follows = !study.random.empty() && is_derived(key, study);
        // How results are read is no part of the walls: a later version reads them its own way.
        const bool reading =
            entry == nullptr && (section == "fragility" || section == "reliability");
        std::string line((follows || reading ? "# " : "") +
                         std::string(name_in_section(key.name)));
        line.resize(std::max<std::size_t>(line.size(), 24), ' ');
        line += "= " + value;
        std::string mark = follows            ? "default, follows the draws"
                           : entry == nullptr ? "default"
                           : entry->line == 0 ? "--set"
                                              : "";
        mark += cut_text(key, study, mark.empty());
        if (!mark.empty()) line.resize(std::max<std::size_t>(line.size() + 2, 56), ' ');
        text += line + (mark.empty() ? "" : "# ") + mark + "\n";
    }
    return text;
}

dem::Loads loads(const Study& study, int level)
{
    return {at_level(study.load.vertical_stress, level), study.load.height, study.load.gravity};
}

dem::JointMaterial joint_material(const Study& study, int level)
{
    return dem::joint_material(joint_parameters(study, level));
}

dem::CrackMaterial crack_material(const Study& study, int level)
{
    return dem::crack_material(study.unit, joint_parameters(study, level).kn,
                               study.stone.poisson_ratio);
}

dem::WallMaterials materials(const Study& study, int level, int n_joints, int n_cracks)
{
    dem::WallMaterials all =
        dem::wall_materials({study.stone, joint_parameters(study, level), study.unit,
                             study.base_friction_angle, study.beam_friction_angle},
                            n_joints, n_cracks);
    all.vertical_stress = at_level(study.load.vertical_stress, level);
    return all;
}

dem::Model model_of(const Study& study)
{
    return dem::discretise(study.wall, study.stone, study.beam, loads(study, 0),
                           {joint_material(study, 0), crack_material(study, 0)},
                           study.discretisation);
}

namespace {

/// True once the force is below a share of the largest so far. A push that turns back is not
/// judged on its way back: forces of both signs count by size.
std::function<bool(std::span<const dem::CurvePoint>)> stop_below(double share)
{
    return [share](std::span<const dem::CurvePoint> curve) {
        double peak = 0.0;
        for (const dem::CurvePoint& p : curve) peak = std::max(peak, std::abs(p.force));
        return curve.size() > 1 && std::abs(curve.back().force) < share * peak;
    };
}

} // namespace

dem::PushPlan push_plan(const Study& study)
{
    dem::PushPlan plan;
    plan.targets = study.load.targets;
    if (plan.targets.empty()) plan.targets = {study.load.max_displacement};
    plan.record_every = study.output.record_every;
    plan.snapshot_every = study.output.snapshot_every;
    if (study.load.stop_below > 0.0) plan.decided = stop_below(study.load.stop_below);
    return plan;
}

} // namespace app
