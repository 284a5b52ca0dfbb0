#include "app/fragility/fragility_means.hpp"

#include "app/fragility/numbers/table_texts.hpp"
#include "app/study/answers/fragility_text.hpp"
#include "app/study/answers/mean_cells.hpp"
#include "app/study/answers/mode_share.hpp"
#include "uq/estimates/estimate.hpp"

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

void add_means(const StudyWalls& walls, const StudyLevel& level, int mode, Table& t)
{
    const WallList group = walls_of(level, mode);
    Row row = {stress_cell(level.stress), mode_name(mode), count(group.size())};
    if (group.empty())
        return add_row(t, row,
                       level.walls.empty() ? "No wall gave a result."
                                           : "The mode does not occur.");
    const double confidence = walls.study.fragility.confidence;
    const fragility::Share share = mode_share(level, mode, confidence);
    row.emplace_back(percent(share.value, share.interval, 0));
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
                       ended, count(d.censored.size()), median_cell(d.all, confidence, 1)}));
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
                                 {"displacement of walls that fell [mm]", kError},
                                 "COV of displacement",
                                 "observed",
                                 "mean end of censored runs [mm]",
                                 "censored",
                                 {"median displacement [mm]", kInterval | kCensored},
                                 {"note", kNote}});
    for (const int mode : modes_of(walls))
        for (const StudyLevel& level : walls.levels) add_means(walls, level, mode, t);
    return t;
}

} // namespace app
