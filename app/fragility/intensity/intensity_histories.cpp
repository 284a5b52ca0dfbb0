#include "app/fragility/intensity/intensity_histories.hpp"

#include "app/output/table/cells.hpp"
#include "app/study/answers/fragility_text.hpp"
#include "app/text/number_text.hpp"
#include "fragility/intensity/cloud.hpp"
#include "fragility/intensity/sufficiency.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace app {

using fragility::ModelOutcome;

std::vector<DriftFractiles> drift_fractiles(const IntensityData& data, std::size_t level)
{
    constexpr std::array kFractiles = {0.16, 0.5, 0.84};
    std::map<std::size_t, std::pair<std::vector<double>, std::vector<double>>> by;
    for (const StoredHistory& h : data.histories.levels.at(level).histories) {
        if (h.failed) continue;
        auto& [x, drifts] = by[h.intensity];
        x.push_back(h.measures[data.column] / data.unit_value);
        drifts.push_back(h.fell ? std::numeric_limits<double>::infinity() : h.max_drift);
    }
    std::vector<DriftFractiles> all;
    for (auto& [intensity, both] : by) {
        auto& [x, drifts] = both;
        std::ranges::sort(x);
        std::ranges::sort(drifts);
        DriftFractiles f{x[x.size() / 2], drifts.size(), {}};
        for (std::size_t i = 0; i < kFractiles.size(); ++i) {
            const double place = kFractiles[i] * static_cast<double>(drifts.size());
            f.at[i] = drifts[std::min(drifts.size() - 1, static_cast<std::size_t>(place))];
        }
        all.push_back(f);
    }
    std::ranges::sort(all, {}, &DriftFractiles::intensity);
    return all;
}

namespace {

/// A feature of a record that no scaling changes.
struct Feature {
    const char* head;
    std::string_view measure;
    std::string_view over; ///< empty: the measure alone
};
constexpr Feature kFeatures[] = {{"sufficiency, D5-95: p", "d5_95", ""},
                                 {"sufficiency, PGV/PGA: p", "pgv", "pga"}};

/// The histories of a stress that gave a result, as a cloud.
struct Cloud {
    std::vector<const StoredHistory*> histories;
    std::vector<fragility::CloudPoint> points; ///< of one measure
    std::vector<std::size_t> records;
};

Cloud cloud_of(const HistoryLevel& level, std::size_t measure)
{
    Cloud c;
    for (const StoredHistory& h : level.histories) {
        if (h.failed) continue;
        const double drift = std::max(h.max_drift, kElasticDrift);
        c.histories.push_back(&h);
        c.records.push_back(h.record);
        c.points.push_back({h.measures[measure],
                            h.fell ? fragility::right_censored(drift)
                            : h.max_drift < kElasticDrift
                                ? fragility::left_censored(kElasticDrift)
                                : fragility::observed(h.max_drift),
                            h.fell});
    }
    return c;
}

/// ln of a feature by history; empty where the file does not have it.
std::vector<double> values_of(const Feature& feature, const Cloud& cloud,
                              const std::vector<std::string>& measures)
{
    const auto place = [&](std::string_view name) {
        return static_cast<std::size_t>(std::ranges::find(measures, name) - measures.begin());
    };
    const std::size_t at = place(feature.measure);
    const bool ratio = !feature.over.empty();
    const std::size_t over = ratio ? place(feature.over) : 0;
    if (std::max(at, over) >= measures.size()) return {};
    std::vector<double> x;
    for (const StoredHistory* h : cloud.histories) {
        const double value = h->measures[at] / (ratio ? h->measures[over] : 1.0);
        if (!(value > 0.0) || !std::isfinite(value)) return {};
        x.push_back(std::log(value));
    }
    return x;
}

Number sufficiency_cell(const Feature& feature, const Cloud& cloud,
                        const fragility::CloudFit& fit,
                        const std::vector<std::string>& measures)
{
    const std::vector<double> x = values_of(feature, cloud, measures);
    if (x.empty()) return {};
    const auto test = fragility::test_sufficiency(cloud.points, fit, x, cloud.records);
    return test.outcome == ModelOutcome::converged ? plain_number(test.p, 3) : Number{};
}

} // namespace

Table measure_table(const IntensityData& data)
{
    Table t;
    t.title = "How well each measure tells the drift";
    t.caption =
        "ln drift = a + b ln(measure) + s z over all histories of a stress; drifts of "
        "walls that fell lie above, those below " +
        percent_text(kElasticDrift) +
        " below. Efficiency: a small s. Practicality: a large b. Proficiency: a small "
        "s/b, the dispersion of a fragility curve on this measure. Of measures to which "
        "records were scaled s is that at the intensities of the study. Sufficiency (Luco and "
        "Cornell 2007): p-value of the hypothesis that, given the measure, the drift does not "
        "depend on the duration of the record (D5-95), or on what it has of long periods "
        "(PGV/PGA); scores are summed over each record, of which there must be " +
        std::to_string(fragility::kSufficiencyRecords) +
        ". A small p: the curve depends on which records were taken.";
    t.head = {"stress [MPa]", "measure", "b", "s", "s/b"};
    for (const Feature& f : kFeatures) t.head.emplace_back(f.head);
    t.head.insert(t.head.end(), {"histories", {"note", kNote}});
    t.keys = 2;
    for (const HistoryLevel& level : data.histories.levels)
        for (std::size_t m = 0; m < data.histories.measures.size(); ++m) {
            const Cloud cloud = cloud_of(level, m);
            const fragility::CloudFit f = fragility::fit_cloud(cloud.points);
            const bool has_line = f.outcome == ModelOutcome::converged;
            const auto known = [&](double x) {
                return has_line ? plain_number(x, 3) : Number{};
            };
            Row row = {stress_cell(level.stress), data.histories.measures[m], known(f.slope),
                       known(f.sigma), f.slope > 0.0 ? known(f.sigma / f.slope) : Number{}};
            for (const Feature& feature : kFeatures)
                row.emplace_back(sufficiency_cell(feature, cloud, f, data.histories.measures));
            row.emplace_back(count(cloud.points.size()));
            add_row(t, row, has_line ? "" : "No line: " + f.reason + ".");
        }
    return t;
}

Table fractile_table(const IntensityData& data)
{
    Table t;
    t.title = "Drifts at each intensity";
    t.caption =
        "16, 50 and 84 % of the largest drifts of the histories at each intensity of "
        "the study; a wall that fell lies above all others, and where a fractile is one "
        "of these the cell is empty.";
    t.head = {"stress [MPa]", "median " + data.measure_name + " [" + data.unit + "]",
              "histories",    "16 % [%]",
              "50 % [%]",     "84 % [%]"};
    t.keys = 2;
    for (std::size_t l = 0; l < data.histories.levels.size(); ++l)
        for (const DriftFractiles& f : drift_fractiles(data, l)) {
            Row row = {stress_cell(data.histories.levels[l].stress),
                       plain_number(f.intensity, decimals_for(f.intensity)), count(f.n)};
            for (const double x : f.at)
                row.emplace_back(std::isfinite(x) ? plain_number(100.0 * x, 3) : Number{});
            t.rows.push_back(std::move(row));
        }
    return t;
}

Table history_table(const IntensityData& data)
{
    Table t;
    t.title = "Histories";
    t.caption = "Each history with the measures of its motion.";
    const ShakenIntensities& at = data.histories.at;
    t.head = {"stress [MPa]", "wall", "record",        intensity_head(at),
              "outcome",      "mode", "max drift [%]", "residual drift [%]",
              "collapse [s]"};
    for (std::size_t m = 0; m < data.histories.measures.size(); ++m)
        t.head.emplace_back(data.histories.measures[m] + " [" + data.histories.units[m] + "]");
    t.keys = 4;
    const auto known = [](double x, double scale) {
        return std::isfinite(x) ? Number{.value = scale * x} : Number{};
    };
    for (const HistoryLevel& level : data.histories.levels)
        for (const StoredHistory& h : level.histories) {
            Row row = {stress_cell(level.stress),
                       count(h.wall),
                       data.histories.records[h.record],
                       intensity_cell(at, h.intensity),
                       std::string(h.failed ? "failed"
                                   : h.fell ? "fell"
                                            : "stood"),
                       h.failed ? std::string() : std::string(dem::name(h.mode)),
                       h.failed ? Number{} : known(h.max_drift, 100.0),
                       h.failed || h.fell ? Number{} : known(h.residual_drift, 100.0),
                       h.fell ? known(h.collapse_time, 1.0) : Number{}};
            for (const double x : h.measures) row.emplace_back(known(x, 1.0));
            t.rows.push_back(std::move(row));
        }
    return t;
}

} // namespace app
