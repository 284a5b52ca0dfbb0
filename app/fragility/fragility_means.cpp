#include "app/fragility/fragility_means.hpp"

#include "app/fragility/drift_fits.hpp"
#include "app/fragility/table_texts.hpp"
#include "app/study/fragility_text.hpp"
#include "app/study/mean_cells.hpp"
#include "fragility/binomial.hpp"
#include "fragility/observed_quantile.hpp"
#include "fragility/performance_limits.hpp"
#include "uq/estimates/estimate.hpp"

#include <array>
#include <numeric>

namespace app {
namespace {

/// Displacements of a mode, apart by whether they are the wall's or the end of its run [mm].
struct Displacements {
    std::vector<double> observed, censored;
    std::vector<fragility::Observation> all;
};

Displacements displacements(const WallList& walls)
{
    Displacements d;
    for (const StudyWall* w : walls) {
        const auto limit = fragility::observation(w->reading.ultimate, 1e3);
        if (!limit) continue;
        d.all.push_back(*limit);
        (is_observed(w->reading.ultimate) ? d.observed : d.censored)
            .push_back(w->reading.ultimate.displacement * 1e3);
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
    const auto group = static_cast<std::size_t>(&level - walls.levels.data());
    if (rejected(judged(drift_options(walls.study), f.law, d.all, group))) {
        const std::array half = {0.5};
        const auto median = fragility::observed_quantiles(d.all, half, f.confidence).front();
        if (!median.value) return median_bound(limits.bound, 1);
        return with_interval(*median.value, median.interval, 1);
    }
    return with_interval(limits.drifts[2].drift, limits.drifts[2].interval, 1, known_to(d.all));
}

void add_means(const StudyWalls& walls, const StudyLevel& level, int mode, Table& t)
{
    const WallList group = walls_of(level, mode);
    Row row = {stress_cell(level.stress), mode_name(mode), count(group.size())};
    if (group.empty())
        return add_row(t, row,
                       level.walls.empty() ? "No wall gave a result."
                                           : "The mode does not occur.");
    const auto share = fragility::share(
        static_cast<double>(group.size()), static_cast<double>(level.walls.size()),
        static_cast<double>(level.failed_walls.size()), fragility::BinomialInterval::wilson,
        walls.study.fragility.confidence);
    row.emplace_back(percent(share.value, share.bounds, 0));
    const auto values_of = [&](auto value) {
        std::vector<double> values;
        for (const StudyWall* w : group) values.push_back(value(*w));
        return values;
    };
    for (std::size_t i = 0; i < walls.inputs.size(); ++i)
        row.emplace_back(mean_cell(values_of([i](const StudyWall& w) { return w.inputs[i]; }),
                                   walls.inputs[i].unit == "deg" ? 2 : 3));
    const auto force =
        values_of([](const StudyWall& w) { return peak_force(w.reading) * 1e-3; });
    const auto at_peak =
        values_of([](const StudyWall& w) { return peak_displacement(w.reading) * 1e3; });
    const Displacements d = displacements(group);
    // The mean of where runs ended is a bound: it has no standard error.
    const Number ended = {
        .value = plain_mean(d.censored), .decimals = 2, .sense = Sense::above};
    add_row(t, joined(row,
                      {mean_cell(force, 2), cov_cell(force), mean_cell(at_peak, 2),
                       mean_cell(d.observed, 2), cov_cell(d.observed), count(d.observed.size()),
                       ended, count(d.censored.size()), median_cell(walls, level, d)}));
}

} // namespace

MeanOf mean_of(const std::vector<double>& values, double confidence)
{
    if (values.empty()) return {};
    if (values.size() == 1) return {.value = values.front()};
    const uq::Estimate e = uq::estimate_mean(values, confidence);
    return {e.value, {e.interval.lower, e.interval.upper, confidence}};
}

double plain_mean(const std::vector<double>& values)
{
    return std::accumulate(values.begin(), values.end(), 0.0) /
           static_cast<double>(values.size());
}

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
        for (const StudyLevel& level : walls.levels) add_means(walls, level, mode, t);
    return t;
}

} // namespace app
