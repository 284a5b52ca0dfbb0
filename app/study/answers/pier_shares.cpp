#include "app/study/answers/pier_shares.hpp"

#include "app/output/table/cells.hpp"
#include "app/study/answers/fragility_text.hpp"
#include "app/study/answers/mean_cells.hpp"
#include "app/study/pushed/both_ways.hpp"
#include "app/study/pushed/pier_remark.hpp"
#include "app/text/number_text.hpp"
#include "fragility/codes/code_table.hpp"
#include "fragility/curve/drift.hpp"
#include "fragility/fits/share.hpp"

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

namespace app {
namespace {

/// The direction whose limit is that of the wall.
int direction_of(const StudyWalls& study, const StudyWall& wall, std::size_t state)
{
    const int own = study.rules.direction;
    if (wall.ways.size() != 2) return own;
    const auto &a = wall.ways[0].limits.at(state), &b = wall.ways[1].limits.at(state);
    if (same_limit(a, b)) return 0;
    return same_limit(wall.reading.limits.at(state), a) ? own : -own;
}

const fragility::CodeState* code_state(const StudyWalls& study, const StateName& state)
{
    const fragility::Code* const code = fragility::find_code(study.rules.sets, state.set);
    if (code == nullptr) return nullptr;
    const auto at = std::ranges::find(code->states, state.name, &fragility::CodeState::name);
    return at == code->states.end() ? nullptr : &*at;
}

/// "pier 3 17, pier 1 2"
std::string counts_of(const StudyWalls& study, const StudyLevel& level, std::size_t state)
{
    std::string text;
    for (const GoverningPier& g : governing_piers(study, level, state))
        text += (text.empty() ? "" : ", ") + governing_text(study, g) + ": " +
                std::to_string(g.walls);
    return text;
}

} // namespace

std::vector<std::size_t> pier_states(const StudyWalls& study)
{
    std::vector<std::size_t> states;
    for (std::size_t s = 0; s < study.states.size() && !study.piers.empty(); ++s) {
        const fragility::CodeState* const state = code_state(study, study.states[s]);
        if (state != nullptr && !state->drifts.empty()) states.push_back(s);
    }
    return states;
}

std::vector<GoverningPier> governing_piers(const StudyWalls& study, const StudyLevel& level,
                                           std::size_t state)
{
    using Who = std::tuple<int, int, int>; // in the order of rows
    constexpr int kForce = 1 << 20, kNotReached = kForce + 1;
    std::map<Who, std::size_t> found;
    for (const StudyWall& w : level.walls) {
        const fragility::LimitDisplacement& limit = w.reading.limits.at(state);
        if (!is_defined(limit)) continue;
        const int pier = state < w.reading.governing.size() ? w.reading.governing[state] : 0;
        const bool reached = is_observed(limit);
        ++found[{!reached    ? kNotReached
                 : pier == 0 ? kForce
                             : pier,
                 reached ? -direction_of(study, w, state) : 0, pier}];
    }
    std::vector<GoverningPier> all;
    for (const auto& [who, walls] : found)
        all.push_back(
            {std::get<2>(who), -std::get<1>(who), std::get<0>(who) != kNotReached, walls});
    return all;
}

std::string governing_text(const StudyWalls& study, const GoverningPier& who)
{
    if (!who.reached) return "not reached";
    const std::string what =
        who.pier > 0 ? "pier " + std::to_string(who.pier) : "the fall of the force";
    if (!has_turned(study.head)) return what;
    return what + (who.direction == 0 ? " either way"
                                      : std::string(" to the ") + way_name(who.direction));
}

std::string pier_counts(const StudyWalls& study, const StudyLevel& level)
{
    std::string text;
    for (const std::size_t s : pier_states(study))
        if (const std::string counts = counts_of(study, level, s); !counts.empty())
            text += (text.empty() ? "" : "; ") + state_name(study.states[s]) +
                    (study.levels.size() > 1 ? " at " + stress_text(level.stress) : "") +
                    " by " + counts;
    return text;
}

std::string pier_sentence(const StudyWalls& study)
{
    if (study.piers.empty()) return pier_sentence(study.rules, study.study);
    std::string text;
    for (const StudyLevel& level : study.levels)
        if (const std::string counts = pier_counts(study, level); !counts.empty())
            text += (text.empty() ? "" : "; ") + counts;
    if (text.empty()) return text;
    return "Drift limits of codes are those of piers, numbered from the left, storey by "
           "storey: "
           "a wall reaches one when its first pier does. Numbers of walls by what governs: " +
           text + ".";
}

Table pier_share_table(const StudyWalls& study)
{
    Table t;
    t.title = "Piers that govern";
    t.caption =
        "Share of the walls whose limit state is the drift limit of this pier, which it "
        "is the first to reach; the fall of the force where that comes before. Piers "
        "are numbered from the left, storey by storey from the bottom. Brackets: " +
        percent_text(study.study.fragility.confidence) +
        " intervals, which hold whatever walls that failed would have done.";
    t.keys = 2;
    t.head = {"stress [MPa]", "limit state", "governs"};
    const bool both = has_turned(study.head);
    if (both) t.head.emplace_back("pushed to the");
    t.head.insert(t.head.end(),
                  {"walls", "n", {"share [%]", kInterval}, {"median drift [%]", kDetail}});
    for (const StudyLevel& level : study.levels)
        for (const std::size_t s : pier_states(study)) {
            const std::vector<GoverningPier> all = governing_piers(study, level, s);
            std::size_t n = 0;
            for (const GoverningPier& g : all) n += g.walls;
            for (const GoverningPier& g : all) {
                Row row = {stress_cell(level.stress), state_name(study.states[s]),
                           !g.reached   ? std::string("not reached")
                           : g.pier > 0 ? "pier " + std::to_string(g.pier)
                                        : std::string("fall of the force")};
                if (both)
                    row.emplace_back(std::string(!g.reached         ? ""
                                                 : g.direction == 0 ? "both"
                                                                    : way_name(g.direction)));
                const fragility::Share share = fragility::share(
                    static_cast<double>(g.walls), static_cast<double>(n),
                    static_cast<double>(level.failed_walls.size()),
                    core::BinomialInterval::wilson, study.study.fragility.confidence);
                std::vector<double> drifts;
                for (const StudyWall& w : level.walls) {
                    const auto& limit = w.reading.limits.at(s);
                    if (g.reached && is_observed(limit) &&
                        w.reading.governing.at(s) == g.pier &&
                        direction_of(study, w, s) == g.direction)
                        drifts.push_back(
                            fragility::percent_drift(limit.displacement, study.height));
                }
                row = joined(row,
                             {count(g.walls), count(n), percent(share.value, share.interval, 0),
                              median_number(drifts, 3)});
                add_row(t, row);
            }
        }
    return t;
}

} // namespace app
