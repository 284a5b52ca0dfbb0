#include "app/reading/wall_reading.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <span>

namespace app {
namespace {

using fragility::Reading;

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// The curve rises to 1 at 1 and falls to 0 at 2: any rule can be read off it.
constexpr std::array<double, 3> kTrialX{0.0, 1.0, 2.0}, kTrialY{0.0, 1.0, 0.0};
const fragility::Curve kTrial{kTrialX, kTrialY};

std::vector<fragility::UserLimitState> user_states(const ReadingRules& rules)
{
    std::vector<fragility::UserLimitState> states;
    for (const UserState& user : rules.user) {
        states.push_back(user.state);
        if (user.most_drift > 0.0) states.back().at_most = user.most_drift * rules.height;
    }
    return states;
}

std::vector<double> turned_round(std::span<const double> values)
{
    std::vector<double> turned(values.size());
    std::transform(values.begin(), values.end(), turned.begin(), std::negate{});
    return turned;
}

/// @param curve in the direction of the push
void read_curve(const fragility::Curve& curve, const ReadingRules& rules, WallReading& w)
{
    w.peak = fragility::peak(curve);
    w.stiffness = fragility::secant_stiffness(curve);
    w.ultimate =
        fragility::drop_after_peak(curve, rules.options.ultimate_share, rules.options.crossing);
    w.dropped = is_observed(w.ultimate);
    w.collapse = fragility::drop_after_peak(curve, 0.0);
    w.limits.clear();
    for (const std::string_view set : rules.sets)
        for (const auto& s : fragility::read_limit_states(curve, set, rules.options))
            w.limits.push_back(s.limit);
    for (const auto& s : fragility::read_limit_states(curve, user_states(rules), rules.options))
        w.limits.push_back(s.limit);
}

/// A push to the left, in its own direction.
void read_mirrored(const fragility::Curve& curve, const ReadingRules& rules, WallReading& w)
{
    const auto displacement = turned_round(curve.displacement),
               force = turned_round(curve.force);
    read_curve({displacement, force, curve.came_down}, rules, w);
}

} // namespace

std::vector<StateName> state_names(const ReadingRules& rules)
{
    std::vector<StateName> names;
    for (const std::string_view set : rules.sets)
        for (const auto& s : fragility::read_limit_states(kTrial, set, rules.options))
            names.push_back({std::string(set), std::string(s.name), s.rule});
    const auto states = user_states(rules);
    const auto read = fragility::read_limit_states(kTrial, states, rules.options);
    for (std::size_t i = 0; i < states.size(); ++i) {
        std::string rule = read[i].rule;
        if (const auto at = rule.find("the displacement given"); at != std::string::npos)
            rule = rule.substr(0, at) + rules.user[i].cap + " drift";
        names.push_back({"user", states[i].name, rule});
    }
    return names;
}

WallReading not_read(const ReadingRules& rules, std::string why)
{
    WallReading w;
    w.no_reading = std::move(why);
    w.limits.assign(state_names(rules).size(),
                    {0.0, Reading::not_defined, "nothing is read off this wall"});
    return w;
}

WallReading read(const fragility::Curve& curve, const dem::Mechanism& mechanism,
                 const ReadingRules& rules)
{
    WallReading w;
    if (curve.displacement.size() < 2)
        w = not_read(rules, "the wall came down under vertical load");
    else if (rules.direction == 0)
        w = not_read(rules, "the push turns back: limit states are read off a push that goes "
                            "one way");
    else if (rules.direction > 0)
        read_curve(curve, rules, w);
    else
        read_mirrored(curve, rules, w);
    w.mode = dem::failure_mode(mechanism, w.dropped, rules.mode);
    w.slid = slid_whole(mechanism, w.dropped, rules.mode);
    return w;
}

bool slid_whole(const dem::Mechanism& m, bool dropped, const dem::ModeThresholds& t)
{
    return dem::failure_mode(m, dropped, t) == dem::FailureMode::rocking &&
           m.rotation_share < t.rotation_share;
}

double peak_force(const WallReading& w) { return w.peak ? w.peak->force : kNone; }
double peak_displacement(const WallReading& w) { return w.peak ? w.peak->displacement : kNone; }

bool is_observed(const fragility::LimitDisplacement& d)
{
    return d.reading == Reading::observed;
}
bool is_censored(const fragility::LimitDisplacement& d)
{
    return d.reading == Reading::censored;
}
bool is_defined(const fragility::LimitDisplacement& d)
{
    return d.reading != Reading::not_defined;
}

} // namespace app
