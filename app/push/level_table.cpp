#include "app/push/level_table.hpp"

#include "app/output/cells.hpp"
#include "app/study/both_ways.hpp"
#include "app/study/fragility_text.hpp"
#include "app/study/mode_rule.hpp"

#include <algorithm>
#include <string>

namespace app {

namespace {

Row level_row(const PushedWall& w)
{
    const WallReading& r = w.reading;
    return {stress_cell(w.vertical_stress),
            plain_number(peak_force(r) * 1e-3, 2),
            plain_number(peak_displacement(r) * 1e3, 2),
            r.stiffness ? plain_number(*r.stiffness * 1e-6, 1) : Number{},
            limit_cell(r.ultimate, 1e3, 2),
            limit_cell(r.ultimate, 100.0 / w.loads.height, 2),
            std::string(dem::failed(w.result.outcome) ? "failed"
                        : came_down_at_once(w)        ? ""
                                                      : name(r.mode)),
            count(w.mechanism.cracked_units),
            plain_number(100.0 * solver_error(w), 2),
            plain_number(100.0 * energy_residual(w), 4)};
}

} // namespace

Table level_table(const Study& study, const std::vector<PushedWall>& walls)
{
    Table t;
    t.title = "Capacity per vertical stress";
    t.caption = "Ultimate: the " + ultimate_text(study.fragility) +
                "; '>' marks walls whose force had not come down so far when the push "
                "ended. Solver error: of the peak, by the speed of the push." +
                backbone_text(study);
    t.head = {"stress [MPa]",
              "peak [kN]",
              "at [mm]",
              "stiffness [kN/mm]",
              {"ultimate [mm]", kCensored},
              {"drift [%]", kCensored | kDetail},
              "mode",
              "cracked units",
              {"solver error [%]", kDetail},
              {"energy residual [%]", kDetail}};
    const bool both = std::ranges::any_of(walls, other_way_of);
    if (both) {
        t.head.insert(t.head.begin() + 1, "pushed to the");
        t.keys = 2;
    }
    const int direction = push_way(study).direction;
    const auto add = [&](const PushedWall& w, int way) {
        t.rows.push_back(level_row(w));
        if (both) t.rows.back().insert(t.rows.back().begin() + 1, std::string(way_name(way)));
    };
    for (const PushedWall& w : walls) {
        add(w, direction);
        if (const PushedWall* const other = other_way_of(w)) add(*other, -direction);
    }
    return t;
}

} // namespace app
