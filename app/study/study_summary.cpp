#include "app/study/study_summary.hpp"

#include "app/output/table/cells.hpp"
#include "app/study/answers/fragility_text.hpp"
#include "app/study/answers/limit_choices.hpp"
#include "app/study/answers/mean_cells.hpp"
#include "app/study/answers/mode_rule.hpp"
#include "app/study/answers/mode_share.hpp"
#include "app/study/answers/number_cells.hpp"
#include "app/study/answers/pier_shares.hpp"
#include "app/study/answers/solver_error.hpp"
#include "app/study/stored/turned_walls.hpp"

#include <string>
#include <vector>

namespace app {
namespace {

Row cells(const StudyLevel& level, const dem::SolverOptions& solver,
          const FragilityInput& fragility, const std::vector<int>& modes)
{
    const double confidence = fragility.confidence;
    const std::size_t n = level.walls.size();
    std::size_t censored = 0;
    std::vector<double> peaks;
    std::vector<fragility::Observation> ultimate; // [mm]
    for (const StudyWall& w : level.walls) {
        const WallReading& r = w.reading;
        if (r.peak) peaks.push_back(r.peak->force);
        if (const auto limit = fragility::observation(r.ultimate, 1e3))
            ultimate.push_back(*limit);
        censored += is_censored(r.ultimate) ? 1 : 0;
    }
    const auto share = [&](int mode) -> Number {
        if (n == 0) return {};
        const fragility::Share s = mode_share(level, mode, confidence);
        return percent(s.value, s.interval, 0);
    };
    Row row = {stress_cell(level.stress), count(n), count(level.failed_walls.size()),
               mean_cell(peaks, 1, 1e-3), cov_cell(peaks)};
    for (const int mode : modes) row.emplace_back(share(mode));
    const WallErrors errors = wall_errors(level, &StudyWall::solver_error, solver);
    return joined(row, {median_cell(ultimate, confidence, 1), count(ultimate.size() - censored),
                        count(censored), plain_number(100.0 * median_error(errors.known), 2),
                        plain_number(100.0 * upper_error(errors.known), 2),
                        errors.known.empty() ? Number{} : count(errors.above.size())});
}

} // namespace

StudySummary summarise(const StudyWalls& walls)
{
    const FragilityInput& f = walls.study.fragility;
    StudySummary s;
    s.table.title = kSummaryTitle;
    s.table.caption =
        "Walls per vertical stress. Errors are standard errors of independent samples; those "
        "of a Latin hypercube are smaller. The " +
        percent_text(f.confidence) + " interval of a share holds " + whatever_mode_text(f) +
        ". "
        "Ultimate: where the " +
        ultimate_text(f) +
        ", as the median of all walls (Kaplan and Meier) with its interval; censored walls had "
        "not come down so far when their push ended, and where less than half did, \">=\" "
        "gives "
        "the largest displacement tested. Solver error: median over the walls of what each "
        "push "
        "estimates for its peak force, and what 95 % of them lie below (of fewer than 20 walls "
        "the largest); inaccurate: walls above the " +
        error_text(walls.study.solver.accuracy) + " asked for (solver.accuracy)." +
        backbone_text(walls.study.load, walls.study.fragility);
    s.table.head = {"stress [MPa]", "walls", "failed",
                    number_head(wall_number("peak_force"), kError), "COV"};
    const std::vector<int> modes = modes_of(walls);
    for (const int mode : modes)
        s.table.head.emplace_back(std::string(mode_name(mode)) + " [%]", kInterval);
    s.table.head.insert(s.table.head.end(), {number_head(wall_number("ultimate_displacement"),
                                                         kInterval | kCensored),
                                             "observed",
                                             "censored",
                                             number_head(wall_number("solver_error")),
                                             {"solver error of 95 % [%]", kProgramsOnly},
                                             "inaccurate"});
    for (const StudyLevel& level : walls.levels) {
        s.table.rows.push_back(cells(level, walls.study.solver, walls.study.fragility, modes));
        s.failed += level.failed_walls.size();
        s.missing += level.missing;
    }
    for (const std::string& none : {no_limit_remark(walls), no_yield_remark(walls)})
        if (!none.empty()) s.table.caption += " " + none;
    s.remarks = study_remarks(walls);
    return s;
}

std::string study_remarks(const StudyWalls& walls)
{
    std::string text = trouble_text(walls);
    for (const std::string& remark :
         {solver_error_text(walls), no_limit_remark(walls), no_yield_remark(walls),
          other_way_remark(walls), pier_sentence(walls)})
        if (!remark.empty()) text += remark + "\n";
    return text;
}

} // namespace app
