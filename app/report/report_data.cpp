#include "app/report/report_data.hpp"

#include "app/fragility/fragility_cycles.hpp"
#include "app/fragility/fragility_inputs.hpp"
#include "app/fragility/fragility_means.hpp"
#include "app/fragility/fragility_modes.hpp"
#include "app/fragility/fragility_walls.hpp"
#include "app/fragility/numbers/fragility_limits.hpp"
#include "app/fragility/numbers/limit_drifts.hpp"
#include "app/fragility/numbers/model_doubt.hpp"
#include "app/fragility/solver_error_table.hpp"
#include "app/input/wall/random_layouts.hpp"
#include "app/program_version.hpp"
#include "app/report/report_parts.hpp"
#include "app/study/answers/part_tables.hpp"
#include "app/study/answers/pier_shares.hpp"
#include "app/study/answers/solver_error.hpp"
#include "app/study/pushed/both_ways.hpp"
#include "app/study/study_summary.hpp"
#include "app/text/json_text.hpp"
#include "app/text/number_text.hpp"
#include "dem/scene/layout.hpp"

#include <map>
#include <string_view>

namespace app {
namespace {

Json shown(double x, int digits) { return or_null(rounded(x, digits)); }

Json levels_json(const StudyWalls& study)
{
    Json levels = Json::array();
    for (const StudyLevel& l : study.levels)
        levels.push_back({{"stress", l.stress / 1e6}, {"name", stress_text(l.stress)}});
    return levels;
}

Json inputs_json(const StudyWalls& study)
{
    Json inputs = Json::array();
    for (const StoredInput& input : study.inputs)
        inputs.push_back({{"key", input.key}, {"unit", input.unit}, {"count", input.count}});
    return inputs;
}

Json wall_json(const StudyWall& w)
{
    Json inputs = Json::array();
    for (const double x : w.inputs) inputs.push_back(shown(x, 5));
    const WallReading& r = first_way(w); // beside its curve
    Json j = {{"level", w.key.level},
              {"sample", w.key.sample},
              {"mode", w.failed ? "failed" : name(r.mode)},
              {"reason", w.reason},
              {"reading", is_defined(r.ultimate) ? name(r.ultimate.reading) : "none"},
              {"inputs", inputs}};
    for (const WallNumber* const n :
         {&wall_number("peak_force"), &wall_number("peak_displacement"),
          &wall_number("ultimate_displacement")})
        j[summary_key(*n)] = shown(n->reading(r, 1.0) * n->unit.scale, 6);
    return j;
}

Json walls_json(const WallList& listed)
{
    Json walls = Json::array();
    for (const StudyWall* w : listed) walls.push_back(wall_json(*w));
    return walls;
}

Json provenance_json(const StudyWalls& study)
{
    const StoreHead& head = study.head;
    Json sessions = Json::array();
    for (const StoreSession& s : head.sessions)
        sessions.push_back({{"version", s.program_version},
                            {"solver_revision", s.solver_revision},
                            {"machine", s.machine},
                            {"build", s.build},
                            {"settings", s.settings},
                            {"started", s.started}});
    return {{"version", program_version()},
            {"seed", std::to_string(head.seed)},
            {"shard", head.shard + 1},
            {"shards", head.shards},
            {"design_sizes", head.design_sizes},
            {"configuration", head.configuration},
            {"sessions", sessions}};
}

Json table_json(const std::string& id, const Table& table)
{
    const ShownTable people = shown(table);
    std::string caption = table.caption;
    for (const std::string& note : people.notes) caption += " " + note;
    return {{"id", id},
            {"title", table.title},
            {"caption", caption},
            {"head", people.head},
            {"rows", people.rows},
            {"text", as_text(table)},
            {"csv", as_csv(table)},
            {"markdown", as_markdown(table)},
            {"latex", as_latex(table)}};
}

/// The tables of `drystone study` and `drystone fragility`, by name.
Json tables_json(const StudyWalls& study, const DriftData& data, const WallList& listed)
{
    const std::pair<const char*, Table> tables[] = {
        {"results", summarise(study).table},
        {"means_by_mode", mean_table(study)},
        {"performance_limits", performance_table(data)},
        {"limits_with_doubt", drift_doubt_table(data)},
        {"forces_with_doubt", force_doubt_table(study)},
        {"law_parameters", law_table(data)},
        {"solver_error", solver_error_table(study)},
        {"modes", mode_table(study)},
        {"equal_modes", equal_modes_table(study)},
        {"mode_thresholds", threshold_table(study)},
        {"inputs", input_table(study)},
        {"choices", choice_table(study)},
        {"materials", material_table(study)},
        {"wall_and_loads", wall_and_load_table(study)},
        {"walls", wall_table(study, listed)}};
    Json all = Json::object();
    for (const auto& [name, table] : tables) all[name] = table_json(name, table);
    if (!study.piers.empty()) {
        all["pier_limits"] = table_json("pier_limits", pier_share_table(study));
        all["piers"] = table_json("piers", study_pier_table(study));
        if (!study.spandrels.empty())
            all["spandrels"] = table_json("spandrels", study_spandrel_table(study));
    }
    if (!study.pushed_one_way) all["cycles"] = table_json("cycles", cycle_table(study));
    return all;
}

/// @param seed of the layout
Json geometry_of(const PreparedStudy& ready, std::uint32_t seed)
{
    return wall_geometry(has_layouts(ready.study.geometry) ? in_layout(ready.study, seed).layout
                                                           : ready.layout);
}

Json overview_json(const StudyWalls& study, const DriftData& data)
{
    const Overview o = overview(study);
    return {{"lead", o.lead},
            {"answers", answers_json(study, data)},
            {"solver", solver_error_text(study)},
            {"run", o.run},
            {"found", o.found},
            {"sure", o.sure}};
}

/// Which push a curve is of, where walls were pushed both ways; else empty.
std::string curve_ways(const StudyWalls& study)
{
    if (!has_turned(study.head)) return {};
    return std::string("Curves and films of single walls: pushed to the ") +
           way_name(study.rules.direction) +
           "; means and tables: the direction in which a wall carries less.";
}

} // namespace

Json report_data(const StudyWalls& study, const WallList& listed, const FitProgress& seen)
{
    DriftData data = drift_data(study);
    choose_limits(data, seen);
    return {{"name", study.name},
            {"overview", overview_json(study, data)},
            {"levels", levels_json(study)},
            {"inputs", inputs_json(study)},
            {"height", study.height},
            {"confidence", study.study.fragility.confidence},
            {"walls", walls_json(listed)},
            {"curves", curves_json(study, listed)},
            {"ways", curve_ways(study)},
            {"means", mean_curves_json(study)},
            {"loops", loops_json(study, listed)},
            {"damping", damping_json(study)},
            {"fragility", fragility_json(data)},
            {"modes", modes_json(study)},
            {"histograms", histograms_json(study)},
            {"running", running_json(study)},
            {"sensitivity", sensitivity_json(study)},
            {"whatif", whatif_json(study)},
            {"tables", tables_json(study, data, listed)},
            {"provenance", provenance_json(study)}};
}

Json films_json(const PreparedStudy& ready, const WallList& listed, const Replay& replay,
                const std::string& note)
{
    Json films = {{"note", note}, {"films", Json::array()}};
    if (replay.walls.empty()) return films;
    films["geometries"] = Json::array();
    std::map<std::uint32_t, std::size_t> places; // of geometries, by the seeds of their layouts
    std::map<const StudyWall*, const Film*> of_wall;
    for (std::size_t i = 0; i < replay.walls.size(); ++i)
        of_wall[replay.walls[i]] = &replay.films[i];
    for (std::size_t w = 0; w < listed.size(); ++w) {
        const auto film = of_wall.find(listed[w]);
        if (film == of_wall.end()) continue;
        const Film& f = *film->second;
        const std::uint32_t seed = layout_seed(ready.study, listed[w]->key.sample);
        const auto [at, first] = places.try_emplace(seed, places.size());
        if (first) films["geometries"].push_back(geometry_of(ready, seed));
        films["films"].push_back({{"wall", w},
                                  {"geometry", at->second},
                                  {"frames", f.frames},
                                  {"step", f.step},
                                  {"data", f.data}});
        if (f.crushing) films["films"].back()["crushing"] = true;
    }
    return films;
}

} // namespace app
