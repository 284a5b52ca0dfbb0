#include "bench/cyclic/study_tables.hpp"

#include "app/fragility/numbers/drift_fits.hpp"
#include "app/fragility/numbers/fragility_data.hpp"
#include "app/fragility/numbers/limit_drifts.hpp"
#include "app/output/table/cells.hpp"
#include "app/study/answers/fragility_text.hpp"
#include "bench/validation/cells.hpp"
#include "uq/estimates/estimate.hpp"

#include <cmath>
#include <map>
#include <string>
#include <vector>

namespace bench {
namespace {

/// Median drift of a limit state, as the tables of `drystone fragility` have it; a lower bound
/// where it lies beyond the drift that was tested.
app::Number median_cell(const app::DriftData& data, std::size_t group, std::size_t state)
{
    constexpr std::size_t kMedian = 2;
    const auto drifts = app::limit_drifts(data, group, state).quantiles.at;
    if (drifts.empty()) return {};
    const fragility::LimitQuantile& median = drifts[kMedian];
    const bool cap = median.interval.lower == median.interval.upper; // of a code: no interval
    return cap ? app::Number{.value = median.interval.lower, .decimals = 2}
               : app::quantile_cell(median, 2);
}

double seen(const app::DriftGroup& group, std::size_t state)
{
    double n = 0.0;
    for (const fragility::Observation& o : app::limits_of(group, state))
        n += o.lower == o.upper;
    return n;
}

std::map<std::uint32_t, const app::StudyWall*> by_sample(const app::StudyLevel& level)
{
    std::map<std::uint32_t, const app::StudyWall*> walls;
    for (const app::StudyWall& w : level.walls) walls[w.key.sample] = &w;
    return walls;
}

/// Geometric mean of the drifts under cycles over those one way, of the walls on which both
/// were observed.
app::Row ratio_cells(const app::StudyLevel& one, const app::StudyLevel& cyclic,
                     std::size_t state)
{
    const auto others = by_sample(cyclic);
    std::vector<double> logs;
    for (const app::StudyWall& w : one.walls) {
        const auto other = others.find(w.key.sample);
        if (other == others.end()) continue;
        const auto &a = w.reading.limits[state], &b = other->second->reading.limits[state];
        if (is_observed(a) && is_observed(b) && a.displacement > 0.0 && b.displacement > 0.0)
            logs.push_back(std::log(b.displacement / a.displacement));
    }
    const app::Number n = app::count(logs.size());
    if (logs.size() < 2) return {app::Number{}, n};
    const uq::Estimate e = uq::estimate_mean(logs);
    return {app::with_interval(std::exp(e.value), std::exp(e.interval.lower),
                               std::exp(e.interval.upper), 2),
            n};
}

app::Number peak_cell(const app::StudyLevel& level)
{
    std::vector<double> peaks;
    for (const app::StudyWall& w : level.walls)
        if (w.reading.peak) peaks.push_back(w.reading.peak->force * 1e-3);
    if (peaks.size() < 2) return {};
    const uq::Estimate e = uq::estimate_mean(peaks);
    return app::with_interval(e.value, e.interval, 1);
}

} // namespace

app::Table limit_table(const TwoStudies& both)
{
    app::DriftData one = app::drift_data(both.one_way), cyclic = app::drift_data(both.cyclic);
    for (app::DriftData* const data : {&one, &cyclic}) app::judge(*data);
    app::Table t;
    t.caption =
        "Median drifts [%] with 95 % intervals, as drystone fragility reads them; \">\": "
        "beyond the drift tested. Seen: number of walls that reached the limit state. Ratio: "
        "drift under cycles over the drift of the same wall pushed one way, as geometric mean "
        "with its 95 % interval over the walls on which both were seen. SLO and SLD are read "
        "only if the first amplitude lies within yield.";
    t.keys = 2;
    t.head = {"stress [MPa]",
              "limit state",
              {"one way [%]", app::kInterval},
              "seen",
              {"cycles [%]", app::kInterval},
              "seen",
              {"ratio", app::kInterval},
              "n"};
    for (std::size_t g = 0; g < one.groups.size(); ++g)
        for (std::size_t s = 0; s < one.states.size(); ++s) {
            app::Row row = {
                app::group_cell(one.groups[g]), app::state_name(one.states[s]),
                median_cell(one, g, s),         app::count(seen(one.groups[g], s)),
                median_cell(cyclic, g, s),      app::count(seen(cyclic.groups[g], s))};
            const app::Row ratio =
                ratio_cells(both.one_way.levels[g], both.cyclic.levels[g], s);
            row.insert(row.end(), ratio.begin(), ratio.end());
            t.rows.push_back(std::move(row));
        }
    return t;
}

app::Table share_table(const TwoStudies& both)
{
    app::Table t;
    t.caption =
        "Shares of the modes [%] with Wilson's 95 % intervals, number of walls whose force "
        "fell to 80 % of the peak, and mean peak forces with their 95 % intervals.";
    t.keys = 2;
    t.head = {"stress [MPa]", "push", "walls"};
    const std::vector<int> modes = app::modes_of(both.one_way);
    for (const int mode : modes)
        t.head.emplace_back(app::mode_name(mode) + std::string(" [%]"), app::kInterval);
    t.head.insert(t.head.end(), {"fell to 80 %", {"peak [kN]", app::kInterval}});
    for (std::size_t l = 0; l < both.one_way.levels.size(); ++l)
        for (const app::StudyWalls* study : {&both.one_way, &both.cyclic}) {
            const app::StudyLevel& level = study->levels[l];
            const std::size_t n = level.walls.size();
            app::Row row = {app::given(level.stress / 1e6),
                            std::string(study == &both.one_way ? "one way" : "cycles"),
                            app::count(n)};
            for (const int mode : modes)
                row.emplace_back(share_cell(app::walls_of(level, mode).size(), n));
            std::size_t fell = 0;
            for (const app::StudyWall& w : level.walls) fell += w.reading.dropped ? 1 : 0;
            row.emplace_back(app::count(fell));
            row.emplace_back(peak_cell(level));
            t.rows.push_back(std::move(row));
        }
    return t;
}

} // namespace bench
