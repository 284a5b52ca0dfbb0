#include "app/push/limit_table.hpp"

#include "app/push/pier_table.hpp"
#include "app/study/answers/number_cells.hpp"
#include "app/study/pushed/both_ways.hpp"

#include <algorithm>
#include <string>
#include <vector>

namespace app {

namespace {

/// A limit state of a wall, of both directions the one that reaches it first.
struct LimitRow {
    const PushedWall* wall;
    std::size_t state;
    fragility::LimitDisplacement limit;
};

} // namespace

Table limit_table(ReadingRules rules, const std::vector<PushedWall>& walls)
{
    Table t;
    t.title = "Limit states";
    t.caption =
        "Limit states of each wall; '>' marks limit states that the wall had not reached when "
        "the push ended.";
    t.keys = 2;
    rules.by_piers = std::ranges::any_of(walls, [](const auto& w) { return !w.piers.empty(); });
    const std::vector<StateName> names = state_names(rules);
    for (const StateName& n : names) t.caption += " " + state_name(n) + ": " + n.rule + ".";
    std::vector<LimitRow> rows;
    for (const PushedWall& w : walls) {
        const WallReading worse = worse_way(w);
        for (std::size_t i = 0; i < names.size(); ++i)
            rows.push_back({&w, i, worse.limits.at(i)});
    }
    TableColumns<LimitRow> columns = {
        {"stress [MPa]",
         [](const LimitRow& r) { return stress_cell(r.wall->vertical_stress); }},
        {"limit state", [&](const LimitRow& r) { return state_name(names[r.state]); }}};
    append(columns,
           limit_columns<LimitRow>([](const LimitRow& r) { return r.limit; },
                                   [](const LimitRow& r) { return r.wall->loads.height; }));
    if (std::ranges::any_of(walls, other_way_of)) {
        t.caption += " Of both directions, the one that reaches the limit state first.";
        columns.push_back({"pushed to the", [&](const LimitRow& r) {
                               return worse_way_name(rules.direction, *r.wall, r.state);
                           }});
    }
    columns.push_back({{"note", kNote}, [&](const LimitRow& r) {
                           return std::string(r.limit.reason) +
                                  pier_note(rules, worse_push(*r.wall, r.state), names[r.state],
                                            r.state);
                       }});
    fill(t, columns, rows);
    return t;
}

} // namespace app
