#include "app/sheet/sheet_words.hpp"

#include "app/fragility/numbers/tested_walls.hpp"
#include "app/input/keys/key_values.hpp"
#include "app/input/keys/limit_state_text.hpp"
#include "app/input/keys/study_keys.hpp"
#include "app/input/study/material_presets.hpp"
#include "app/input/wall/unit_cracks.hpp"
#include "app/input/wall/wall_geometry.hpp"
#include "app/push/hand_checks.hpp"
#include "app/reading/points_error.hpp"
#include "app/study/answers/fragility_text.hpp"
#include "app/study/answers/limit_choices.hpp"
#include "app/study/answers/pier_shares.hpp"
#include "app/study/pushed/both_ways.hpp"
#include "app/study/pushed/pier_remark.hpp"
#include "app/text/number_text.hpp"
#include "app/text/words.hpp"
#include "fragility/curve/drift.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <string_view>

namespace app {
namespace {

bool by_body_forces(const LoadInput& load) { return load.pattern == dem::LoadPattern::body; }

/// The height that drifts are shares of.
std::string_view height_words(const LoadInput& load)
{
    return by_body_forces(load) ? "the height of its centre of gravity"
                                : "the height of the load";
}

std::string kilonewtons(double force) { return never_rounded_away(force * 1e-3, 1) + " kN"; }

/// " and by 0.24 % by the number of contact points"; empty where that is not known.
std::string points_part(const PushedWall& wall)
{
    const double error = points_error(wall.result);
    if (!std::isfinite(error)) return {};
    return " and by " + never_rounded_away(100.0 * error, 2) +
           " % by the number of contact points";
}

std::string millimetres(double distance)
{
    return never_rounded_away(distance * 1e3, 1) + " mm";
}

std::string sentence(std::string text)
{
    if (text.empty()) return text;
    text.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(text.front())));
    return text + (text.ends_with('.') ? "" : ".");
}

std::string_view failure_words(dem::FailureMode mode)
{
    switch (mode) {
    case dem::FailureMode::rocking:
        return "It fails by rocking: parts of the wall tilt about their toes";
    case dem::FailureMode::sliding:
        return "It fails by sliding: courses move along their joints";
    default:
        return "It fails by cracking: stones split, and the wall then slides or gives way";
    }
}

/// The push to the right, or to the left.
std::string way_words(const LoadInput& load, bool other)
{
    const int direction = push_way(load).direction * (other ? -1 : 1);
    return direction == 0 ? "to and fro" : direction > 0 ? "to the right" : "to the left";
}

/// @param vertical load on its top [N]
std::string strength_sentence(const LoadInput& load, const PushedWall& w, double vertical)
{
    std::string text = "Pushed " + way_words(load, false) + ", the wall carries " +
                       kilonewtons(peak_force(w.reading));
    if (vertical > 0.0)
        text += ", " + fixed(peak_force(w.reading) / vertical, 2) +
                " of the vertical load on its top";
    if (const PushedWall* const other = other_way_of(w);
        other != nullptr && other->reading.peak)
        text += "; " + way_words(load, true) + " " + kilonewtons(peak_force(other->reading));
    return text + ".";
}

std::string limit_sentence(const LoadInput& load, const FragilityInput& fragility,
                           const PushedWall& w)
{
    const PushedWall* const other = other_way_of(w);
    const fragility::LimitDisplacement limit = worse_way(w).ultimate;
    const bool by_other =
        other != nullptr && limit.displacement != w.reading.ultimate.displacement;
    const std::string left = percent_text(fragility.ultimate_share);
    const std::string at =
        millimetres(limit.displacement) + ", " +
        never_rounded_away(fragility::percent_drift(limit.displacement, w.loads.height), 2) +
        " % of " + std::string(height_words(load));
    const std::string way = way_words(load, by_other) + " ";
    if (is_observed(limit))
        return sentence(way + "its force is down to " + left + " of the peak at " + at);
    if (is_censored(limit))
        return sentence(way + "its force had not come down to " + left + " of the peak at " +
                        at + ", where the push ended");
    return "No displacement can be named at which its force is down to " + left + ".";
}

/// How it fails, in both directions where they differ.
std::string failure_sentence(const LoadInput& load, const PushedWall& w)
{
    const std::string own(failure_words(w.reading.mode));
    const PushedWall* const other = other_way_of(w);
    if (other == nullptr || !other->reading.peak || other->reading.mode == w.reading.mode)
        return own + ".";
    return own + " (" + way_words(load, false) + "). " +
           std::string(failure_words(other->reading.mode)) + " (" + way_words(load, true) +
           ").";
}

/// How much a choice moved drift limits of the wall that was measured (docs/limits.md).
struct HowMuch {
    std::string_view key, words;
};
constexpr std::array kHowMuch = {
    HowMuch{"solver.kinematics",
            "With small ones 98 % of walls at 0.15 MPa have no limit, 48 % at 0.50 MPa; with "
            "finite ones half of them fall at 9 and 2.9 %"},
    HowMuch{
        "load.top",
        "Where walls rock (0.15 MPa) the median limit was 6.5 % (strut), 9 % (moves with the "
        "top), 35 % (in its line); from 0.75 MPa on the same"},
    HowMuch{"beam.rotation",
            "A level top gave 19 to 32 % more force; median limits of 13.9, not 9.1 % at 0.15 "
            "MPa, and 1.4, not 2.9 % at 0.50 MPa"},
    HowMuch{"unit.cracks",
            "Finer cracks left the median; 84 % of walls fell by 3.0, not 8.0 % (0.75 MPa); "
            "cracks at thirds gave four times the median"},
    HowMuch{"joint.compressive_strength", "From 20 to 92 MPa forces and medians were the same"},
};

/// Remark on joints weaker than those of the table: the house of docs/cookbook.md, 22, in
/// `choices`.
constexpr std::string_view kWeakJoints = "In a house of lime mortar (2 MPa) half the strength "
                                         "took 38 % off the force and 37 % off the "
                                         "limit; no crushing added 28 and more than 32 %";

std::string how_much(const JointInput& joint, std::string_view key)
{
    constexpr double kWeak = 20e6; // [Pa]
    const double strength = joint.crushing.strength;
    if (key == "joint.compressive_strength" && strength > 0.0 && strength < kWeak)
        return std::string(kWeakJoints);
    for (const HowMuch& h : kHowMuch)
        if (h.key == key) return std::string(h.words);
    return "";
}

/// Measured ones first, in the order of the table.
int rank(const Assumption& a)
{
    if (a.how_much == kWeakJoints) return 0;
    for (std::size_t i = 0; i < kHowMuch.size(); ++i)
        if (a.how_much == kHowMuch[i].words) return static_cast<int>(i);
    return static_cast<int>(kHowMuch.size());
}

std::string spread_sentence(const StudyWalls& stored, std::size_t level)
{
    const StudyLevel& all = stored.levels.at(level);
    const std::size_t n = all.walls.size();
    const std::string walls = counted(n, "random wall", "random walls");
    if (n < 3) return "Only " + walls + " of the study gave a result: no spread can be told.";
    std::vector<double> peaks;
    for (const StudyWall& w : all.walls)
        if (w.reading.peak) peaks.push_back(w.reading.peak->force);
    if (peaks.empty()) return "None of " + walls + " has a peak.";
    const auto [low, high] = std::ranges::minmax_element(peaks);
    std::string text = "Stones and mortar scatter: " + walls + " of this kind carry " +
                       kilonewtons(*low) + " to " + kilonewtons(*high) +
                       "; the table shows how far their limits spread.";
    if (!all.failed_walls.empty())
        text +=
            " " + counted(all.failed_walls.size(), "wall", "walls") + " could not be computed.";
    return text;
}

} // namespace

std::string moving_part(const LoadInput& load) { return by_body_forces(load) ? "wall" : "top"; }

std::string drift_words(const LoadInput& load)
{
    const std::string_view moves = by_body_forces(load)
                                       ? "the wall moves sideways, as a mean by weight"
                                       : "the top moves sideways";
    return "Drift: how far " + std::string(moves) + ", in percent of " +
           std::string(height_words(load)) + ".";
}

std::vector<std::string> answer_sentences(const LoadInput& load,
                                          const FragilityInput& fragility, double vertical_load,
                                          const PushedWall& wall)
{
    if (!wall.reading.no_reading.empty())
        return {sentence("No curve can be read: " + wall.reading.no_reading)};
    std::vector<std::string> all = {strength_sentence(load, wall, vertical_load),
                                    limit_sentence(load, fragility, wall)};
    if (!came_down_at_once(wall)) all.push_back(failure_sentence(load, wall));
    return all;
}

std::vector<Assumption> assumptions(const Study& study, std::size_t most)
{
    std::vector<Assumption> all;
    const auto add = [&](std::string_view key, std::string_view effect) {
        const Entry* const given = find_entry(study.source, key);
        all.push_back(
            {std::string(key) + " = " +
                 (given != nullptr ? given->value : value_text(*find_key(key), study)),
             std::string(effect), how_much(study.parameters.joint, key)});
    };
    for (const LimitChoice& choice : limit_choices(study)) add(choice.key, choice.effect);
    if (has_cracks(study, study.source))
        all.push_back({"unit.cracks = " + (study.cracks.pattern.empty() ? std::string("mid")
                                                                        : study.cracks.pattern),
                       "stones crack along lines that are given beforehand, and nowhere else",
                       how_much(study.parameters.joint, "unit.cracks")});
    std::ranges::stable_sort(all, {}, rank);
    if (all.size() > most) all.resize(most);
    return all;
}

std::vector<std::string> certainty_sentences(const Study& study, const PushedWall& wall,
                                             const StudyWalls* stored, std::size_t level)
{
    std::vector<std::string> all;
    const auto add = [&](const std::string& text) {
        if (!text.empty()) all.push_back(sentence(text));
    };
    add(no_limit_remark(study.load, study.solver, study.fragility, wall.reading));
    add(no_yield_remark(wall.reading));
    if (wall.piers.empty()) add(pier_remark(reading_rules(study), study));
    if (stored != nullptr) {
        add(spread_sentence(*stored, level));
        const std::string piers = pier_counts(*stored, stored->levels.at(level));
        if (!piers.empty()) add("Random walls by what governs: " + piers);
    } else
        add("One wall of mean values was pushed. Stones and mortar scatter: a study of random "
            "walls tells how far the answer spreads");
    if (const std::string material = material_text(study.source); !material.empty())
        add("Values of the material: " + material);
    add(tests_sentence(study.solver.damping) +
        (has_mortar(study.parameters.joint) ? ". No wall with mortar was compared" : ""));
    if (wall.result.curve.size() > 1)
        add("The calculation itself errs by about " +
            never_rounded_away(100.0 * solver_error(wall), 2) +
            " % in the force by the speed of the push" + points_part(wall));
    return all;
}

} // namespace app
