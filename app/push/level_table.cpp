#include "app/push/level_table.hpp"

#include "app/input/study/load_input.hpp"
#include "app/study/answers/fragility_text.hpp"
#include "app/study/answers/mode_rule.hpp"
#include "app/study/answers/number_cells.hpp"
#include "app/study/pushed/both_ways.hpp"

#include <algorithm>
#include <string>

namespace app {

namespace {

/// A push, and its direction.
struct LevelRow {
    const PushedWall* wall;
    const char* way;
};

std::string mode_of(const PushedWall& w)
{
    if (dem::failed(w.result.outcome)) return "failed";
    return came_down_at_once(w) ? "" : std::string(name(w.reading.mode));
}

TableColumn<LevelRow> number_of(const WallNumber& n, unsigned holds = 0)
{
    return number_column<LevelRow>(n, holds,
                                   [](const LevelRow& r) { return source_of(*r.wall); });
}

} // namespace

Table level_table(const LoadInput& load, const FragilityInput& fragility,
                  const std::vector<PushedWall>& walls)
{
    Table t;
    t.title = "Capacity per vertical stress";
    t.caption = "Ultimate: the " + ultimate_text(fragility) +
                "; '>' marks walls whose force had not come down so far when the push "
                "ended. Solver error: of the peak, by the speed of the push." +
                backbone_text(load, fragility);
    const bool both = std::ranges::any_of(walls, other_way_of);
    const int direction = push_way(load).direction;
    std::vector<LevelRow> rows;
    for (const PushedWall& w : walls) {
        rows.push_back({&w, way_name(direction)});
        if (const PushedWall* const other = other_way_of(w))
            rows.push_back({other, way_name(-direction)});
    }
    TableColumns<LevelRow> columns = {{"stress [MPa]", [](const LevelRow& r) {
                                           return stress_cell(r.wall->vertical_stress);
                                       }}};
    if (both) {
        t.keys = 2;
        columns.push_back({"pushed to the", [](const LevelRow& r) { return r.way; }});
    }
    append(columns, {number_of(wall_number("peak_force")),
                     number_of(wall_number("peak_displacement")),
                     number_of(wall_number("secant_stiffness")),
                     number_of(wall_number("ultimate_displacement"), kCensored),
                     number_of(wall_number("ultimate_drift"), kCensored | kDetail),
                     {"mode", [](const LevelRow& r) { return mode_of(*r.wall); }},
                     number_of(wall_number("cracked_units")),
                     number_of(wall_number("solver_error"), kDetail),
                     number_of(wall_number("ultimate_error"), kDetail),
                     number_of(wall_number("points_error"), kDetail),
                     number_of(wall_number("energy_residual"), kDetail)});
    fill(t, columns, rows);
    return t;
}

} // namespace app
