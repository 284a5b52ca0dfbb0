#include "app/fragility/fragility_means.hpp"

#include "app/input/number_text.hpp"
#include "app/study/fragility_text.hpp"
#include "fragility/binomial.hpp"
#include "fragility/performance_limits.hpp"
#include "uq/estimates/estimate.hpp"

#include <algorithm>
#include <cmath>

namespace app {
namespace {

std::vector<const StudyWall*> walls_of(const StudyLevel& level, int mode)
{
    std::vector<const StudyWall*> found;
    for (const StudyWall& w : level.walls)
        if (w.mode == mode) found.push_back(&w);
    return found;
}

/// "16.2 +- 0.3"; of one wall its value, without an error.
std::string mean_cell(const std::vector<double>& values, int decimals)
{
    const auto sound = uq::sound_values(values).values;
    if (sound.empty()) return {};
    if (sound.size() == 1) return fixed(sound.front(), decimals) + " (1 wall)";
    const uq::Estimate e = uq::estimate_mean(sound);
    return with_error(e.value, e.std_error, decimals);
}

/// Mean of where runs ended, a bound: it has no standard error.
std::string ended_cell(const std::vector<double>& ends)
{
    if (ends.empty()) return {};
    double sum = 0.0;
    for (const double end : ends) sum += end;
    return "> " + rounded_down(sum / static_cast<double>(ends.size()), 2);
}

/// Displacements of a mode, apart by whether they are the wall's or the end of its run [mm].
struct Displacements {
    std::vector<double> observed, censored;
    std::vector<fragility::Observation> all;
};

Displacements displacements(const std::vector<const StudyWall*>& walls)
{
    Displacements d;
    for (const StudyWall* w : walls) {
        const auto limit = fragility::observation(w->ultimate, 1e3);
        if (!limit) continue;
        d.all.push_back(*limit);
        const bool observed = w->ultimate.reading == fragility::Reading::observed;
        (observed ? d.observed : d.censored).push_back(w->ultimate.displacement * 1e3);
    }
    return d;
}

/// Median of observed and censored displacements together.
std::string median_cell(const StudyWalls& walls, const Displacements& d)
{
    if (d.all.empty()) return {};
    const FragilityInput& f = walls.study.fragility;
    const auto limits = fragility::performance_limits(f.law, d.all, f.confidence);
    if (limits.fitted)
        return with_interval(limits.drifts[2].drift, limits.drifts[2].interval, 1,
                             known_to(d.all));
    const std::string bound = median_bound(limits.bound, 1);
    return "not identifiable" + (bound.empty() ? "" : ": " + bound);
}

std::vector<std::string> mean_row(const StudyWalls& walls, const StudyLevel& level, int mode)
{
    const auto group = walls_of(level, mode);
    const std::size_t n = level.walls.size();
    std::vector<std::string> row = {number(level.stress * 1e-6, 12),
                                    std::to_string(group.size())};
    if (group.empty()) {
        row.push_back(n == 0 ? "no wall gave a result" : "mode does not occur");
        row.resize(walls.inputs.size() + 9);
        return row;
    }
    const auto share =
        fragility::share(static_cast<double>(group.size()), static_cast<double>(n),
                         static_cast<double>(level.failed), fragility::BinomialInterval::wilson,
                         walls.study.fragility.confidence);
    row.push_back(with_interval(100.0 * share.value, 100.0 * share.bounds.lower,
                                100.0 * share.bounds.upper, 0));
    for (std::size_t i = 0; i < walls.inputs.size(); ++i) {
        std::vector<double> values;
        for (const StudyWall* w : group) values.push_back(w->inputs[i]);
        row.push_back(mean_cell(values, walls.inputs[i].unit == "deg" ? 2 : 3));
    }
    std::vector<double> force;
    for (const StudyWall* w : group) force.push_back(w->peak_force * 1e-3);
    row.push_back(mean_cell(force, 2));
    const Displacements d = displacements(group);
    row.push_back(d.observed.empty() ? "none observed" : mean_cell(d.observed, 2));
    row.push_back(std::to_string(d.observed.size()));
    row.push_back(ended_cell(d.censored));
    row.push_back(std::to_string(d.censored.size()));
    row.push_back(median_cell(walls, d));
    return row;
}

/// As mean_row's cells of force and displacement: "> " marks runs that ended before a drop.
std::pair<std::string, std::string> both_cells(const StudyLevel& level, int mode)
{
    const auto group = walls_of(level, mode);
    if (group.empty()) return {level.walls.empty() ? "no wall" : "does not occur", ""};
    std::vector<double> force;
    for (const StudyWall* w : group) force.push_back(w->peak_force * 1e-3);
    const Displacements d = displacements(group);
    std::string displacement =
        d.observed.empty() ? ended_cell(d.censored) : mean_cell(d.observed, 2);
    if (!d.observed.empty() && !d.censored.empty())
        displacement += ", " + std::to_string(d.censored.size()) + " censored";
    if (d.all.empty()) displacement = "not defined";
    return {mean_cell(force, 2), displacement};
}

std::string counts(const StudyWalls& walls) { return counts_text(drift_data(walls)); }

} // namespace

Table mean_table(const StudyWalls& walls, int mode)
{
    Table t;
    t.caption =
        std::string(mode == kRocking ? "Rocking" : "Mixed mode") +
        ": means +- standard errors per vertical stress (layout of the paper's Table " +
        (mode == kRocking ? "6" : "7") + "). " + counts(walls) + ". Share of the mode with a " +
        percent_text(walls.study.fragility.confidence) +
        " interval that counts failed walls either way. Displacement: of the load line "
        "where the force first falls to 80 % of the peak; mean of the walls on which "
        "that was observed. Runs that ended before are right-censored: \"run ended\" is "
        "the mean of where they were stopped, a lower bound and no capacity (what the "
        "paper's Table 6 gives as displacement of rocking walls). Median: of both "
        "together, censored maximum likelihood, " +
        std::string(name(walls.study.fragility.law)) + " law (" +
        extrapolated_text("any of these walls") +
        "); without a fit, a bound without any law. Standard errors are those of independent "
        "samples. Inputs with values per joint: mean over the joints.";
    t.head = {"stress [MPa]", "n", "share [%]"};
    for (const StoredInput& i : walls.inputs) t.head.push_back(i.key + " [" + i.unit + "]");
    for (const char* const h : {"peak force [kN]", "displacement [mm]", "observed",
                                "run ended [mm]", "censored", "median displacement [mm]"})
        t.head.emplace_back(h);
    for (const StudyLevel& level : walls.levels) t.rows.push_back(mean_row(walls, level, mode));
    return t;
}

Table both_modes_table(const StudyWalls& walls)
{
    Table t;
    const bool spatial = walls.study.uq.spatial != Spatial::none;
    t.caption =
        std::string("Mean peak force and displacement of both modes (layout of the "
                    "paper's Table 8)") +
        (spatial ? "; *: values vary from joint to joint" : "") + ". " + counts(walls) +
        ". Displacement as in the tables of the modes: mean of the walls observed to fall "
        "to 80 % of the peak; \">\": none was, mean of where the runs ended, a lower "
        "bound.";
    t.head = {"stress [MPa]", "rocking force [kN]", "rocking displacement [mm]",
              "mixed force [kN]", "mixed displacement [mm]"};
    for (const StudyLevel& level : walls.levels) {
        const auto [rf, rd] = both_cells(level, kRocking);
        const auto [mf, md] = both_cells(level, kMixed);
        t.rows.push_back(
            {number(level.stress * 1e-6, 12) + (spatial ? "*" : ""), rf, rd, mf, md});
    }
    return t;
}

} // namespace app
