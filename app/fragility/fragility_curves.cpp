#include "app/fragility/fragility_curves.hpp"

#include "app/input/number_text.hpp"
#include "app/study/fragility_text.hpp"
#include "fragility/fragility_curve.hpp"
#include "fragility/kaplan_meier.hpp"

#include <algorithm>
#include <cmath>

namespace app {
namespace {

constexpr std::size_t kTableDrifts = 30;

/// Where curves end: no further than the runs went.
double grid_end(const DriftData& data, std::size_t state)
{
    std::vector<fragility::Observation> all;
    for (const DriftGroup& g : data.groups) {
        const auto limits = limits_of(g, state);
        all.insert(all.end(), limits.begin(), limits.end());
    }
    return common_end(all);
}

/// First cells of a row of the table of curves.
using Start = std::vector<std::string>;

void add_fit(const DriftData& data, const Start& start,
             const std::vector<fragility::Observation>& limits,
             const std::vector<double>& drifts, Table& t)
{
    const fragility::Fit fit = fragility::fit(data.options.law, limits);
    Start row = start;
    row.push_back(std::to_string(limits.size()));
    if (fit.outcome != fragility::FitOutcome::converged) {
        row.insert(row.end(), {"", "no curve: " + fit.reason, ""});
        t.rows.push_back(row);
        return;
    }
    const int d = decimals_for(drifts.back());
    const double end = known_to(limits);
    for (const auto& p : fragility::fragility_curve(fit, drifts, data.options.confidence)) {
        Start cells = row;
        cells.push_back(with_mark(p.drift, d, end));
        cells.push_back(with_interval(p.probability, p.band, 4));
        cells.emplace_back();
        t.rows.push_back(cells);
    }
}

void add_mixture(const DriftData& data, const DriftGroup& group, std::size_t state,
                 const std::vector<double>& drifts, Start row, Table& t)
{
    const auto modes = mode_groups(data, group, state);
    if (modes.size() < 2) return;
    std::size_t n = 0;
    for (const auto& m : modes) n += m.limits.size();
    row.insert(row.end(), {"mixture", std::to_string(n)});
    if (const std::string why = no_mixture(modes); !why.empty()) {
        row.insert(row.end(), {"", "no curve: " + why, ""});
        t.rows.push_back(row);
        return;
    }
    const int d = decimals_for(drifts.back());
    const double end = known_to(limits_of(group, state));
    for (const auto& p :
         fragility::mixture_curve(modes, drifts, data.options.confidence).points) {
        Start cells = row;
        cells.push_back(with_mark(p.drift, d, end));
        cells.push_back(with_interval(p.least, p.band, 4));
        cells.push_back(fixed(p.most, 4));
        t.rows.push_back(cells);
    }
}

std::string state_text(const DriftState& s)
{
    return (s.set.empty() ? "" : s.set + " ") + s.name + " (" + s.rule + ")";
}

} // namespace

std::string state_file(const DriftState& s)
{
    return file_name((s.set.empty() ? "" : s.set + "_") + s.name);
}

std::vector<fragility::ModeGroup> mode_groups(const DriftData& data, const DriftGroup& group,
                                              std::size_t state)
{
    std::vector<fragility::ModeGroup> modes;
    for (std::size_t m = 0; m < data.modes.size(); ++m) {
        auto limits = limits_of(group, state, static_cast<int>(m));
        if (!limits.empty()) modes.push_back({std::move(limits), data.options.law});
    }
    return modes;
}

std::string no_mixture(const std::vector<fragility::ModeGroup>& modes)
{
    if (modes.empty()) return "no data";
    for (const fragility::ModeGroup& m : modes) {
        const auto refusal = fragility::screen(m.law, m.limits);
        if (refusal && (refusal->outcome == fragility::FitOutcome::not_positive ||
                        refusal->outcome == fragility::FitOutcome::invalid_value))
            return refusal->reason;
    }
    return {};
}

std::vector<double> drift_grid(const DriftData& data, std::size_t state, std::size_t points)
{
    const double largest = grid_end(data, state);
    std::vector<double> drifts;
    for (std::size_t i = 1; i <= points && largest > 0.0; ++i)
        drifts.push_back(largest * static_cast<double>(i) / static_cast<double>(points));
    return drifts;
}

Table curve_table(const DriftData& data, std::size_t state)
{
    Table t;
    t.caption =
        "Probability that " + state_text(data.states[state]) + " is reached at a drift. " +
        counts_text(data) + ". " + data.drift + ". " + std::string(name(data.options.law)) +
        " laws by censored maximum likelihood, " + percent_text(data.options.confidence) +
        " bands by the delta method on the logit (of 50 walls, 95 % bands held the truth in 93 "
        "to 98 of 100 synthetic studies). Mixture: shares of the modes times their curves. Of "
        "a mode that has no fit the probability counts the walls seen to reach it, \"at most\" "
        "as many as a bound without a law allows; the band holds both. " +
        extrapolated_text("any of these walls") + ".";
    t.head = {data.group_head,           "walls of",    "n",
              drift_head(data, "drift"), "probability", "at most"};
    const std::vector<double> drifts = drift_grid(data, state, kTableDrifts);
    if (drifts.empty()) return t;
    for (const DriftGroup& g : data.groups) {
        const Start start = {group_cell(g)};
        add_fit(data, {start[0], "all modes"}, limits_of(g, state), drifts, t);
        for (std::size_t m = 0; m < data.modes.size(); ++m)
            add_fit(data, {start[0], data.modes[m]}, limits_of(g, state, static_cast<int>(m)),
                    drifts, t);
        add_mixture(data, g, state, drifts, start, t);
    }
    return t;
}

Table step_table(const DriftData& data, std::size_t state)
{
    Table t;
    t.caption = "Share of walls that have reached " + state_text(data.states[state]) +
                ", without any law (Kaplan and Meier 1958), " +
                percent_text(data.options.confidence) + " bands of ln(-ln survival). " +
                counts_text(data) + ". " + data.drift +
                ". A share holds up to the next drift; beyond \"known to\" nothing is known.";
    t.head = {data.group_head, drift_head(data, "drift"),   "at risk", "reached",
              "share",         drift_head(data, "known to")};
    for (const DriftGroup& g : data.groups) {
        const auto limits = limits_of(g, state);
        if (limits.empty()) {
            t.rows.push_back({group_cell(g), "", "0", "0", "no wall", ""});
            continue;
        }
        const auto km = fragility::kaplan_meier(limits, data.options.confidence);
        const std::string end = fixed(km.end, decimals_for(km.end));
        if (km.steps.empty())
            t.rows.push_back({group_cell(g), "", std::to_string(limits.size()), "0",
                              "no wall reached it", end});
        for (const auto& s : km.steps)
            t.rows.push_back({group_cell(g), fixed(s.at, decimals_for(km.end) + 1),
                              number(s.at_risk, 9), number(s.failed, 9),
                              with_interval(s.probability, s.band, 4), end});
    }
    return t;
}

std::vector<NamedTable> curve_tables(const DriftData& data)
{
    std::vector<NamedTable> tables;
    for (std::size_t s = 0; s < data.states.size(); ++s) {
        const std::string file = state_file(data.states[s]);
        const std::string text = state_text(data.states[s]);
        tables.push_back(
            {"curve_" + file, "fragility curves of " + text, curve_table(data, s)});
        tables.push_back(
            {"steps_" + file, "shares without a law, " + text, step_table(data, s)});
    }
    return tables;
}

} // namespace app
