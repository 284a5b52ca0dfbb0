#include "app/study/answers/limit_choices.hpp"

#include "app/input/keys/key_values.hpp"
#include "app/input/keys/study_keys.hpp"
#include "app/input/study/study.hpp"
#include "app/study/answers/fragility_text.hpp"
#include "app/text/number_text.hpp"
#include "app/text/words.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace app {
namespace {

/// The sentence on a wall that keeps its load with small displacements, and its remedy.
std::string keeps_its_load_text(const LoadInput& load)
{
    return std::string(
               "with small displacements a wall that rocks or slides keeps its load; for "
               "its own limit write solver.kinematics = finite and ") +
           (!load.amplitudes.empty() ? "larger load.amplitudes"
            : !load.targets.empty()  ? "load.targets that go further"
                                     : "a larger load.max_displacement");
}

/// The sentence on cycles whose first amplitude lies beyond yield, and its remedy.
/// @param begin_with [m]
std::string beyond_yield_text(double begin_with)
{
    const double mm = 1e3 * begin_with, digit = mm < 0.1 ? 0.01 : 0.1;
    return "neither stiffness nor the limit states that follow from yield are read, as the "
           "way to the other side begins with a force that the first amplitude has left; begin "
           "the cycles with " +
           number(std::max(0.01, digit * std::floor(mm / digit)), 3) + " mm or less";
}

/// The force of the wall had not come down when its push ended, and never would.
bool keeps_its_load(const dem::SolverOptions& solver, const WallReading& wall)
{
    return solver.kinematics == dem::Kinematics::small && is_censored(wall.ultimate);
}

std::string_view kinematics_effect(const dem::SolverOptions& solver)
{
    return solver.kinematics == dem::Kinematics::small
               ? "small displacements: a wall that rocks or slides keeps its load and has no "
                 "limit"
               : "finite displacements: a wall loses its load as it leans and slides";
}

std::string_view base_effect(const dem::WallGeometry& wall)
{
    return wall.base == dem::Base::fixed
               ? "the lowest stones are clamped to the floor: they neither lift nor slide"
               : "the wall stands on a joint: it may lift off the floor and slide on it";
}

std::string_view toe_effect(const dem::WallGeometry& wall)
{
    return wall.toe == dem::Toe::held ? "the toe is held: the first course cannot slide away"
                                      : "the toe is free: only friction holds the first course";
}

std::string_view rotation_effect(const dem::Beam& beam)
{
    return beam.rotation == dem::BeamRotation::free
               ? "the top may turn: the wall rocks as a cantilever"
               : "the top stays level: the wall bends twice and carries more";
}

std::string_view top_effect(const LoadInput& load)
{
    switch (load.top) {
    case dem::TopLoad::dead:
        return "the load moves with the top: its lever arm shrinks as the wall leans";
    case dem::TopLoad::fixed_line:
        return "the load stays in its line: it keeps its lever arm while the wall leans";
    case dem::TopLoad::follower:
        return "the load turns with the top: it keeps its lever arm while the wall leans";
    default:
        return "the load acts along a link, which turns as the top moves";
    }
}

std::string_view interface_effect(const dem::Beam& beam)
{
    return beam.interface == dem::BeamInterface::tied
               ? "the beam is tied to the wall: the load cannot slide on it"
               : "the beam lies on a joint: the load may slide on the wall";
}

std::string_view crushing_effect(const Parameters& p)
{
    return p.joint.crushing.strength > 0.0
               ? "joints crush: the wall turns about a point inside its toe"
               : "joints do not crush: the toe carries any stress";
}

struct Rule {
    std::string_view key;
    std::string_view (*effect)(const Study&);
};
constexpr Rule kRules[] = {
    {"solver.kinematics", asks<&Study::solver>([](auto& x) { return kinematics_effect(x); })},
    {"wall.base", asks<&Study::wall>([](auto& x) { return base_effect(x); })},
    {"wall.toe", asks<&Study::wall>([](auto& x) { return toe_effect(x); })},
    {"beam.rotation", asks<&Study::beam>([](auto& x) { return rotation_effect(x); })},
    {"load.top", asks<&Study::load>([](auto& x) { return top_effect(x); })},
    {"beam.interface", asks<&Study::beam>([](auto& x) { return interface_effect(x); })},
    {"joint.compressive_strength",
     asks<&Study::parameters>([](auto& x) { return crushing_effect(x); })}};

/// With small displacements the vertical load keeps its lever arm, however it follows the beam.
bool plays_a_part(const Key& key, const Study& study)
{
    const bool small = study.solver.kinematics == dem::Kinematics::small;
    if (key.name == "load.top" && (small || !study.beam.present)) return false;
    return is_used(key, study) && why_no_effect(key, study).empty();
}

} // namespace

std::string no_limit_remark(const LoadInput& load, const dem::SolverOptions& solver,
                            const FragilityInput& fragility, const WallReading& wall)
{
    if (!keeps_its_load(solver, wall)) return "";
    return "the force did not come down to " + percent_text(fragility.ultimate_share) +
           " of the peak: " + keeps_its_load_text(load);
}

std::string no_limit_remark(const StudyWalls& walls)
{
    std::size_t without = 0, all = 0;
    for (const StudyLevel& level : walls.levels) {
        all += level.walls.size();
        for (const StudyWall& w : level.walls)
            without += keeps_its_load(walls.study.solver, w.reading) ? 1 : 0;
    }
    if (without == 0) return "";
    return std::to_string(without) + " of " + counted(all, "wall", "walls") +
           " still carried more than " + percent_text(walls.study.fragility.ultimate_share) +
           " of the peak at the end: " + keeps_its_load_text(walls.study.load) + ".";
}

std::string no_yield_remark(const WallReading& wall)
{
    if (wall.begin_with <= 0.0) return "";
    return "the first amplitude lies beyond yield: " + beyond_yield_text(wall.begin_with);
}

std::string no_yield_remark(const StudyWalls& walls)
{
    std::size_t beyond = 0, all = 0;
    double begin_with = std::numeric_limits<double>::infinity();
    for (const StudyLevel& level : walls.levels) {
        all += level.walls.size();
        for (const StudyWall& w : level.walls) {
            if (w.reading.begin_with <= 0.0) continue;
            ++beyond;
            begin_with = std::min(begin_with, w.reading.begin_with);
        }
    }
    if (beyond == 0) return "";
    return "The first amplitude lies beyond the yield of " + std::to_string(beyond) + " of " +
           counted(all, "wall", "walls") + ": of these " + beyond_yield_text(begin_with) + ".";
}

std::vector<LimitChoice> limit_choices(const Study& study)
{
    std::vector<LimitChoice> choices;
    for (const Rule& rule : kRules)
        if (plays_a_part(*find_key(rule.key), study))
            choices.push_back(
                {rule.key, value_text(*find_key(rule.key), study), rule.effect(study)});
    return choices;
}

std::string limit_choices_text(std::span<const LimitChoice> choices)
{
    std::string text;
    for (const LimitChoice& choice : choices)
        text += (text.empty() ? "Choices that move a drift limit: " : ", ") +
                std::string(choice.key) + " = " + choice.value;
    return text + ".";
}

} // namespace app
