#include "app/fragility/intensity/intensity_output.hpp"

#include "app/fragility/intensity/intensity_histories.hpp"
#include "app/fragility/intensity/intensity_modes.hpp"
#include "app/output/table/cells.hpp"
#include "app/output/unique_names.hpp"
#include "app/study/answers/fragility_text.hpp"
#include "app/study/stored/study_walls.hpp"
#include "app/text/number_text.hpp"
#include "app/text/words.hpp"
#include "core/binomial.hpp"
#include "core/interval.hpp"
#include "fragility/fits/share.hpp"
#include "fragility/intensity/crossed_design.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace app {
namespace {

using fragility::ClusteredFit;
using fragility::ModelOutcome;

Number limit_number(double value, const core::Interval& i, int decimals)
{
    const bool known = i.lower > 0.0 && std::isfinite(i.upper);
    return known ? with_interval(value, i, decimals) : plain_number(value, decimals);
}

Row rate_cells(const IntensityData& data, const ClusteredFit& c)
{
    if (data.hazard.empty()) return {};
    const fragility::AnnualRate r =
        fragility::annual_rate(data.hazard, c.fit.curve.median, c.fit.curve.dispersion);
    const auto cell = [](double rate) { // three digits, of a rate in a million years, too
        const double magnitude = std::floor(std::log10(std::max(rate, 1e-15)));
        return plain_number(rate, std::clamp(2 - static_cast<int>(magnitude), 0, 15));
    };
    return {cell(r.lower), cell(r.upper)};
}

Table limit_table_of(const IntensityData& data, const AllIntensityFits& fits)
{
    Table t;
    t.title = "Fragility on " + data.measure_name;
    t.caption =
        "P(state reached | " + data.measure_name +
        ") = Phi(ln(x / median) / dispersion). Stripes: reached or not, a binomial likelihood "
        "over the histories (Baker 2015). IDA: the intensity at which each wall under each "
        "record first reaches the state, interpolated; between the last that stood and the "
        "first that fell before a collapse, and above the largest intensity where it was never "
        "reached; n counts pairs. Cloud: ln drift = a + b ln intensity + s z, where a wall "
        "that "
        "fell lies above the drift that was seen of it and a drift below " +
        percent_text(kElasticDrift) +
        " below that (Tobin 1958). Fallen walls have reached every state. The " +
        percent_text(data.confidence) +
        " intervals are clustered by record and by wall "
        "(fragility/intensity/intensity_fit.hpp); the "
        "dispersion holds the scatter of records and of walls and no error of the model. "
        "Shaking is verified against closed forms, not validated.";
    t.head = {"stress [MPa]",
              "state",
              "method",
              {"median [" + data.unit + "]", kInterval},
              {"dispersion", kInterval},
              {"reached", kDetail},
              {"n", kDetail},
              {"records", kDetail},
              {"walls", kDetail}};
    if (!data.hazard.empty()) {
        t.head.push_back("annual rate [1/a]");
        t.head.push_back("with all beyond the hazard [1/a]");
        t.caption +=
            " Annual rate: the hazard curve over the curve of the state as fitted, "
            "without the doubt of its interval. It counts nothing that lies beyond the "
            "last point of the hazard, the next column all of it, and neither what "
            "lies below the first.";
    }
    t.head.push_back({"note", kNote});
    t.keys = 3;
    for (std::size_t l = 0; l < fits.size(); ++l)
        for (std::size_t s = 0; s < data.states.size(); ++s)
            for (std::size_t m = 0; m < kIntensityMethods.size(); ++m) {
                const auto& c = fits[l][s].by[m];
                if (!c) continue;
                Row row = {stress_cell(data.histories.levels[l].stress), data.states[s].name,
                           std::string(kIntensityMethods[m].second)};
                const Row counts = {count(c->fit.reached), count(c->fit.n), count(c->records),
                                    count(c->walls)};
                if (c->fit.outcome != ModelOutcome::converged) {
                    add_row(t, joined(joined(std::move(row), {Number{}, Number{}}), counts),
                            "No curve: " + c->fit.reason + ".");
                    continue;
                }
                row = joined(std::move(row), intensity_curve_cells(*c));
                row = joined(joined(std::move(row), counts), rate_cells(data, *c));
                add_row(t, std::move(row),
                        c->reason.empty() ? "" : "No interval: " + c->reason + ".");
            }
    return t;
}

/// Shares at each intensity of the study, and modes.
Table stripe_table(const IntensityData& data)
{
    Table t;
    t.title = "Histories at each intensity";
    t.caption = "Shares of the histories that reached each state, with Wilson intervals that "
                "take them as independent and hold whatever the failed ones would have been; "
                "modes where the walls turned back from their largest drift, or fell.";
    const ShakenIntensities& at = data.histories.at;
    t.head = {"stress [MPa]", intensity_head(at),
              "median " + data.measure_name + " [" + data.unit + "]", "histories", "failed"};
    for (const IntensityState& s : data.states) t.head.push_back({s.name + " [%]", kInterval});
    for (const char* const mode : {"rocking [%]", "sliding [%]", "mixed [%]"})
        t.head.emplace_back(mode);
    t.keys = 2;
    for (std::size_t l = 0; l < data.histories.levels.size(); ++l) {
        const HistoryLevel& level = data.histories.levels[l];
        std::map<std::size_t, std::vector<const StoredHistory*>> by;
        for (const StoredHistory& h : level.histories) by[h.intensity].push_back(&h);
        for (const auto& [intensity, all] : by) {
            std::vector<double> x;
            std::array<double, 3> modes{};
            double n = 0.0;
            for (const StoredHistory* h : all) {
                x.push_back(h->measures[data.column] / data.unit_value);
                if (h->failed) continue;
                n += 1.0;
                modes[static_cast<std::size_t>(h->mode)] += 1.0;
            }
            std::ranges::sort(x);
            const double failed = static_cast<double>(all.size()) - n;
            Row row = {stress_cell(level.stress), intensity_cell(at, intensity),
                       plain_number(x[x.size() / 2], decimals_for(x[x.size() / 2])),
                       count(all.size()), count(failed)};
            for (const IntensityState& s : data.states) {
                double reached = 0.0;
                for (const StoredHistory* h : all) {
                    if (h->failed) continue;
                    const double response = response_of(*h, s.of);
                    reached += h->fell || response > s.threshold ? 1.0 : 0.0;
                }
                const fragility::Share share = fragility::share(
                    reached, n, failed, core::BinomialInterval::wilson, data.confidence);
                row.emplace_back(n > 0.0 ? percent(share.value, share.interval, 0) : Number{});
            }
            for (const double mode : modes)
                row.emplace_back(n > 0.0 ? plain_number(100.0 * mode / n, 0) : Number{});
            t.rows.push_back(std::move(row));
        }
    }
    return t;
}

/// ln capacity of each wall under each record, or why there is none.
std::string capacity_matrix(const std::vector<fragility::PairCapacity>& pairs,
                            Eigen::MatrixXd& y)
{
    std::map<std::size_t, Eigen::Index> walls, records;
    for (const fragility::PairCapacity& p : pairs) {
        walls.try_emplace(p.wall, static_cast<Eigen::Index>(walls.size()));
        records.try_emplace(p.record, static_cast<Eigen::Index>(records.size()));
    }
    if (walls.size() < 2 || records.size() < 2)
        return "it takes two records and two walls or more";
    if (walls.size() * records.size() != pairs.size())
        return "not every wall was shaken by every record";
    y.resize(static_cast<Eigen::Index>(records.size()),
             static_cast<Eigen::Index>(walls.size()));
    std::size_t beyond = 0;
    for (const fragility::PairCapacity& p : pairs) {
        const auto& c = p.capacity;
        if (!(c.lower > 0.0) || !std::isfinite(c.upper))
            ++beyond;
        else
            y(records.at(p.record), walls.at(p.wall)) = 0.5 * std::log(c.lower * c.upper);
    }
    if (beyond > 0)
        return std::to_string(beyond) + " of " + std::to_string(pairs.size()) +
               " capacities lie below the least or above the largest intensity";
    return {};
}

Table scatter_table(const IntensityData& data)
{
    Table t;
    t.title = "Scatter of records and of walls";
    t.caption = "Standard deviations of ln capacity (IDA) in the crossed design: what records, "
                "walls, and both together have (random effects; a variance below 0 is shown as "
                "0). Needs every wall under every record, with a capacity in the range of the "
                "intensities; before a collapse its middle on the logarithmic axis is taken.";
    t.head = {"stress [MPa]", "state", "records",      "walls",
              "interaction",  "all",   {"note", kNote}};
    t.keys = 2;
    for (std::size_t l = 0; l < data.histories.levels.size(); ++l)
        for (const IntensityState& s : data.states) {
            const Row start = {stress_cell(data.histories.levels[l].stress), s.name};
            const auto points = shaken_points(data, l, s);
            Eigen::MatrixXd y;
            const std::string why =
                points.empty()
                    ? "no histories"
                    : capacity_matrix(fragility::pair_capacities(points, s.threshold), y);
            if (!why.empty()) {
                add_row(t, start, "Not split: " + why + ".");
                continue;
            }
            const fragility::VarianceSplit v = fragility::variance_split(y);
            const auto root = [](double x) {
                return plain_number(std::sqrt(std::max(0.0, x)), 3);
            };
            add_row(t, joined(start, {root(v.records), root(v.walls), root(v.interaction),
                                      root(v.total)}));
        }
    return t;
}

std::string intensity_remarks(const IntensityData& data)
{
    std::string text = history_troubles(data.histories);
    if (data.histories.shard)
        text += data.histories.name + ": drystone merge puts the shards of a study together.\n";
    return text;
}

} // namespace

Row intensity_curve_cells(const ClusteredFit& c)
{
    const auto& curve = c.fit.curve;
    return {limit_number(curve.median, c.median, decimals_for(curve.median)),
            limit_number(curve.dispersion, c.dispersion, 3)};
}

std::string level_file(const HistoryLevel& level)
{
    return plain_name(stress_text(level.stress), "stress");
}

FragilityOutput intensity_output(const IntensityData& data)
{
    AllIntensityFits fits;
    std::size_t n = 0;
    for (std::size_t l = 0; l < data.histories.levels.size(); ++l) {
        n += data.histories.levels[l].histories.size();
        fits.emplace_back();
        for (const IntensityState& s : data.states)
            fits.back().push_back(intensity_fits(data, l, s));
    }
    FragilityOutput output;
    output.source = data.histories.name + ", " + counted(n, "history", "histories");
    output.remarks = intensity_remarks(data);
    Table limits = limit_table_of(data, fits);
    std::vector<std::size_t> main; // the method that stands for each state
    std::size_t row = 0;
    for (const auto& level : fits)
        for (const IntensityFits& f : level) {
            const auto chosen = chosen_fit(f);
            for (std::size_t m = 0; m < f.by.size(); ++m) {
                if (!f.by[m]) continue;
                if (chosen ? *chosen == m : m == 0) main.push_back(row);
                ++row;
            }
        }
    output.tables = {{"intensity_limits", std::move(limits), true, std::move(main)},
                     {"intensity_stripes", stripe_table(data), true},
                     {"intensity_modes", intensity_mode_table(data), true},
                     {"intensity_scatter", scatter_table(data)},
                     {"intensity_measures", measure_table(data)},
                     {"intensity_fractiles", fractile_table(data)},
                     {"histories", history_table(data)}};
    output.pictures = intensity_pictures(data, fits);
    std::ranges::move(intensity_mode_pictures(data), std::back_inserter(output.pictures));
    output.pelicun = intensity_pelicun_csv(data, fits);
    output.openquake = openquake_xml(data, fits);
    make_names_unique(output);
    return output;
}

} // namespace app
