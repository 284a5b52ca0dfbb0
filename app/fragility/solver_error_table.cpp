#include "app/fragility/solver_error_table.hpp"

#include "app/fragility/fragility_means.hpp"
#include "app/fragility/numbers/table_texts.hpp"
#include "app/output/table/cells.hpp"
#include "app/study/answers/solver_error.hpp"
#include "app/study/stored/study_file_head.hpp"
#include "app/text/words.hpp"
#include "core/interval.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace app {
namespace {

/// Mean peak force of a level [kN], and what leaves it open [kN].
struct MeanPeak {
    MeanOf mean;           ///< with the interval of sampling
    double solver = 0.0;   ///< mean of the walls' errors
    double allowed = 0.0;  ///< the part of walls that miss the accuracy
    bool is_known = false; ///< of every wall
};

MeanPeak mean_peak(const StudyWalls& study, const StudyLevel& level)
{
    MeanPeak m;
    m.is_known = true;
    std::vector<double> forces;
    for (const StudyWall& w : level.walls) {
        if (!w.reading.peak) continue;
        const double force = 1e-3 * w.reading.peak->force, error = w.solver_error * force;
        forces.push_back(force);
        m.is_known = m.is_known && std::isfinite(error);
        m.solver += error;
        if (misses_accuracy(w.solver_error, study.study.solver)) m.allowed += error;
    }
    m.mean = mean_of(forces, study.study.fragility.confidence);
    const auto n = static_cast<double>(std::max<std::size_t>(1, forces.size()));
    m.solver /= n;
    m.allowed /= n;
    return m;
}

Number percent_cell(double share) { return plain_number(100.0 * share, 2); }

std::string note_of(const StudyWalls& study, const WallErrors& e, const WallErrors& points,
                    const AuditDifferences& d)
{
    constexpr std::size_t kNamed = 20;
    std::string text;
    const auto add = [&text](const std::string& sentence) {
        text += (text.empty() ? "" : " ") + sentence;
    };
    if (!e.above.empty())
        add("Inaccurate: " + named(study, e.above, kNamed) +
            (e.above.size() > kNamed ? ", ..." : "") + ".");
    if (!points.above.empty())
        add("Too few contact points: " + named(study, points.above, kNamed) +
            (points.above.size() > kNamed ? ", ..." : "") + ".");
    if (e.unknown > 0)
        add("Not known of " + counted(e.unknown, "wall", "walls") +
            ", pushed by an earlier version of the program.");
    if (d.fell_once > 0)
        add("The force of " + counted(d.fell_once, "wall", "walls") +
            " of the audit came down in one of both pushes only.");
    if (d.other_modes > 0)
        add(counted(d.other_modes, "wall", "walls") + " of the audit failed in another mode.");
    if (d.failed > 0)
        add(counted(d.failed, "wall", "walls") +
            " of the audit gave no result in one of both pushes.");
    if (d.missing > 0) add(counted(d.missing, "wall", "walls") + " of the audit still to run.");
    return text;
}

void add_level(const StudyWalls& study, const StudyLevel& level, Table& t)
{
    const WallErrors e = wall_errors(level, &StudyWall::solver_error, study.study.solver),
                     points = wall_errors(level, &StudyWall::points_error, study.study.solver);
    const AuditDifferences d = audit_differences(level);
    const MeanPeak m = mean_peak(study, level);
    const core::Interval& sampling = m.mean.interval;
    add_row(
        t,
        {stress_cell(level.stress), count(level.walls.size()),
         percent_cell(study.study.solver.accuracy), percent_cell(median_error(e.known)),
         percent_cell(upper_error(e.known)), e.known.empty() ? Number{} : count(e.above.size()),
         with_interval(m.mean.value, sampling.lower - m.allowed, sampling.upper + m.allowed, 2),
         percent_cell(0.5 * (sampling.upper - sampling.lower) / m.mean.value),
         percent_cell(m.is_known ? m.solver / m.mean.value : kUnknown), count(d.checked),
         percent_cell(median_error(d.peak)), percent_cell(upper_error(d.peak)),
         percent_cell(median_error(d.ultimate)), percent_cell(upper_error(d.ultimate)),
         percent_cell(median_error(points.known)), percent_cell(upper_error(points.known))},
        note_of(study, e, points, d));
}

} // namespace

Table solver_error_table(const StudyWalls& walls)
{
    Words words = words_of(walls);
    const auto& levels = walls.head.levels;
    const std::uint32_t stored = levels.empty() ? 1 : levels.back().slower;
    words["slower"] = std::to_string(stored > 1 ? stored : kAuditSlower);
    Table t = titled_table("solver_error", words);
    t.head = {"stress [MPa]",
              "walls",
              "asked for [%]",
              "median [%]",
              "95 % of walls below [%]",
              "inaccurate",
              {"mean peak force [kN]", kInterval},
              "sampling [%]",
              "solver [%]",
              "audit",
              "peak, median [%]",
              "peak, 95 % below [%]",
              {"ultimate, median [%]", kDetail},
              "ultimate, 95 % below [%]",
              {"contact points, median [%]", kDetail},
              "contact points, 95 % below [%]",
              {"note", kNote}};
    for (const StudyLevel& level : walls.levels) add_level(walls, level, t);
    return t;
}

} // namespace app
