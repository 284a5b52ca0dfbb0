#include "app/push/limit_table.hpp"

#include "app/input/limit_state_text.hpp"
#include "app/push/pier_table.hpp"
#include "app/study/both_ways.hpp"
#include "app/study/fragility_text.hpp"

#include <algorithm>
#include <string>
#include <utility>

namespace app {

Table limit_table(const Study& study, const std::vector<PushedWall>& walls)
{
    Table t;
    t.title = "Limit states";
    t.caption =
        "Limit states of each wall; '>' marks limit states that the wall had not reached when "
        "the push ended.";
    t.keys = 2;
    t.head = {"stress [MPa]",
              "limit state",
              {"displacement [mm]", kCensored},
              {"drift [%]", kCensored},
              {"note", kNote}};
    ReadingRules rules = reading_rules(study);
    rules.by_piers = std::ranges::any_of(walls, [](const auto& w) { return !w.piers.empty(); });
    const std::vector<StateName> names = state_names(rules);
    for (const StateName& n : names) t.caption += " " + state_name(n) + ": " + n.rule + ".";
    const bool both = std::ranges::any_of(walls, other_way_of);
    if (both) {
        t.head.insert(t.head.end() - 1, "pushed to the");
        t.caption += " Of both directions, the one that reaches the limit state first.";
    }
    for (const PushedWall& w : walls) {
        const WallReading worse = worse_way(w);
        for (std::size_t i = 0; i < names.size(); ++i) {
            const fragility::LimitDisplacement& limit = worse.limits.at(i);
            Row row = {stress_cell(w.vertical_stress), state_name(names[i]),
                       limit_cell(limit, 1e3, 2), limit_cell(limit, 100.0 / w.loads.height, 3)};
            if (both) row.emplace_back(worse_way_name(study, w, i));
            const std::string pier = pier_note(study, worse_push(w, i), names[i], i);
            add_row(t, std::move(row), std::string(limit.reason) + pier);
        }
    }
    return t;
}

} // namespace app
