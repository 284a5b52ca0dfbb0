#include "app/fragility/numbers/fragility_data.hpp"

#include "app/output/table/cells.hpp"
#include "app/study/answers/limit_choices.hpp"
#include "app/study/answers/solver_error.hpp"
#include "app/study/pushed/pier_remark.hpp"
#include "app/study/stored/study_walls.hpp"
#include "app/text/number_text.hpp"
#include "fragility/curve/drift.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace app {

std::vector<fragility::Observation> limits_of(const DriftGroup& group, std::size_t state,
                                              int mode)
{
    std::vector<fragility::Observation> limits;
    for (const DriftWall& w : group.walls)
        if ((mode < 0 || w.mode == mode) && w.limits[state]) limits.push_back(*w.limits[state]);
    return limits;
}

namespace {

bool is_inaccurate(const DriftWall& w, std::size_t state)
{
    return w.most > 1.0 && w.limits[state] && !w.limits[state]->capped;
}

/// Displacements are wrong by the error of the force at least; the fall to the ultimate share
/// by more, where the force falls slowly.
void allow_for_error(const StudyWall& wall, DriftWall& w)
{
    w.least = std::max(0.0, 1.0 - wall.solver_error);
    w.most = 1.0 + wall.solver_error;
    const double at = wall.reading.ultimate.displacement;
    if (!is_observed(wall.reading.ultimate) || !(at > 0.0)) return;
    const fragility::DropRange& range = wall.reading.ultimate_range;
    if (is_defined(range.earliest))
        w.least = std::min(w.least, range.earliest.displacement / at);
    if (is_observed(range.latest)) w.most = std::max(w.most, range.latest.displacement / at);
    if (is_censored(range.latest)) w.most = std::numeric_limits<double>::infinity();
}

void multiply(double factor, fragility::Observation& limit)
{
    if (std::isfinite(factor)) limit.lower *= factor;
    if (std::isfinite(limit.upper)) limit.upper *= factor;
}

} // namespace

std::vector<fragility::Observation> limits_at(const DriftGroup& group, std::size_t state,
                                              ErrorEnd end, int mode)
{
    std::vector<fragility::Observation> limits;
    for (const DriftWall& w : group.walls) {
        if ((mode >= 0 && w.mode != mode) || !w.limits[state]) continue;
        limits.push_back(*w.limits[state]);
        if (!is_inaccurate(w, state)) continue;
        multiply(end == ErrorEnd::most ? w.most : w.least, limits.back());
    }
    return limits;
}

std::size_t inaccurate_walls(const DriftGroup& group, std::size_t state)
{
    return static_cast<std::size_t>(std::ranges::count_if(
        group.walls, [state](const DriftWall& w) { return is_inaccurate(w, state); }));
}

bool only_limits(const std::vector<fragility::Observation>& limits)
{
    bool any = false;
    for (const fragility::Observation& o : limits) {
        if (o.lower == o.upper && !o.capped) return false;
        any = any || o.capped;
    }
    return any;
}

std::string limit_text(const DriftData& data, std::size_t group, std::size_t state)
{
    const auto limits = limits_of(data.groups[group], state);
    const std::vector<fragility::Cap> caps = fragility::caps(limits);
    if (caps.empty()) return {};
    const auto drift = [&](double x) {
        return fixed(x, decimals_for(x)) + (data.unit.empty() ? "" : " " + data.unit);
    };
    const std::string n = std::to_string(limits.size());
    std::string text = data.states[state].set == "user" ? "limit given" : "cap of the code";
    for (const fragility::Cap& c : caps)
        text += (&c == &caps.front() ? " (" : ", (") + drift(c.value) +
                "): " + number(100.0 * c.walls / static_cast<double>(limits.size()), 3) +
                " % of walls";
    const auto fell = std::ranges::count_if(
        limits, [](const auto& o) { return o.lower == o.upper && !o.capped; });
    if (fell > 0) text += "; " + std::to_string(fell) + " of " + n + " fell before";
    return text;
}

std::string pier_text(const DriftData& data, std::size_t group, std::size_t state)
{
    std::map<int, std::size_t> piers;
    const DriftGroup& g = data.groups[group];
    for (const DriftWall& w : g.walls)
        if (state < w.piers.size() && w.piers[state] > 0) ++piers[w.piers[state]];
    std::string text;
    for (const auto& [pier, walls] : piers)
        text += (text.empty() ? "pier " : ", pier ") + std::to_string(pier) + ": " +
                number(100.0 * static_cast<double>(walls) /
                           static_cast<double>(limits_of(g, state).size()),
                       3) +
                " %";
    return text;
}

std::string drift_head(const DriftData& data, const std::string& what)
{
    return data.unit.empty() ? what : what + " [" + data.unit + "]";
}

Cell group_cell(const DriftGroup& group)
{
    return group.stress ? Cell(given(*group.stress)) : Cell(group.name);
}

std::string counts_text(const DriftData& data)
{
    std::size_t n = 0, failed = 0, missing = 0;
    for (const DriftGroup& g : data.groups) {
        n += g.walls.size();
        failed += g.failed;
        missing += g.missing;
    }
    std::string text = data.source + ": " + std::to_string(n) + " walls";
    if (failed > 0) text += ", " + std::to_string(failed) + " failed";
    if (missing > 0) text += ", " + std::to_string(missing) + " not in this file";
    return text;
}

DriftOptions drift_options(const UqInput& uq, const FragilityInput& f)
{
    return {f.law, f.confidence, static_cast<std::size_t>(f.bootstrap), uq.seed};
}

DriftData drift_data(const StudyWalls& walls)
{
    DriftData data;
    data.source = walls.name;
    data.drift =
        "Drift: displacement of the load line / its height, " + number(walls.height, 6) + " m";
    data.no_limit = no_limit_remark(walls);
    if (const std::string yield = no_yield_remark(walls); !yield.empty())
        data.no_limit += (data.no_limit.empty() ? "" : " ") + yield;
    data.model_text = factor_text(walls.study.solver, walls.study.fragility, Answer::drift);
    if (const std::string piers = pier_remark(walls.rules, walls.study);
        !piers.empty() && walls.piers.empty())
        data.drift += "; " + piers;
    data.group_head = "stress [MPa]";
    const std::vector<int> modes = modes_of(walls);
    for (const int mode : modes) data.modes.emplace_back(mode_name(mode));
    data.options = drift_options(walls.study.uq, walls.study.fragility);
    data.states = walls.states;
    for (const StudyLevel& level : walls.levels) {
        DriftGroup group{stress_text(level.stress), level.stress / 1e6, {},
                         level.failed_walls.size(), level.missing,      {}};
        group.model = applied_factor(walls.study, level.stress, Answer::drift);
        for (const StudyWall& w : level.walls) {
            const auto mode = std::ranges::find(modes, mode_of(w));
            DriftWall wall{static_cast<int>(mode - modes.begin()), {}};
            if (misses_accuracy(w.solver_error, walls.study.solver)) allow_for_error(w, wall);
            wall.piers = w.reading.governing;
            for (std::size_t s = 0; s < w.reading.limits.size(); ++s) {
                auto o = fragility::observation(w.reading.limits[s],
                                                fragility::percent_per_metre(walls.height));
                if (o && s < wall.piers.size() && wall.piers[s] > 0) o->capped = false;
                wall.limits.push_back(o);
            }
            group.walls.push_back(std::move(wall));
        }
        data.groups.push_back(std::move(group));
    }
    return data;
}

} // namespace app
