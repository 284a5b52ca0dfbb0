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
#include <array>
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
    std::vector<Alternative> (*alternatives)(const Study&) = nullptr; ///< nullptr: other words
    std::array<std::string_view, 3> words = {};                       ///< of the key
    std::string_view without = ""; ///< a key that no other word goes with
};

std::string assigned(std::string_view key, const std::string& value)
{
    return std::string(key) + "=" + value;
}

std::vector<Alternative> kinematics(const dem::SolverOptions& solver)
{
    if (solver.kinematics == dem::Kinematics::small)
        return {{"finite", {"solver.kinematics=finite"}}};
    return {{"small", {"solver.kinematics=small", "load.top=dead", "load.link_length="}}};
}

std::vector<Alternative> base(const dem::WallGeometry& wall)
{
    if (wall.base == dem::Base::fixed) return {{"joint", {"wall.base=joint"}}};
    return {{"fixed", {"wall.base=fixed", "base.friction_angle="}}};
}

std::vector<Alternative> interface(const dem::Beam& beam)
{
    if (beam.interface == dem::BeamInterface::tied)
        return {{"joint", {"beam.interface=joint"}}};
    return {{"tied", {"beam.interface=tied", "beam.friction_angle="}}};
}

std::vector<Alternative> crushing(const JointInput& joint)
{
    const double strength = joint.crushing.strength;
    if (!(strength > 0.0)) return {{"15 MPa", {"joint.compressive_strength=15 MPa"}}};
    const std::string half = number(0.5e-6 * strength, 4) + " MPa";
    return {{"none", {"joint.compressive_strength=none", "joint.crushing_energy="}},
            {half, {"joint.compressive_strength=" + half}}};
}

std::vector<Alternative> cracks(const Masonry& masonry, const StudyFile& source)
{
    std::vector<Alternative> all;
    if (has_cracks(masonry, source))
        all.push_back(
            {"none", {"unit.cracks=none", "unit.cracks_where=", "unit.cracks_elsewhere="}});
    else
        all.push_back({"mid", {"unit.cracks=mid", "wall.unit_cracks=yes"}});
    all.push_back({"grid(2, 2)",
                   {"unit.cracks=grid(2, 2)", "unit.cracks_where=", "unit.cracks_elsewhere="}});
    return all;
}

/// Joints of the same stiffness under the vertical stress, which close further or do not.
std::vector<Alternative> closure(const JointInput& joint, const LoadInput& load)
{
    constexpr const char* kRest[] = {"joint.wall_modulus=", "joint.wall_modulus_stress="};
    const auto with = [&](std::string after, Assignments more) {
        for (const char* const key : kRest) more.emplace_back(key);
        return std::vector<Alternative>{{std::move(after), std::move(more)}};
    };
    if (closes(joint)) {
        std::string kn;
        for (const double s : load.vertical_stress)
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

std::vector<Alternative> direction(const LoadInput& load)
{
    const int way = push_way(load).direction;
    if (way == 0) return {};
    const bool left = load.direction == Direction::left;
    return {{way > 0 ? "to the left" : "to the right",
             {std::string("load.direction=") + (left ? "right" : "left")}}};
}

std::vector<Alternative> layout(const Masonry& masonry)
{
    if (masonry.geometry.rubble || masonry.wall.length_cov > 0.0)
        return {{"seed " + std::to_string(masonry.wall.seed + 1),
                 {"wall.seed=" + std::to_string(masonry.wall.seed + 1)}}};
    return {{"0.15", {"wall.unit_length_cov=0.15"}}};
}

constexpr Choice kChoices[] = {
    {"solver.kinematics", asks<&Study::solver>([](auto& s) { return kinematics(s); })},
    {"load.top", nullptr, {"dead", "fixed_line", "follower"}, "load.link_length"},
    {"wall.base", asks<&Study::wall>([](auto& w) { return base(w); })},
    {"wall.toe", nullptr, {"free", "held"}},
    {"beam.rotation", nullptr, {"free", "fixed"}},
    {"beam.interface", asks<&Study::beam>([](auto& b) { return interface(b); })},
    {"joint.compressive_strength",
     asks<&Study::parameters>([](auto& p) { return crushing(p.joint); })},
    {"unit.cracks", [](const Study& s) { return cracks(s, s.source); }},
    {"joint.closure", asks<&Study::parameters, &Study::load>(
                          [](auto& p, auto& l) { return closure(p.joint, l); })},
    {"solver.damping", nullptr, {"local", "combined"}},
    {"solver.fidelity", nullptr, {"simple", "standard"}},
    {"load.direction", asks<&Study::load>([](auto& l) { return direction(l); })},
    {"wall.unit_length_cov", [](const Study& s) { return layout(s); }}};

std::vector<Alternative> alternatives_of(const Choice& choice, const Study& study)
{
    if (choice.alternatives != nullptr) return choice.alternatives(study);
    const std::string own = value_text(*find_key(choice.key), study);
    std::vector<Alternative> all;
    for (const std::string_view word : choice.words) {
        if (word.empty() || word == own) continue;
        all.push_back({std::string(word), {assigned(choice.key, std::string(word))}});
        if (!choice.without.empty())
            all.back().assignments.push_back(assigned(choice.without, ""));
    }
    return all;
}

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
        return push_way(study.load).direction > 0 ? "to the right" : "to the left";
    if (key == "unit.cracks")
        return !has_cracks(study, study.source) ? "none"
               : study.cracks.pattern.empty()   ? "mid"
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
        const std::vector<Alternative> others = alternatives_of(choice, study);
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
