#include "app/fragility/fragility_means.hpp"

#include "app/fragility/drift_fits.hpp"
#include "app/fragility/table_texts.hpp"
#include "app/study/fragility_text.hpp"
#include "fragility/binomial.hpp"
#include "fragility/observed_quantile.hpp"
#include "fragility/performance_limits.hpp"
#include "uq/estimates/estimate.hpp"

#include <array>
#include <numeric>

namespace app {
namespace {

std::vector<const StudyWall*> walls_of(const StudyLevel& level, int mode)
{
    std::vector<const StudyWall*> found;
    for (const StudyWall& w : level.walls)
        if (mode_of(w) == mode) found.push_back(&w);
    return found;
}

/// Mean of the sound values with its standard error, which one value has not.
Number mean_cell(const std::vector<double>& values, int decimals)
{
    const auto sound = uq::sound_values(values).values;
    if (sound.empty()) return {};
    if (sound.size() == 1) return plain_number(sound.front(), decimals);
    const uq::Estimate e = uq::estimate_mean(sound);
    return with_error(e.value, e.std_error, decimals);
}

Number cov_cell(const std::vector<double>& values)
{
    const auto sound = uq::sound_values(values).values;
    if (sound.size() < 2) return {};
    const uq::Moments m = uq::moments(sound);
    return m.mean > 0.0 ? plain_number(m.sd / m.mean, 2) : Number{};
}

/// Mean of where runs ended, a bound: it has no standard error.
Number ended_cell(const std::vector<double>& ends)
{
    if (ends.empty()) return {};
    const double sum = std::accumulate(ends.begin(), ends.end(), 0.0);
    return {
        .value = sum / static_cast<double>(ends.size()), .decimals = 2, .sense = Sense::above};
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
        const auto limit = fragility::observation(w->reading.ultimate, 1e3);
        if (!limit) continue;
        d.all.push_back(*limit);
        const bool observed = w->reading.ultimate.reading == fragility::Reading::observed;
        (observed ? d.observed : d.censored).push_back(w->reading.ultimate.displacement * 1e3);
    }
    return d;
}

/// Median of observed and censored displacements together.
Number median_cell(const StudyWalls& walls, const StudyLevel& level, const Displacements& d)
{
    if (d.all.empty()) return {};
    const FragilityInput& f = walls.study.fragility;
    const auto limits = fragility::performance_limits(f.law, d.all, f.confidence);
    if (!limits.fitted) return median_bound(limits.bound, 1);
    const DriftOptions options{f.law, f.confidence, static_cast<std::size_t>(f.bootstrap),
                               walls.study.uq.seed};
    const auto group = static_cast<std::size_t>(&level - walls.levels.data());
    if (rejected(judged(options, f.law, d.all, group))) {
        const std::array half = {0.5};
        const auto median = fragility::observed_quantiles(d.all, half, f.confidence).front();
        if (!median.value) return median_bound(limits.bound, 1);
        return with_interval(*median.value, median.interval, 1);
    }
    return with_interval(limits.drifts[2].drift, limits.drifts[2].interval, 1, known_to(d.all));
}

Row mean_row(const StudyWalls& walls, const StudyLevel& level, int mode, std::size_t columns)
{
    const auto group = walls_of(level, mode);
    const auto n = static_cast<double>(group.size());
    Row row = {given(level.stress / 1e6), mode_name(mode), count(n)};
    if (group.empty()) {
        row.resize(columns);
        row.back() =
            level.walls.empty() ? "No wall gave a result." : "The mode does not occur.";
        return row;
    }
    const auto share =
        fragility::share(n, static_cast<double>(level.walls.size()),
                         static_cast<double>(level.failed_walls.size()),
                         fragility::BinomialInterval::wilson, walls.study.fragility.confidence);
    row.emplace_back(with_interval(100.0 * share.value, 100.0 * share.bounds.lower,
                                   100.0 * share.bounds.upper, 0));
    for (std::size_t i = 0; i < walls.inputs.size(); ++i) {
        std::vector<double> values;
        for (const StudyWall* w : group) values.push_back(w->inputs[i]);
        row.emplace_back(mean_cell(values, walls.inputs[i].unit == "deg" ? 2 : 3));
    }
    std::vector<double> force;
    for (const StudyWall* w : group) force.push_back(peak_force(w->reading) * 1e-3);
    std::vector<double> at_peak;
    for (const StudyWall* w : group) at_peak.push_back(peak_displacement(w->reading) * 1e3);
    const Displacements d = displacements(group);
    row.insert(row.end(), {mean_cell(force, 2),
                           cov_cell(force),
                           mean_cell(at_peak, 2),
                           mean_cell(d.observed, 2),
                           cov_cell(d.observed),
                           count(static_cast<double>(d.observed.size())),
                           ended_cell(d.censored),
                           count(static_cast<double>(d.censored.size())),
                           median_cell(walls, level, d),
                           {}});
    return row;
}

} // namespace

Table mean_table(const StudyWalls& walls)
{
    Table t = titled_table("means_by_mode", words_of(walls));
    t.keys = 2;
    t.head = {"stress [MPa]", "mode", "n", {"share [%]", kInterval}};
    for (const StoredInput& i : walls.inputs)
        t.head.emplace_back(i.key + " [" + i.unit + "]", kError);
    t.head.insert(t.head.end(), {{"peak force [kN]", kError},
                                 "COV of peak force",
                                 {"displacement at the peak [mm]", kError},
                                 {"displacement [mm]", kError},
                                 "COV of displacement",
                                 "observed",
                                 "mean end of censored runs [mm]",
                                 "censored",
                                 {"median displacement [mm]", kInterval | kExtrapolated},
                                 {"note", kNote}});
    for (const int mode : modes_of(walls))
        for (const StudyLevel& level : walls.levels)
            t.rows.push_back(mean_row(walls, level, mode, t.head.size()));
    return t;
}

} // namespace app
