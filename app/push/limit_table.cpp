#include "app/push/limit_table.hpp"

#include "app/input/limit_state_text.hpp"
#include "app/study/fragility_text.hpp"

namespace app {
namespace {

Cell displacement_cell(const fragility::LimitDisplacement& d, double scale, int decimals)
{
    if (!is_defined(d)) return {};
    return Number{.value = d.displacement * scale,
                  .decimals = decimals,
                  .sense = is_censored(d) ? Sense::at_least : Sense::equal};
}

} // namespace

Table limit_table(const Study& study, const std::vector<PushedWall>& walls)
{
    Table t;
    t.title = "Limit states";
    t.caption =
        "Limit states of each wall; >= where the wall had not reached it when the push ended.";
    t.keys = 2;
    t.head = {"stress [MPa]",
              "limit state",
              {"at [mm]", kCensored},
              {"drift [%]", kCensored},
              {"note", kNote}};
    const std::vector<StateName> names = state_names(reading_rules(study));
    for (const StateName& n : names)
        t.caption += " " + n.set + " " + n.name + ": " + n.rule + ".";
    for (const PushedWall& w : walls)
        for (std::size_t i = 0; i < names.size(); ++i) {
            const fragility::LimitDisplacement& limit = w.reading.limits.at(i);
            t.rows.push_back({given(w.vertical_stress / 1e6),
                              names[i].set + " " + names[i].name,
                              displacement_cell(limit, 1e3, 2),
                              displacement_cell(limit, 100.0 / w.loads.height, 3),
                              std::string(limit.reason)});
        }
    return t;
}

} // namespace app
