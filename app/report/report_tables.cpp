#include "app/report/report_tables.hpp"

#include "app/output/cells.hpp"
#include "uq/estimates/estimate.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace app {
namespace {

Number mean_cell(const std::vector<double>& values, double scale)
{
    if (values.empty()) return {};
    if (values.size() == 1) return plain_number(scale * values.front(), 1);
    const uq::Estimate e = uq::estimate_mean(values);
    return with_error(e.value * scale, e.std_error * scale, 1);
}

Number cov_cell(const std::vector<double>& values)
{
    if (values.size() < 2) return {};
    const uq::Moments m = uq::moments(values);
    return m.mean > 0.0 ? plain_number(m.sd / m.mean, 2) : Number{};
}

Row results_row(double stress, const char* mode, const std::vector<const ReportWall*>& walls)
{
    std::vector<double> peaks, at, ultimate;
    std::size_t censored = 0;
    for (const ReportWall* w : walls) {
        if (std::isfinite(w->peak)) peaks.push_back(w->peak);
        if (std::isfinite(w->peak_at)) at.push_back(w->peak_at);
        if (w->reading == fragility::Reading::observed) ultimate.push_back(w->ultimate);
        censored += w->reading == fragility::Reading::censored ? 1 : 0;
    }
    return {given(stress),
            mode,
            count(static_cast<double>(walls.size())),
            mean_cell(peaks, 1e-3),
            cov_cell(peaks),
            mean_cell(at, 1e3),
            mean_cell(ultimate, 1e3),
            cov_cell(ultimate),
            count(static_cast<double>(ultimate.size())),
            count(static_cast<double>(censored))};
}

std::string mode_text(const ReportWall& w)
{
    if (w.failed) return "failed: " + w.row.reason;
    return w.rocking ? "rocking" : "mixed";
}

Number ultimate_cell(const ReportWall& w)
{
    if (w.reading == fragility::Reading::not_defined) return {};
    const bool censored = w.reading == fragility::Reading::censored;
    return {.value = w.ultimate * 1e3,
            .decimals = 2,
            .sense = censored ? Sense::above : Sense::equal};
}

} // namespace

nlohmann::ordered_json table_json(const std::string& id, const std::string& title,
                                  const Table& table)
{
    const ShownTable people = shown(table);
    std::string caption = table.caption;
    for (const std::string& note : people.notes) caption += " " + note;
    return {{"id", id},
            {"title", title},
            {"caption", caption},
            {"head", people.head},
            {"rows", people.rows},
            {"text", as_text(table)},
            {"csv", as_csv(table)},
            {"markdown", as_markdown(table)},
            {"latex", as_latex(table)}};
}

Table results_table(const ReportStudy& study)
{
    Table t;
    t.caption =
        "Means with standard errors of independent samples (a Latin hypercube has less) and "
        "coefficients of variation. Ultimate: where the force first comes down to 80 % of "
        "the peak, of the walls in which that was observed; censored walls had not come "
        "down when their push ended.";
    t.head = {"stress [MPa]",
              "mode",
              "walls",
              {"peak [kN]", kError},
              "COV of peak",
              {"at peak [mm]", kError},
              {"ultimate [mm]", kError},
              "COV of ultimate",
              "observed",
              "censored"};
    for (std::size_t level = 0; level < study.head.levels.size(); ++level) {
        const double stress = study.stress(level);
        const auto all = study.sound(level);
        t.rows.push_back(results_row(stress, "all", all));
        for (const bool rocking : {true, false}) {
            std::vector<const ReportWall*> walls;
            std::copy_if(all.begin(), all.end(), std::back_inserter(walls),
                         [&](const ReportWall* w) { return w->rocking == rocking; });
            if (!walls.empty())
                t.rows.push_back(results_row(stress, rocking ? "rocking" : "mixed", walls));
        }
    }
    return t;
}

Table walls_table(const ReportStudy& study, const std::vector<std::size_t>& listed)
{
    Table t;
    t.caption = "Every wall. \">\": not reached when the push ended.";
    if (study.walls.size() > listed.size())
        t.caption = std::to_string(listed.size()) + " of " +
                    std::to_string(study.walls.size()) +
                    " walls, those of the lowest sample numbers under each stress. \">\": not "
                    "reached when the push ended. drystone curves gives all.";
    t.head = {"stress [MPa]", "sample", "mode", "peak [kN]", {"ultimate [mm]", kCensored},
              "cracked units"};
    for (const StoredInput& input : study.inputs)
        t.head.emplace_back((input.count > 1 ? "mean " : "") + input.key + " [" + input.unit +
                            "]");
    for (const std::size_t i : listed) {
        const ReportWall& w = study.walls[i];
        Row row = {given(study.stress(w.row.key.level)),
                   count(w.row.key.sample),
                   mode_text(w),
                   plain_number(w.peak * 1e-3, 2),
                   ultimate_cell(w),
                   w.failed ? Number{} : count(static_cast<double>(w.cracked))};
        for (const StoredInput& input : study.inputs) {
            const double value = shown_value(input, w.row);
            row.emplace_back(plain_number(value, decimals_for(value) + 2));
        }
        t.rows.push_back(row);
    }
    return t;
}

} // namespace app
