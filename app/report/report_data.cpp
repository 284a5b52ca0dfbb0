#include "app/report/report_data.hpp"

#include "app/input/number_text.hpp"
#include "app/report/report_curves.hpp"
#include "app/report/report_fragility.hpp"
#include "app/report/report_inputs.hpp"
#include "app/report/report_overview.hpp"
#include "app/report/report_tables.hpp"
#include "app/version.hpp"
#include "dem/block/model.hpp"

#include <nlohmann/json.hpp>

#include <cmath>
#include <map>
#include <string_view>

namespace app {
namespace {

using Json = nlohmann::ordered_json;

Json shown(double x, int digits)
{
    if (!std::isfinite(x)) return nullptr;
    return std::stod(number(x, digits));
}

Json levels_json(const ReportStudy& study)
{
    Json levels = Json::array();
    for (std::size_t i = 0; i < study.head.levels.size(); ++i)
        levels.push_back({{"stress", study.stress(i)}, {"name", study.stress_text(i)}});
    return levels;
}

Json inputs_json(const ReportStudy& study)
{
    Json inputs = Json::array();
    for (const StoredInput& input : study.inputs)
        inputs.push_back({{"key", input.key}, {"unit", input.unit}, {"count", input.count}});
    return inputs;
}

const char* reading_text(fragility::Reading reading)
{
    if (reading == fragility::Reading::observed) return "observed";
    return reading == fragility::Reading::censored ? "censored" : "none";
}

Json wall_json(const ReportStudy& study, const ReportWall& w)
{
    Json inputs = Json::array();
    for (const StoredInput& input : study.inputs)
        inputs.push_back(shown(shown_value(input, w.row), 5));
    const bool none = w.reading == fragility::Reading::not_defined;
    return {{"level", w.row.key.level},
            {"sample", w.row.key.sample},
            {"mode", w.failed    ? "failed"
                     : w.rocking ? "rocking"
                                 : "mixed"},
            {"reason", w.row.reason},
            {"peak", shown(w.peak * 1e-3, 6)},
            {"peak_at", shown(w.peak_at * 1e3, 5)},
            {"ultimate", none ? Json(nullptr) : shown(w.ultimate * 1e3, 5)},
            {"reading", reading_text(w.reading)},
            {"cracked", w.cracked},
            {"inputs", inputs}};
}

Json walls_json(const ReportStudy& study, const std::vector<std::size_t>& listed)
{
    Json walls = Json::array();
    for (const std::size_t i : listed) walls.push_back(wall_json(study, study.walls[i]));
    return walls;
}

Json provenance_json(const ReportStudy& study)
{
    const StoreHead& head = study.head;
    Json sessions = Json::array();
    for (const StoreSession& s : head.sessions)
        sessions.push_back({{"version", s.program_version},
                            {"machine", s.machine},
                            {"build", s.build},
                            {"settings", s.settings},
                            {"started", s.started}});
    return {{"version", std::string(kVersion)},  {"seed", std::to_string(head.seed)},
            {"shard", head.shard + 1},           {"shards", head.shards},
            {"design_sizes", head.design_sizes}, {"configuration", head.configuration},
            {"unreadable", study.no_study},      {"sessions", sessions}};
}

Json tables_json(const ReportStudy& study, const std::vector<std::size_t>& listed)
{
    Json tables = {table_json("results", "Results by stress and mode", results_table(study)),
                   table_json("fragility", "Ultimate drift", fragility_table(study)),
                   table_json("walls", "Walls", walls_table(study, listed))};
    return tables;
}

Json overview_json(const ReportStudy& study)
{
    const Overview o = overview(study);
    return {{"run", o.run}, {"found", o.found}, {"sure", o.sure}};
}

} // namespace

Json report_data(const ReportStudy& study, const std::vector<std::size_t>& listed)
{
    return {{"name", study.name},
            {"overview", overview_json(study)},
            {"levels", levels_json(study)},
            {"inputs", inputs_json(study)},
            {"height", study.height},
            {"one_way", study.pushed_one_way},
            {"walls", walls_json(study, listed)},
            {"curves", study.pushed_one_way ? curves_json(study, listed) : Json(nullptr)},
            {"means", study.pushed_one_way ? mean_curves_json(study) : Json::array()},
            {"fragility", fragility_json(study)},
            {"modes", modes_json(study)},
            {"histograms", histograms_json(study)},
            {"running", running_json(study)},
            {"sensitivity", sensitivity_json(study)},
            {"tables", tables_json(study, listed)},
            {"provenance", provenance_json(study)}};
}

Json films_json(const ReportStudy& study, const std::vector<std::size_t>& listed,
                const Replay& replay, const std::string& note)
{
    Json films = {{"note", note}, {"films", Json::array()}};
    if (!study.study || replay.walls.empty()) return films;
    films["geometry"] = wall_geometry(model_of(*study.study).layout);
    std::map<std::size_t, const Film*> of_wall;
    for (std::size_t i = 0; i < replay.walls.size(); ++i)
        of_wall[replay.walls[i]] = &replay.films[i];
    for (std::size_t w = 0; w < listed.size(); ++w) {
        const auto film = of_wall.find(listed[w]);
        if (film == of_wall.end()) continue;
        const Film& f = *film->second;
        films["films"].push_back(
            {{"wall", w}, {"frames", f.frames}, {"step", f.step}, {"data", f.data}});
    }
    return films;
}

} // namespace app
