#include "app/report/report_tables.hpp"

#include "app/input/number_text.hpp"
#include "uq/estimates/estimate.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace app {
namespace {

std::string with_error(const std::vector<double>& values, double scale, int digits)
{
    if (values.empty()) return {};
    if (values.size() == 1) return fixed(scale * values.front(), digits);
    const uq::Estimate e = uq::estimate_mean(values);
    return fixed(e.value * scale, digits) + " ± " + fixed(e.std_error * scale, digits);
}

std::string cov_text(const std::vector<double>& values)
{
    if (values.size() < 2) return {};
    const uq::Moments m = uq::moments(values);
    return m.mean > 0.0 ? fixed(m.sd / m.mean, 2) : std::string();
}

std::vector<std::string> results_row(const std::string& stress, const char* mode,
                                     const std::vector<const ReportWall*>& walls)
{
    std::vector<double> peaks, at, ultimate;
    std::size_t censored = 0;
    for (const ReportWall* w : walls) {
        if (std::isfinite(w->peak)) peaks.push_back(w->peak);
        if (std::isfinite(w->peak_at)) at.push_back(w->peak_at);
        if (w->reading == fragility::Reading::observed) ultimate.push_back(w->ultimate);
        censored += w->reading == fragility::Reading::censored ? 1 : 0;
    }
    return {stress,
            mode,
            std::to_string(walls.size()),
            with_error(peaks, 1e-3, 1),
            cov_text(peaks),
            with_error(at, 1e3, 1),
            with_error(ultimate, 1e3, 1),
            cov_text(ultimate),
            std::to_string(ultimate.size()),
            std::to_string(censored)};
}

std::string mode_text(const ReportWall& w)
{
    if (w.failed) return "failed: " + w.row.reason;
    return w.rocking ? "rocking" : "mixed";
}

std::string ultimate_text(const ReportWall& w)
{
    if (w.reading == fragility::Reading::not_defined) return {};
    return (w.reading == fragility::Reading::censored ? "> " : "") + fixed(w.ultimate * 1e3, 2);
}

} // namespace

nlohmann::ordered_json table_json(const std::string& id, const std::string& title,
                                  const Table& table)
{
    return {{"id", id},
            {"title", title},
            {"caption", table.caption},
            {"head", table.head},
            {"rows", table.rows},
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
    t.head = {"stress [MPa]", "mode",          "walls", "peak [kN]", "COV",
              "at peak [mm]", "ultimate [mm]", "COV",   "observed",  "censored"};
    for (std::size_t level = 0; level < study.head.levels.size(); ++level) {
        const std::string stress = number(study.stress(level), 12);
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
    t.head = {"stress [MPa]", "sample", "mode", "peak [kN]", "ultimate [mm]", "cracked units"};
    for (const StoredInput& input : study.inputs)
        t.head.push_back((input.count > 1 ? "mean " : "") + input.key + " [" + input.unit +
                         "]");
    for (const std::size_t i : listed) {
        const ReportWall& w = study.walls[i];
        std::vector<std::string> row = {number(study.stress(w.row.key.level), 12),
                                        std::to_string(w.row.key.sample),
                                        mode_text(w),
                                        fixed(w.peak * 1e-3, 2),
                                        ultimate_text(w),
                                        w.failed ? "" : std::to_string(w.cracked)};
        for (const StoredInput& input : study.inputs)
            row.push_back(number(shown_value(input, w.row), 5));
        t.rows.push_back(row);
    }
    return t;
}

} // namespace app
