#include "app/fragility/fragility_walls.hpp"

#include "app/fragility/table_texts.hpp"
#include "app/output/cells.hpp"
#include "app/reading/wall_words.hpp"

namespace app {
namespace {

Number limit_cell(const fragility::LimitDisplacement& d)
{
    if (!is_defined(d)) return {};
    return {.value = d.displacement * 1e3,
            .decimals = 2,
            .sense = is_censored(d) ? Sense::above : Sense::equal};
}

Row wall_row(const StudyWalls& study, const StudyWall& w)
{
    const WallReading& r = w.reading;
    Row row = {
        given(study.levels[w.key.level].stress / 1e6),    count(w.key.sample),
        std::string(w.failed ? "failed" : words(r.mode)), plain_number(peak_force(r) * 1e-3, 2),
        plain_number(peak_displacement(r) * 1e3, 2),      limit_cell(r.ultimate)};
    for (const fragility::LimitDisplacement& d : r.limits) row.emplace_back(limit_cell(d));
    const bool failed = w.failed;
    row.insert(row.end(), {failed ? Number{} : count(w.mechanism.cracked_units),
                           failed ? Number{} : plain_number(w.mechanism.rotation_share, 2),
                           failed ? Number{} : plain_number(w.mechanism.sliding_share, 2)});
    for (const double x : w.inputs) row.emplace_back(plain_number(x, decimals_for(x) + 2));
    row.emplace_back(failed ? "Failed: " + w.reason + "." : std::string(r.no_reading));
    return row;
}

} // namespace

Table wall_table(const StudyWalls& study, const WallList& walls)
{
    Table t = titled_table("walls", words_of(study));
    t.keys = 2;
    const std::size_t all = all_walls(study).size();
    if (walls.size() < all)
        t.caption = std::to_string(walls.size()) + " of " + std::to_string(all) +
                    " walls, those of the lowest sample numbers under each stress; drystone "
                    "fragility writes all of them into walls.csv. " +
                    t.caption;
    t.head = {"stress [MPa]", "sample",       "mode",
              "peak [kN]",    "at peak [mm]", {"ultimate [mm]", kCensored}};
    for (const StateName& s : study.states)
        t.head.emplace_back(s.set + " " + s.name + " [mm]", kCensored | kProgramsOnly);
    for (const char* const head : {"cracked units", "rotation share", "sliding share"})
        t.head.emplace_back(head);
    for (const StoredInput& input : study.inputs)
        t.head.emplace_back((input.count > 1 ? "mean " : "") + input.key + " [" + input.unit +
                            "]");
    t.head.emplace_back("note", kNote);
    for (const StudyWall* w : walls) t.rows.push_back(wall_row(study, *w));
    return t;
}

} // namespace app
