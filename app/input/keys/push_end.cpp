#include "app/input/keys/push_end.hpp"

#include "app/input/keys/limit_state_text.hpp"
#include "app/input/keys/study_keys.hpp"

#include <algorithm>
#include <cmath>

namespace app {
namespace {

constexpr double kFarthest = 0.2; // of the height [-]; choice: no limit is asked beyond
constexpr double kMostWay = 1.0;  // [m], the range of load.max_displacement
/// [-]; of 48 walls of configs/quick.ini none reached a higher peak after it; 0.1 would cost
/// 1.6 times the way.
constexpr double kBelowShare = 0.02;

/// Whether a push goes one way until its limits are decided, unless the study says otherwise;
/// of a protocol the push that finds its scale.
bool goes_to_its_limit(const LoadInput& load, const dem::SolverOptions& solver)
{
    const bool scaled = load.protocol != dem::Protocol::none && load.scale_one_way;
    return (push_way(load).direction != 0 || scaled) &&
           solver.kinematics == dem::Kinematics::finite;
}

bool is_drift_alone(const fragility::CodeState& s)
{
    return s.part == fragility::CodePart::none;
}

double largest_drift(const fragility::CodeState& s, double slenderness)
{
    double largest = 0.0;
    for (const auto& [mode, drift] : s.drifts)
        largest = std::max(largest, fragility::drift_limit(s, mode, slenderness));
    return largest;
}

/// Whether a code asks for the curve to its end.
bool reads_the_end(const fragility::Code& code)
{
    return std::ranges::any_of(code.states, [](const fragility::CodeState& s) {
        return s.part == fragility::CodePart::collapse || is_drift_alone(s);
    });
}

} // namespace

void derive_push_end(Study& study)
{
    if (!goes_to_its_limit(study.load, study.solver)) return;
    const double way = std::ceil(kFarthest * study.load.height * 1e3 - 1e-6) / 1e3;
    double asked = 0.0; // drifts that a limit state names [-]
    const ReadingRules rules = reading_rules(study);
    for (const UserState& user : rules.user) asked = std::max(asked, user.most_drift);
    for (const fragility::Code& code : rules.sets)
        for (const fragility::CodeState& s : code.states)
            if (is_drift_alone(s)) asked = std::max(asked, largest_drift(s, rules.slenderness));
    study.load.max_displacement = std::min(std::max(way, asked * study.load.height), kMostWay);
}

void derive_stop_below(Study& study)
{
    if (!goes_to_its_limit(study.load, study.solver) || push_way(study.load).direction == 0)
        return;
    const ReadingRules rules = reading_rules(study);
    double least = rules.options.ultimate_share;
    bool to_the_end = rules.options.crossing == fragility::Crossing::last ||
                      std::ranges::any_of(rules.sets, reads_the_end);
    for (const fragility::Code& code : rules.sets)
        for (const fragility::CodeState& s : code.states)
            if (s.part == fragility::CodePart::drop) least = std::min(least, s.factor);
    for (const UserState& user : rules.user) {
        const fragility::UserLimitState& s = user.state;
        least = std::min(least, s.drop.value_or(least));
        to_the_end |=
            s.yield + s.peak + s.ultimate == 0.0 && !s.rise && !s.drop; // a drift alone
    }
    const double below = std::round((least - kBelowShare) * 1e3) / 1e3; // 0.78, no digit more
    study.load.stop_below = to_the_end ? 0.0 : std::max(0.0, below);
}

void derive_snapshots(Study& study)
{
    if (!goes_to_its_limit(study.load, study.solver)) return;
    constexpr double kPictures = 100.0, kHalf = 0.5e-3; // choice; [m]
    const double apart = study.load.max_displacement / kPictures;
    study.output.snapshot_every = kHalf * std::max(1.0, std::ceil(apart / kHalf - 1e-6));
}

bool says_push_end(const Key& key)
{
    const auto apply = key.derived.apply;
    return apply == derive_push_end || apply == derive_stop_below || apply == derive_snapshots;
}

} // namespace app
