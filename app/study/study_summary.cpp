#include "app/study/study_summary.hpp"

#include "app/output/cells.hpp"
#include "app/study/fragility_text.hpp"
#include "app/study/limit_choices.hpp"
#include "app/study/mean_cells.hpp"
#include "app/study/mode_rule.hpp"
#include "app/study/other_way.hpp"
#include "uq/estimates/estimate.hpp"

#include <array>
#include <string>
#include <vector>

namespace app {
namespace {

Row cells(const StudyLevel& level, const std::vector<int>& modes, double confidence)
{
    const std::size_t n = level.walls.size();
    std::size_t censored = 0;
    std::array<std::size_t, 3> of_mode{};
    std::vector<double> peaks, ultimate;
    for (const StudyWall& w : level.walls) {
        const WallReading& r = w.reading;
        ++of_mode[mode_of(w)];
        if (r.peak) peaks.push_back(r.peak->force);
        if (is_observed(r.ultimate)) ultimate.push_back(r.ultimate.displacement);
        censored += is_censored(r.ultimate) ? 1 : 0;
    }
    const auto share = [&](int mode) -> Number {
        if (n == 0) return {};
        const uq::Estimate p =
            uq::estimate_probability(of_mode[mode], n, level.failed_walls.size(), confidence);
        return percent(p.value, p.interval, 0);
    };
    Row row = {stress_cell(level.stress), count(n), count(level.failed_walls.size()),
               mean_cell(peaks, 1, 1e-3), cov_cell(peaks)};
    for (const int mode : modes)
        if (mode != kMixed) row.emplace_back(share(mode));
    return joined(row, {mean_cell(ultimate, 1, 1e3), count(ultimate.size()), count(censored)});
}

} // namespace

StudySummary summarise(const StudyWalls& walls)
{
    const FragilityInput& f = walls.study.fragility;
    StudySummary s;
    s.table.title = kSummaryTitle;
    s.table.caption = "Walls per vertical stress. Errors are standard errors of independent "
                      "samples; those of a "
                      "Latin hypercube are smaller. The " +
                      percent_text(f.confidence) +
                      " interval of a share holds whether the failed walls were of that mode "
                      "or not. Ultimate: "
                      "where the " +
                      ultimate_text(f) +
                      ", as the mean of the walls on which that was observed." +
                      backbone_text(walls.study);
    s.table.head = {"stress [MPa]", "walls", "failed", {"peak [kN]", kError}, "COV"};
    const std::vector<int> modes = modes_of(walls);
    for (const int mode : modes)
        if (mode != kMixed)
            s.table.head.emplace_back(mode_name(mode) + std::string(" [%]"), kInterval);
    s.table.head.insert(s.table.head.end(),
                        {{"ultimate [mm]", kError}, "observed", "censored"});
    for (const StudyLevel& level : walls.levels) {
        s.table.rows.push_back(cells(level, modes, f.confidence));
        s.failed += level.failed_walls.size();
        s.missing += level.missing;
    }
    s.remarks = trouble_text(walls);
    if (const std::string none = no_limit_remark(walls); !none.empty()) {
        s.table.caption += " " + none;
        s.remarks += none + "\n";
    }
    if (const std::string other = other_way_remark(walls); !other.empty())
        s.remarks += other + "\n";
    return s;
}

} // namespace app
