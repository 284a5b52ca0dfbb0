#include "app/reading/wall_reading.hpp"

#include "fragility/curve/bilinear.hpp"
#include "fragility/curve/first_loading.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <span>

namespace app {
namespace {

using fragility::Reading;

constexpr double kNoPeak = std::numeric_limits<double>::quiet_NaN();

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

/// Drift limits of a set for one wall, by limit state [m]: they depend on what moves.
std::vector<double> caps_of(std::size_t set, dem::FailureMode mode, const ReadingRules& rules)
{
    std::vector<double> caps;
    if (rules.by_piers) {
        if (set >= rules.pier_caps.size()) return caps;
        for (const PierLimit& limit : rules.pier_caps[set]) caps.push_back(limit.displacement);
        return caps;
    }
    for (const fragility::CodeState& s : rules.sets[set].states)
        caps.push_back(rules.height * fragility::drift_limit(s, name(mode), rules.slenderness));
    return caps;
}

/// The pier whose drift limit a limit state of a set is, or whose it is a share of.
int governing_pier(std::size_t set, std::size_t state, const fragility::LimitDisplacement& d,
                   const ReadingRules& rules)
{
    if (!fragility::is_capped(d) || set >= rules.pier_caps.size()) return 0;
    const fragility::CodeState& s = rules.sets[set].states[state];
    const bool share = s.drifts.empty() && s.of >= 0;
    return rules.pier_caps[set][share ? static_cast<std::size_t>(s.of) : state].pier;
}

/// A curve to read, in its own direction.
struct ToRead {
    fragility::Backbone backbone;
    fragility::FirstLoading first = {};
    bool turns = false; ///< the backbone of a push that turns back
};

/// A force of this share of the peak at zero displacement comes from the way to the other side:
/// the curve has no elastic branch of its own then.
constexpr double kLoadedAtZero = 0.1; // choice
constexpr std::string_view kBeyondYield = "the first amplitude lies beyond yield";

/// Beyond the first turn, another cycle has left a step.
std::optional<double> stiffness_of(const fragility::Curve& curve,
                                   const fragility::FirstLoading& first)
{
    const double share = fragility::share_within(curve, first.turn, fragility::kSecantShare);
    const fragility::Backbone own = fragility::from_own_zero(curve, first.residual);
    return fragility::secant_stiffness({own.displacement, own.force}, share);
}

/// Least error of a fall over the accuracy asked. A free choice: the page
/// docs/bench/accuracy/accuracy.md has the share of falls that such ranges hold.
constexpr double kFallError = 2.0;

/// A fall that is sudden comes earlier or later by what its cause is wrong.
fragility::DropRange ultimate_range(const fragility::Curve& curve,
                                    const fragility::LimitDisplacement& ultimate,
                                    const ReadingRules& rules, double solver_error)
{
    if (!(solver_error >= 0.0)) return {};
    fragility::DropRange range = fragility::drop_range(curve, rules.options.ultimate_share,
                                                       rules.options.crossing, solver_error);
    if (!is_observed(ultimate)) return range;
    const double at = ultimate.displacement, least = kFallError * rules.accuracy;
    double &earliest = range.earliest.displacement, &latest = range.latest.displacement;
    earliest = std::min(earliest, at * std::max(0.0, 1.0 - least));
    if (is_observed(range.latest)) latest = std::max(latest, at * (1.0 + least));
    return range;
}

WallReading read_curve(const ToRead& side, bool came_down, const dem::Mechanism& mechanism,
                       const ReadingRules& rules, double solver_error)
{
    const fragility::Curve curve{side.backbone.displacement, side.backbone.force, came_down};
    WallReading w;
    w.peak = fragility::peak(curve);
    const bool loaded = side.turns && side.first.reach == 0.0;
    if (!loaded) w.stiffness = stiffness_of(curve, side.first);
    w.ultimate =
        fragility::drop_after_peak(curve, rules.options.ultimate_share, rules.options.crossing);
    w.ultimate_range = ultimate_range(curve, w.ultimate, rules, solver_error);
    w.dropped = is_observed(w.ultimate);
    w.collapse = fragility::drop_after_peak(curve, 0.0);
    const dem::FailureMode mode = code_mode(mechanism, w.dropped, rules.mode);
    auto options = rules.options;
    options.residual = side.first.residual;
    options.reach = side.first.reach;
    if (loaded) options.no_yield = kBeyondYield;
    for (std::size_t set = 0; set < rules.sets.size(); ++set) {
        const std::vector<double> caps = caps_of(set, mode, rules);
        const auto found = fragility::read_limit_states(curve, rules.sets[set], caps, options);
        for (std::size_t s = 0; s < found.size(); ++s) {
            w.limits.push_back(found[s].limit);
            if (rules.by_piers)
                w.governing.push_back(governing_pier(set, s, found[s].limit, rules));
        }
    }
    for (const auto& s : fragility::read_limit_states(curve, user_states(rules), options))
        w.limits.push_back(s.limit);
    if (rules.by_piers) w.governing.resize(w.limits.size(), 0);
    return w;
}

/// Backbones of a push that turns back.
struct Backbones {
    ToRead right, left;
};

ToRead side_of(const fragility::Path& path, int direction)
{
    ToRead side{fragility::backbone(path, direction), {}, true};
    const double top = *std::ranges::max_element(side.backbone.force);
    side.first = fragility::first_loading(path, direction, kLoadedAtZero * top);
    return side;
}

Backbones backbones_of(const fragility::Curve& curve)
{
    const fragility::Path path{curve.displacement, curve.force};
    return {side_of(path, 1), side_of(path, -1)};
}

bool was_visited(const ToRead& side) { return side.backbone.displacement.size() > 1; }

/// As far as both reach; of a push that never leaves one side that side. Only one of both is
/// loaded after the other.
ToRead mean_of(const Backbones& b)
{
    if (!was_visited(b.left)) return b.right;
    if (!was_visited(b.right)) return b.left;
    return {fragility::mean(b.right.backbone, b.left.backbone),
            {0.5 * (b.right.first.residual + b.left.first.residual),
             b.right.first.force + b.left.first.force,
             std::min(b.right.first.reach, b.left.first.reach),
             std::min(b.right.first.turn, b.left.first.turn)},
            true};
}

/// Half of the yield of the side that was loaded first [m], to begin cycles with.
double half_of_yield(const ToRead& side, const ReadingRules& rules)
{
    const fragility::Curve curve{side.backbone.displacement, side.backbone.force};
    const auto ultimate =
        fragility::drop_after_peak(curve, rules.options.ultimate_share, rules.options.crossing);
    const auto b = fragility::equal_energy_bilinear(curve, ultimate.displacement,
                                                    rules.options.bilinear_share);
    return 0.5 * b.yield_displacement;
}

WallReading read_to_and_fro(const fragility::Curve& curve, const dem::Mechanism& mechanism,
                            const ReadingRules& rules, double solver_error)
{
    const Backbones b = backbones_of(curve);
    const auto read_side = [&](const ToRead& side) {
        return was_visited(side)
                   ? read_curve(side, curve.came_down, mechanism, rules, solver_error)
                   : not_read(rules, "the push never goes to this side");
    };
    const WallReading right = read_side(b.right), left = read_side(b.left);
    const bool both = was_visited(b.right) && was_visited(b.left);
    const WallReading mean = read_side(mean_of(b));
    const std::vector<WallReading> all = {mean, both ? worse_of(right, left) : mean, right,
                                          left};
    WallReading w = all[static_cast<int>(rules.backbone)];
    w.backbones = all;
    if (!w.stiffness && b.right.first.force + b.left.first.force > 0.0)
        w.begin_with = half_of_yield(b.left.first.force > 0.0 ? b.right : b.left, rules);
    return w;
}

} // namespace

std::vector<StateName> state_names(const ReadingRules& rules)
{
    std::vector<StateName> names;
    fragility::LimitStateOptions options = rules.options;
    options.slenderness = rules.by_piers ? 0.0 : rules.slenderness;
    for (const fragility::Code& set : rules.sets)
        for (const auto& s : fragility::read_limit_states(kTrial, set, {}, options))
            names.push_back({set.name, s.name, s.rule});
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

std::string state_name(const StateName& state)
{
    const bool alone = state.set.empty() || state.set == state.name;
    return alone ? state.name : state.set + " " + state.name;
}

WallReading not_read(const ReadingRules& rules, std::string why)
{
    WallReading w;
    w.no_reading = std::move(why);
    w.limits.assign(state_names(rules).size(),
                    {0.0, Reading::not_defined, "nothing is read off this wall"});
    return w;
}

namespace {

/// A wall that has settled stands; it was lost while it was pushed, which may be the solver's
/// fault.
WallReading lost_at_once(const ReadingRules& rules, bool settled)
{
    constexpr std::string_view kFell = "the wall came down under vertical load";
    constexpr std::string_view kLost =
        "the wall stood under its vertical load and was lost as soon as it was pushed";
    const std::string_view why = settled ? kLost : kFell;
    WallReading w = not_read(rules, std::string(why));
    for (fragility::LimitDisplacement& limit : w.limits) limit.reason = why;
    return w;
}

ToRead pushed_one_way(const fragility::Curve& curve, const ReadingRules& rules)
{
    ToRead side{capacity_curve(curve, rules)};
    side.first.residual =
        fragility::residual_at_rest({side.backbone.displacement, side.backbone.force});
    return side;
}

} // namespace

WallReading read(const fragility::Curve& curve, const dem::Mechanism& mechanism,
                 const ReadingRules& rules, bool settled, double solver_error)
{
    WallReading w;
    if (curve.displacement.size() < 2)
        w = lost_at_once(rules, settled);
    else if (rules.direction == 0)
        w = read_to_and_fro(curve, mechanism, rules, solver_error);
    else
        w = read_curve(pushed_one_way(curve, rules), curve.came_down, mechanism, rules,
                       solver_error);
    w.mode = dem::failure_mode(mechanism, w.dropped, rules.mode);
    w.mode_so_far = !w.dropped && dem::standing_is_undecided(rules.mode);
    w.slid = slid_whole(mechanism, w.dropped, rules.mode);
    return w;
}

fragility::Backbone capacity_curve(const fragility::Curve& curve, const ReadingRules& rules)
{
    using fragility::Side;
    const auto copied = [](std::span<const double> v) {
        return std::vector(v.begin(), v.end());
    };
    if (rules.direction > 0) return {copied(curve.displacement), copied(curve.force)};
    if (rules.direction < 0)
        return {turned_round(curve.displacement), turned_round(curve.force)};
    const Backbones b = backbones_of(curve);
    if (rules.backbone == Side::right) return b.right.backbone;
    return (rules.backbone == Side::left ? b.left : mean_of(b)).backbone;
}

bool slid_whole(const dem::Mechanism& m, bool dropped, const dem::ModeThresholds& t)
{
    return dem::failure_mode(m, dropped, t) == dem::FailureMode::rocking && !dem::rocks(m, t);
}

dem::FailureMode code_mode(const dem::Mechanism& mechanism, bool dropped,
                           const dem::ModeThresholds& thresholds)
{
    dem::ModeThresholds three = thresholds;
    three.modes = dem::ModeRule::mechanism;
    return dem::failure_mode(mechanism, dropped, three);
}

bool same_limit(const fragility::LimitDisplacement& a, const fragility::LimitDisplacement& b)
{
    return a.displacement == b.displacement && a.reading == b.reading;
}

WallReading worse_of(const WallReading& a, const WallReading& b)
{
    WallReading w;
    w.peak = b.peak->force < a.peak->force ? b.peak : a.peak;
    if (a.stiffness && b.stiffness) w.stiffness = std::min(*a.stiffness, *b.stiffness);
    w.ultimate = fragility::worse(a.ultimate, b.ultimate);
    w.ultimate_range = {fragility::worse(a.ultimate_range.earliest, b.ultimate_range.earliest),
                        fragility::worse(a.ultimate_range.latest, b.ultimate_range.latest)};
    w.dropped = is_observed(w.ultimate);
    w.collapse = fragility::worse(a.collapse, b.collapse);
    for (std::size_t i = 0; i < a.limits.size(); ++i) {
        w.limits.push_back(fragility::worse(a.limits[i], b.limits[i]));
        if (a.governing.empty() || b.governing.empty()) continue;
        const bool by_a = same_limit(w.limits[i], a.limits[i]);
        w.governing.push_back(by_a ? a.governing[i] : b.governing[i]);
    }
    return w;
}

double peak_force(const WallReading& w) { return w.peak ? w.peak->force : kNoPeak; }
double peak_displacement(const WallReading& w)
{
    return w.peak ? w.peak->displacement : kNoPeak;
}

double ultimate_error(const WallReading& w)
{
    const fragility::DropRange& range = w.ultimate_range;
    const double at = w.ultimate.displacement;
    if (!is_observed(w.ultimate) || !is_defined(range.earliest) || !(at > 0.0))
        return std::numeric_limits<double>::quiet_NaN();
    return std::max(at - range.earliest.displacement, range.latest.displacement - at) / at;
}

} // namespace app
