#include "app/study/pushed/pier_reading.hpp"

#include "app/input/keys/limit_state_text.hpp"
#include "app/input/study/study.hpp"
#include "app/study/pushed/pier_remark.hpp"
#include "app/study/pushed/pushed_wall.hpp"
#include "fragility/curve/drift.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace app {
namespace {

using fragility::LimitDisplacement;
using fragility::Reading;

constexpr double kNever = 1e9; ///< [m]: a limit that no wall reaches

/// Where the load line is when a pier first reaches a movement of its own.
/// @param place of the load line at each point, in the direction of the push [m]
LimitDisplacement wall_at(std::span<const double> place, std::span<const double> moved,
                          double movement)
{
    double before = moved.front(), wall_before = place.front();
    for (std::size_t k = 0; k < place.size(); ++k) {
        if (moved[k] >= movement) {
            const double share =
                moved[k] > before ? (movement - before) / (moved[k] - before) : 1.0;
            return {wall_before + std::max(share, 0.0) * (place[k] - wall_before),
                    Reading::observed,
                    {}};
        }
        before = moved[k];
        wall_before = place[k];
    }
    return {wall_before, Reading::censored, "the push ended before"};
}

/// The movement by which the mode of the wall is read (pushed_wall.cpp).
dem::Snapshot telling(const dem::PushResult& r)
{
    return r.at_half ? dem::movement_since(*r.at_half, r.at_end) : r.at_drop.value_or(r.at_end);
}

PierReading read_pier(const PierRules& how, const dem::Pier& pier, const PierFacts& facts,
                      const fragility::Curve& wall)
{
    PierReading r;
    r.pier = pier;
    r.facts = facts;
    const double height = pier.at.z1 - pier.at.z0;
    r.drift = fragility::drift(facts.end_movement, height);
    double most = 0.0;
    for (const double force : wall.force) most = std::max(most, std::abs(force));
    constexpr double kCarries = 0.05; // of the wall's largest force: a free choice
    r.carries = facts.most_shear >= kCarries * most;
    r.moved = facts.moved > 0.0;
    ReadingRules rules = how.wall;
    rules.height = height;
    rules.slenderness = facts.slenderness;
    rules.direction = 0; // its movement may come back
    rules.backbone = fragility::Side::right;
    r.own = read({facts.movement, facts.shear, wall.came_down}, facts.mechanism, rules, true);
    r.mode = code_mode(facts.mechanism, r.own.dropped, rules.mode);
    r.mode_so_far = r.moved && !r.own.dropped;
    std::vector<double> place;
    for (const double u : wall.displacement) place.push_back(how.wall.direction * u);
    for (const fragility::Code& code : how.codes)
        for (const fragility::CodeState& state : code.states) {
            if (state.drifts.empty()) continue;
            const double drift = fragility::drift_limit(state, name(r.mode), facts.slenderness);
            r.caps.push_back({code.name, state.name, drift,
                              drift > 0.0 ? wall_at(place, facts.movement, drift * height)
                                          : LimitDisplacement{}});
        }
    return r;
}

struct StoreySum {
    double shear = 0.0, normal = 0.0; ///< [N]
};

StoreySum sum_of(const dem::Piers& all, const PierInstant& now, int storey)
{
    StoreySum sum;
    for (std::size_t i = 0; i < all.piers.size(); ++i)
        if (all.piers[i].storey == storey) {
            sum.shear += now.piers[i].force.shear;
            sum.normal += now.piers[i].force.normal;
        }
    return sum;
}

PierBalance balance_of(const dem::Piers& all, const PierHistory& history)
{
    PierBalance b;
    double most = 0.0;
    for (const PierInstant& now : history) most = std::max(most, std::abs(now.base_shear));
    for (int storey = 1; storey <= all.piers.back().storey; ++storey) {
        const double before = sum_of(all, history.front(), storey).normal;
        for (const PierInstant& now : history) {
            const StoreySum sum = sum_of(all, now, storey);
            b.shear = std::max(b.shear, std::abs(sum.shear - now.base_shear) / most);
            b.normal = std::max(b.normal, std::abs(sum.normal - before) / std::abs(before));
        }
    }
    return b;
}

constexpr std::string_view kSoFar = " so far";

std::string_view so_far(dem::FailureMode mode)
{
    switch (mode) {
    case dem::FailureMode::rocking:
        return "rocking so far";
    case dem::FailureMode::sliding:
        return "sliding so far";
    default:
        return "mixed so far";
    }
}

} // namespace

std::string_view mode_text(const PierReading& pier)
{
    if (!pier.moved) return "stands still";
    if (!pier.carries) return "carries little";
    return pier.mode_so_far ? so_far(pier.mode) : name(pier.mode);
}

bool is_so_far(std::string_view mode) { return mode.ends_with(kSoFar); }

bool tells_piers(const Masonry& masonry, const LoadInput& load)
{
    return push_way(load).direction != 0 && has_piers(masonry);
}

const PierCap* cap_of(const PierReading& pier, std::string_view code, std::string_view state)
{
    for (const PierCap& cap : pier.caps)
        if (cap.code == code && (state.empty() || cap.state == state)) return &cap;
    return nullptr;
}

int governing_pier(const std::vector<PierReading>& piers, std::string_view code,
                   std::string_view state)
{
    int first = 0;
    double least = kNever;
    for (std::size_t i = 0; i < piers.size(); ++i) {
        const PierCap* const cap = cap_of(piers[i], code, state);
        if (cap == nullptr || !piers[i].carries || !is_observed(cap->wall)) continue;
        if (cap->wall.displacement >= least) continue;
        least = cap->wall.displacement;
        first = static_cast<int>(i) + 1;
    }
    return first;
}

PierRules pier_rules(const FragilityInput& fragility, ReadingRules rules)
{
    std::vector<fragility::Code> codes = pier_codes(fragility, rules);
    return {std::move(rules), std::move(codes)};
}

std::vector<PierReading> read_piers(const PierRules& rules, std::span<const dem::Pier> piers,
                                    std::span<const PierFacts> facts,
                                    const fragility::Curve& wall)
{
    std::vector<PierReading> found;
    for (std::size_t i = 0; i < piers.size(); ++i)
        found.push_back(read_pier(rules, piers[i], facts[i], wall));
    return found;
}

std::vector<SpandrelReading> read_spandrels(std::span<const dem::Spandrel> spandrels,
                                            std::span<const SpandrelFacts> facts)
{
    std::vector<SpandrelReading> found;
    for (std::size_t i = 0; i < std::min(spandrels.size(), facts.size()); ++i)
        found.push_back(
            {spandrels[i], facts[i],
             fragility::drift(facts[i].end_drop, spandrels[i].at.x1 - spandrels[i].at.x0)});
    return found;
}

ReadingRules with_piers(ReadingRules rules, const std::vector<PierReading>& piers)
{
    rules.by_piers = true;
    rules.pier_caps.clear();
    for (const fragility::Code& code : rules.sets) {
        rules.pier_caps.emplace_back();
        for (const fragility::CodeState& state : code.states) {
            const int first =
                state.drifts.empty() ? 0 : governing_pier(piers, code.name, state.name);
            PierLimit limit{state.drifts.empty() ? 0.0 : kNever, first};
            if (first > 0)
                limit.displacement =
                    cap_of(piers[static_cast<std::size_t>(first) - 1], code.name, state.name)
                        ->wall.displacement;
            rules.pier_caps.back().push_back(limit);
        }
    }
    return rules;
}

void read_piers(const PierRules& rules, const LoadInput& load, double drop,
                const dem::PierProbe& probe, const PierHistory& history, PushedWall& wall)
{
    if (dem::failed(wall.result.outcome) || came_down_at_once(wall) || history.size() < 2)
        return;
    const PierHistory calm = calmed(history, kCalm * load.height);
    const bool came_down = wall.result.outcome == dem::Outcome::lost_equilibrium;
    const fragility::Curve curve{wall.displacement, wall.force, came_down};
    wall.piers = read_piers(
        rules, probe.piers().piers,
        pier_facts(load, drop, probe, history, calm, wall, telling(wall.result)), curve);
    wall.spandrels = read_spandrels(probe.piers().spandrels, spandrel_facts(history, calm));
    if (wall.piers.empty()) return;
    wall.pier_balance = balance_of(probe.piers(), calm);
    if (load.pattern == dem::LoadPattern::body)
        wall.pier_balance.shear = std::numeric_limits<double>::quiet_NaN();
    wall.reading = read(curve, wall.mechanism, with_piers(rules.wall, wall.piers),
                        wall.result.settled, solver_error(wall));
}

} // namespace app
