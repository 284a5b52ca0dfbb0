#include "app/fragility/fragility_walls.hpp"

#include "app/fragility/table_texts.hpp"
#include "app/study/fragility_text.hpp"

namespace app {
namespace {

void add_wall(const StudyWalls& study, const StudyWall& w, Table& t)
{
    const WallReading& r = w.reading;
    Row row = {
        stress_cell(study.levels[w.key.level].stress),   count(w.key.sample),
        std::string(w.failed ? "failed" : name(r.mode)), plain_number(peak_force(r) * 1e-3, 2),
        plain_number(peak_displacement(r) * 1e3, 2),     limit_cell(r.ultimate, 1e3, 2)};
    for (const fragility::LimitDisplacement& d : r.limits)
        row.emplace_back(limit_cell(d, 1e3, 2));
    const dem::ModeThresholds& thresholds = study.study.fragility.mode;
    row = joined(
        row, w.failed ? Row(5)
                      : Row{std::string(name(code_mode(w.mechanism, r.dropped, thresholds))),
                            count(w.mechanism.cracked_units),
                            plain_number(w.mechanism.rotation_share, 2),
                            plain_number(w.mechanism.sliding_share, 2),
                            plain_number(100.0 * w.solver_error, 2)});
    for (const double x : w.inputs) row.emplace_back(plain_number(x, decimals_for(x) + 2));
    add_row(t, row,
            w.failed ? "Failed: " + w.reason + "."
            : r.slid
                ? "Slid whole, which counts as rocking; drift limits of codes are those of a "
                  "wall that does not rock."
                : r.no_reading);
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
    t.head = {"stress [MPa]", "sample",       "mode",
              "peak [kN]",    "at peak [mm]", {"ultimate [mm]", kCensored}};
    for (const StateName& s : study.states)
        t.head.emplace_back(state_name(s) + " [mm]", kCensored | kProgramsOnly);
    t.head.emplace_back("mode of codes", kProgramsOnly);
    for (const char* const head :
         {"cracked units", "rotation share", "sliding share", "solver error [%]"})
        t.head.emplace_back(head);
    for (const StoredInput& input : study.inputs)
        t.head.emplace_back((input.count > 1 ? "mean " : "") + input.key + " [" + input.unit +
                            "]");
    t.head.emplace_back("note", kNote);
    for (const StudyWall* w : walls) add_wall(study, *w, t);
    return t;
}

} // namespace app
