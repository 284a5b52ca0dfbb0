#include "app/choices/choice_list.hpp"

#include "app/input/keys/key_values.hpp"
#include "app/input/keys/study_keys.hpp"
#include "app/input/study/units.hpp"
#include "app/input/study_reading.hpp"
#include "app/input/wall/joint_laws.hpp"
#include "app/input/wall/unit_cracks.hpp"
#include "app/text/config_error.hpp"
#include "app/text/number_text.hpp"

#include <algorithm>
#include <string_view>
#include <utility>

namespace app {
namespace {

using Assignments = std::vector<std::string>;

/// An alternative that one choice of a study is changed to.
struct Alternative {
    std::string after;
    Assignments assignments;
};

struct Choice {
    std::string_view key;
    std::vector<Alternative> (*alternatives)(const Study&);
};

std::string assigned(std::string_view key, const std::string& value)
{
    return std::string(key) + "=" + value;
}

/// The words of a key that the study does not have.
std::vector<Alternative> other_words(const Study& study, std::string_view name,
                                     std::span<const std::string_view> words)
{
    const Key& key = *find_key(name);
    std::vector<Alternative> all;
    for (const std::string_view word : words)
        if (word != value_text(key, study))
            all.push_back({std::string(word), {assigned(name, std::string(word))}});
    return all;
}

std::vector<Alternative> kinematics(const Study& study)
{
    if (study.solver.kinematics == dem::Kinematics::small)
        return {{"finite", {"solver.kinematics=finite"}}};
    return {{"small", {"solver.kinematics=small", "load.top=dead", "load.link_length="}}};
}

std::vector<Alternative> top_load(const Study& study)
{
    constexpr std::string_view kWords[] = {"dead", "fixed_line", "follower"};
    std::vector<Alternative> all = other_words(study, "load.top", kWords);
    for (Alternative& a : all) a.assignments.emplace_back("load.link_length=");
    return all;
}

std::vector<Alternative> base(const Study& study)
{
    if (study.wall.base == dem::Base::fixed) return {{"joint", {"wall.base=joint"}}};
    return {{"fixed", {"wall.base=fixed", "base.friction_angle="}}};
}

std::vector<Alternative> toe(const Study& study)
{
    constexpr std::string_view kWords[] = {"free", "held"};
    return other_words(study, "wall.toe", kWords);
}

std::vector<Alternative> rotation(const Study& study)
{
    constexpr std::string_view kWords[] = {"free", "fixed"};
    return other_words(study, "beam.rotation", kWords);
}

std::vector<Alternative> interface(const Study& study)
{
    if (study.beam.interface == dem::BeamInterface::tied)
        return {{"joint", {"beam.interface=joint"}}};
    return {{"tied", {"beam.interface=tied", "beam.friction_angle="}}};
}

std::vector<Alternative> crushing(const Study& study)
{
    const double strength = study.parameters.joint.crushing.strength;
    if (!(strength > 0.0)) return {{"15 MPa", {"joint.compressive_strength=15 MPa"}}};
    const std::string half = number(0.5e-6 * strength, 4) + " MPa";
    return {{"none", {"joint.compressive_strength=none", "joint.crushing_energy="}},
            {half, {"joint.compressive_strength=" + half}}};
}

std::vector<Alternative> cracks(const Study& study)
{
    std::vector<Alternative> all;
    if (has_cracks(study))
        all.push_back(
            {"none", {"unit.cracks=none", "unit.cracks_where=", "unit.cracks_elsewhere="}});
    else
        all.push_back({"mid", {"unit.cracks=mid", "wall.unit_cracks=yes"}});
    all.push_back({"grid(2, 2)",
                   {"unit.cracks=grid(2, 2)", "unit.cracks_where=", "unit.cracks_elsewhere="}});
    return all;
}

/// Joints of the same stiffness under the vertical stress, which close further or do not.
std::vector<Alternative> closure(const Study& study)
{
    const JointInput& joint = study.parameters.joint;
    constexpr const char* kRest[] = {"joint.wall_modulus=", "joint.wall_modulus_stress="};
    const auto with = [&](std::string after, Assignments more) {
        for (const char* const key : kRest) more.emplace_back(key);
        return std::vector<Alternative>{{std::move(after), std::move(more)}};
    };
    if (closes(joint)) {
        std::string kn;
        for (const double s : study.load.vertical_stress)
            kn +=
                (kn.empty() ? "" : ", ") +
                number((joint.closing.initial_stiffness + s / joint.closing.maximum) * 1e-9, 6);
        return with("linear",
                    {"joint.closure=linear", "joint.normal_stiffness=" + kn + " GPa/m",
                     "joint.initial_stiffness=", "joint.maximum_closure=",
                     "joint.closure_loss=", "joint.largest_stiffness="});
    }
    return with("exponential",
                {"joint.closure=exponential", "joint.normal_stiffness=",
                 "joint.shear_stiffness=", "joint.initial_stiffness=4.8665 GPa/m",
                 "joint.maximum_closure=0.15374 mm"});
}

std::vector<Alternative> damping(const Study& study)
{
    constexpr std::string_view kWords[] = {"local", "combined"};
    return other_words(study, "solver.damping", kWords);
}

std::vector<Alternative> direction(const Study& study)
{
    const int way = push_way(study).direction;
    if (way == 0) return {};
    const bool left = study.load.direction == Direction::left;
    return {{way > 0 ? "to the left" : "to the right",
             {std::string("load.direction=") + (left ? "right" : "left")}}};
}

std::vector<Alternative> layout(const Study& study)
{
    if (study.geometry.rubble || study.wall.length_cov > 0.0)
        return {{"seed " + std::to_string(study.wall.seed + 1),
                 {"wall.seed=" + std::to_string(study.wall.seed + 1)}}};
    return {{"0.15", {"wall.unit_length_cov=0.15"}}};
}

std::vector<Alternative> fidelity(const Study& study)
{
    constexpr std::string_view kWords[] = {"simple", "standard"};
    return other_words(study, "solver.fidelity", kWords);
}

constexpr Choice kChoices[] = {{"solver.kinematics", kinematics},
                               {"load.top", top_load},
                               {"wall.base", base},
                               {"wall.toe", toe},
                               {"beam.rotation", rotation},
                               {"beam.interface", interface},
                               {"joint.compressive_strength", crushing},
                               {"unit.cracks", cracks},
                               {"joint.closure", closure},
                               {"solver.damping", damping},
                               {"solver.fidelity", fidelity},
                               {"load.direction", direction},
                               {"wall.unit_length_cov", layout}};

std::string key_of(const std::string& assignment)
{
    return assignment.substr(0, assignment.find('='));
}

/// The file with these values; one that is taken out may be missing, and one of the command
/// line gives way.
StudyFile changed_file(const StudyFile& file, const Assignments& assignments)
{
    StudyFile changed = file;
    for (const std::string& a : assignments) {
        const std::string key = key_of(a);
        std::erase_if(changed.entries, [&](const Entry& e) { return e.key == key; });
        if (a.size() > key.size() + 1) changed = with_overrides(std::move(changed), {&a, 1});
    }
    return changed;
}

/// The value that the study has now, in words.
std::string before_text(const Study& study, std::string_view key)
{
    if (key == "load.direction")
        return push_way(study).direction > 0 ? "to the right" : "to the left";
    if (key == "unit.cracks")
        return !has_cracks(study)             ? "none"
               : study.cracks.pattern.empty() ? "mid"
                                              : study.cracks.pattern;
    const Entry* const entry = find_entry(study.source, key);
    return entry != nullptr ? entry->value : value_text(*find_key(key), study);
}

void read_change(ChoiceChange& change, const StudyFile& file)
{
    try {
        change.ready = prepare(read_study(changed_file(file, change.assignments)));
    } catch (const ConfigError& error) {
        const std::string text = error.what();
        const std::size_t at = text.find(change.key + ": ");
        change.not_applied =
            at == std::string::npos ? text : text.substr(at + change.key.size() + 2);
        // The part about what to write instead is no answer here.
        change.not_applied.resize(
            std::min(change.not_applied.find("; "), change.not_applied.size()));
        return;
    }
    change.not_applied = std::string(why_no_effect(*find_key(change.key), change.ready.study));
}

} // namespace

std::vector<ChoiceChange> choice_changes(const std::string& path,
                                         std::span<const std::string> overrides)
{
    const StudyFile file = with_overrides(read_study_file(path), overrides);
    const Study study = read_study(file);
    std::vector<ChoiceChange> all;
    for (const Choice& choice : kChoices) {
        const std::string before = before_text(study, choice.key);
        const std::vector<Alternative> others = choice.alternatives(study);
        if (others.empty())
            all.push_back(
                {std::string(choice.key), before, "", {}, "the push goes to and fro", {}});
        for (const Alternative& a : others) {
            ChoiceChange change{std::string(choice.key), before, a.after,
                                a.assignments,           "",     {}};
            read_change(change, file);
            all.push_back(std::move(change));
        }
    }
    return all;
}

} // namespace app
