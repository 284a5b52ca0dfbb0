#include "app/push/limit_table.hpp"

#include "app/input/limit_state_text.hpp"
#include "app/study/fragility_text.hpp"

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
    const std::vector<StateName> names = state_names(reading_rules(study));
    for (const StateName& n : names) t.caption += " " + state_name(n) + ": " + n.rule + ".";
    for (const PushedWall& w : walls)
        for (std::size_t i = 0; i < names.size(); ++i) {
            const fragility::LimitDisplacement& limit = w.reading.limits.at(i);
            add_row(t,
                    {stress_cell(w.vertical_stress), state_name(names[i]),
                     limit_cell(limit, 1e3, 2), limit_cell(limit, 100.0 / w.loads.height, 3)},
                    std::string(limit.reason));
        }
    return t;
}

} // namespace app
