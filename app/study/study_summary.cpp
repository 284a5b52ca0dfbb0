#include "app/study/study_summary.hpp"

#include "app/output/cells.hpp"
#include "app/study/fragility_text.hpp"
#include "app/study/mode_rule.hpp"
#include "uq/estimates/estimate.hpp"

#include <vector>

namespace app {
namespace {

Number mean_cell(const std::vector<double>& values, double scale)
{
    if (values.empty()) return {};
    if (values.size() == 1) return plain_number(values.front() * scale, 1);
    const uq::Estimate e = uq::estimate_mean(values);
    return with_error(e.value * scale, e.std_error * scale, 1);
}

Number cov_cell(const std::vector<double>& values)
{
    if (values.size() < 2) return {};
    return plain_number(uq::estimate_sd(values).value / uq::estimate_mean(values).value, 2);
}

Row cells(const StudyLevel& level, double confidence)
{
    const std::size_t n = level.walls.size();
    std::size_t rocking = 0, censored = 0;
    std::vector<double> peaks, ultimate;
    for (const StudyWall& w : level.walls) {
        const WallReading& r = w.reading;
        rocking += r.mode == dem::FailureMode::rocking ? 1 : 0;
        // A push that turns back has no reading: its walls are sound, their peaks are not defined.
        if (r.peak) peaks.push_back(r.peak->force);
        if (is_observed(r.ultimate)) ultimate.push_back(r.ultimate.displacement);
        censored += is_censored(r.ultimate) ? 1 : 0;
    }
    Number share;
    if (n > 0) {
        const uq::Estimate p =
            uq::estimate_probability(rocking, n, level.failed_walls.size(), confidence);
        share = with_interval(100.0 * p.value, 100.0 * p.interval.lower,
                              100.0 * p.interval.upper, 0);
    }
    return {given(level.stress * 1e-6),
            count(static_cast<double>(n)),
            count(static_cast<double>(level.failed_walls.size())),
            mean_cell(peaks, 1e-3),
            cov_cell(peaks),
            share,
            mean_cell(ultimate, 1e3),
            count(static_cast<double>(ultimate.size())),
            count(static_cast<double>(censored))};
}

} // namespace

StudySummary summarise(const StudyWalls& walls)
{
    const FragilityInput& f = walls.study.fragility;
    StudySummary s;
    s.table.title = "Results by stress";
    s.table.caption =
        "Walls per vertical stress. Errors are standard errors of independent samples; a Latin "
        "hypercube has less. The " +
        percent_text(f.confidence) +
        " interval counts the failed walls once as rocking and once as mixed. Ultimate: where "
        "the " +
        ultimate_text(f) + ", as the mean of the walls on which that was observed.";
    s.table.head = {"stress [MPa]",
                    "walls",
                    "failed",
                    {"peak [kN]", kError},
                    "COV",
                    {"rocking [%]", kInterval},
                    {"ultimate [mm]", kError},
                    "observed",
                    "censored"};
    for (const StudyLevel& level : walls.levels) {
        s.table.rows.push_back(cells(level, f.confidence));
        s.failed += level.failed_walls.size();
        s.missing += level.missing;
    }
    s.remarks = trouble_text(walls);
    return s;
}

} // namespace app
