#include "app/fragility/fragility_walls.hpp"

#include "app/fragility/numbers/table_texts.hpp"
#include "app/study/answers/fragility_text.hpp"
#include "app/study/answers/number_cells.hpp"

namespace app {
namespace {

using Wall = const StudyWall*;

std::string note_on(const StudyWall& w)
{
    if (w.failed) return "Failed: " + w.reason + ".";
    return w.reading.slid
               ? "Slid whole, which counts as rocking; drift limits of codes are those of a "
                 "wall that does not rock."
               : w.reading.no_reading;
}

/// A number of a wall; nothing where it would be a fact of one that failed.
TableColumn<Wall> number_of(const StudyWalls& study, const WallNumber& n, unsigned holds = 0)
{
    return {number_head(n, holds), [&n, holds, height = study.height](Wall w) -> Cell {
                if (n.fact != nullptr && w->failed) return {};
                return number_cell(n, source_of(*w, height), holds);
            }};
}

TableColumns<Wall> columns_of(const StudyWalls& study)
{
    TableColumns<Wall> all = {
        {"stress [MPa]",
         [&](Wall w) { return stress_cell(study.levels[w->key.level].stress); }},
        {"sample", [](Wall w) { return count(w->key.sample); }},
        {"mode",
         [](Wall w) { return std::string(w->failed ? "failed" : name(w->reading.mode)); }},
        number_of(study, wall_number("peak_force")),
        number_of(study, wall_number("peak_displacement")),
        number_of(study, wall_number("ultimate_displacement"), kCensored)};
    for (std::size_t i = 0; i < study.states.size(); ++i)
        all.push_back({{state_name(study.states[i]) + " [mm]", kCensored | kProgramsOnly},
                       [i](Wall w) { return limit_cell(w->reading.limits.at(i), 1e3, 2); }});
    all.push_back({{"mode of codes", kProgramsOnly}, [&](Wall w) -> Cell {
                       if (w->failed) return {};
                       return std::string(name(code_mode(w->mechanism, w->reading.dropped,
                                                         study.study.fragility.mode)));
                   }});
    append(all, {number_of(study, wall_number("cracked_units")),
                 number_of(study, wall_number("rotation_share")),
                 number_of(study, wall_number("sliding_share")),
                 number_of(study, wall_number("solver_error")),
                 number_of(study, wall_number("ultimate_error")),
                 number_of(study, wall_number("points_error"))});
    for (std::size_t i = 0; i < study.inputs.size(); ++i) {
        const StoredInput& input = study.inputs[i];
        all.push_back({(input.count > 1 ? "mean " : "") + input.key + " [" + input.unit + "]",
                       [i](Wall w) {
                           return plain_number(w->inputs[i], decimals_for(w->inputs[i]) + 2);
                       }});
    }
    all.push_back({{"note", kNote}, [](Wall w) { return note_on(*w); }});
    return all;
}

} // namespace

Table wall_table(const StudyWalls& study, const WallList& walls)
{
    Table t = titled_table("walls", words_of(study));
    t.keys = 2;
    const std::size_t all = all_walls(study).size();
    if (walls.size() < all)
        t.caption = "The table shows " + std::to_string(walls.size()) + " of " +
                    std::to_string(all) +
                    " walls: those with the lowest sample numbers under each stress; drystone "
                    "fragility writes all of them into walls.csv. " +
                    t.caption;
    fill(t, columns_of(study), walls);
    return t;
}

} // namespace app
