#include "app/fragility/fragility_curves.hpp"

#include "app/fragility/numbers/drift_fits.hpp"
#include "app/fragility/numbers/limit_drifts.hpp"
#include "app/fragility/numbers/table_texts.hpp"
#include "app/study/answers/fragility_text.hpp"
#include "fragility/fits/kaplan_meier.hpp"
#include "fragility/fits/observed_quantile.hpp"
#include "fragility/limits/fragility_curve.hpp"

#include <algorithm>

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

/// Marked beyond the end of the walls.
Number drift_cell(double drift, const std::vector<double>& drifts, double end)
{
    return {.value = drift, .decimals = decimals_for(drifts.back()), .known_to = end};
}

void add_fit(const DriftData& data, std::size_t g, std::size_t state, int mode,
             const std::vector<double>& drifts, Table& t)
{
    const auto limits = limits_of(data.groups[g], state, mode);
    const JudgedFit judged = judged_fit(data, g, state, mode);
    const fragility::Fit& fit = judged.fit;
    const Row start = {group_cell(data.groups[g]), mode < 0 ? "all" : data.modes[mode],
                       count(limits.size())};
    if (fit.outcome != fragility::FitOutcome::converged)
        return add_row(t, start, "No curve: " + fit.reason + ".");
    const double end = known_to(limits);
    std::string note = rejected(judged) ? rejected_text(judged) : "";
    if (mode < 0 && note.empty()) {
        const LimitDrifts chosen = limit_drifts(data, g, state);
        if (!of_one_law(chosen.quantiles)) note = source_note(chosen);
    }
    if (note.empty()) {
        for (const auto& p : fragility::fragility_curve(fit, drifts, data.options.confidence))
            add_row(t, joined(start, {drift_cell(p.drift, drifts, end),
                                      with_interval(p.probability, p.band, 4)}));
        return;
    }
    const auto shares = fragility::observed_shares(limits, drifts, data.options.confidence);
    for (std::size_t i = 0; i < drifts.size(); ++i) {
        const bool known = fragility::is_known(drifts[i], end);
        add_row(t,
                joined(start,
                       {drift_cell(drifts[i], drifts, end),
                        known ? with_interval(shares[i].share, shares[i].band, 4) : Number{}}),
                note);
    }
}

void add_mixture(const DriftData& data, std::size_t g, std::size_t state,
                 const std::vector<double>& drifts, Table& t)
{
    const DriftGroup& group = data.groups[g];
    const auto modes = mode_groups(data, g, state);
    if (modes.size() < 2) return;
    std::size_t n = 0;
    for (const auto& m : modes) n += m.limits.size();
    const Row start = {group_cell(group), "mixture of modes", count(n)};
    if (const std::string why = no_mixture(modes); !why.empty())
        return add_row(t, start, "No curve: " + why + ".");
    const double end = known_to(limits_of(group, state));
    for (const auto& p :
         fragility::mixture_curve(modes, drifts, data.options.confidence).points)
        add_row(t, joined(start, {drift_cell(p.drift, drifts, end),
                                  with_interval(p.least, p.band, 4), plain_number(p.most, 4)}));
}

/// A sentence, or nothing.
std::string limit_note(const DriftData& data, std::size_t group, std::size_t state)
{
    const std::string limit = limit_text(data, group, state);
    return limit.empty() ? limit : limit + ".";
}

std::string state_text(const StateName& s) { return state_name(s) + " (" + s.rule + ")"; }

Table curve_titled(const char* name, const DriftData& data, std::size_t state)
{
    Words words = words_of(data);
    words["state"] = state_text(data.states[state]);
    return titled_table(name, words);
}

} // namespace

std::string state_file(const StateName& s)
{
    return file_name(s.set.empty() || s.set == s.name ? s.name : s.set + "_" + s.name);
}

std::vector<fragility::ModeGroup> mode_groups(const DriftData& data, std::size_t group,
                                              std::size_t state)
{
    std::vector<fragility::ModeGroup> modes;
    const int last = static_cast<int>(data.modes.size());
    for (int m = last > 0 ? 0 : -1; m < last; ++m) {
        auto limits = limits_of(data.groups[group], state, m);
        const bool described = !rejected(judged_fit(data, group, state, m));
        if (!limits.empty()) modes.push_back({std::move(limits), data.options.law, described});
    }
    return modes;
}

std::string no_mixture(const std::vector<fragility::ModeGroup>& modes)
{
    if (modes.empty()) return "no data";
    std::vector<fragility::Observation> all;
    for (const fragility::ModeGroup& m : modes)
        all.insert(all.end(), m.limits.begin(), m.limits.end());
    if (only_limits(all)) return "every wall that got there reached a drift limit that is set";
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
    Table t = curve_titled("curve", data, state);
    t.keys = 2;
    t.head = {data.group_head,
              "walls",
              "n",
              {drift_head(data, "drift"), kExtrapolated},
              {"probability", kInterval},
              "probability at most",
              {"note", kNote}};
    const std::vector<double> drifts = drift_grid(data, state, kTableDrifts);
    if (drifts.empty()) return t;
    for (std::size_t g = 0; g < data.groups.size(); ++g) {
        for (int m = -1; m < static_cast<int>(data.modes.size()); ++m)
            add_fit(data, g, state, m, drifts, t);
        add_mixture(data, g, state, drifts, t);
    }
    return t;
}

Table step_table(const DriftData& data, std::size_t state)
{
    Table t = curve_titled("steps", data, state);
    t.head = {data.group_head, drift_head(data, "drift"), "walls at risk",
              "reached",       {"share", kInterval},      drift_head(data, "tested up to"),
              {"note", kNote}};
    for (std::size_t i = 0; i < data.groups.size(); ++i) {
        const DriftGroup& g = data.groups[i];
        const auto limits = limits_of(g, state);
        if (limits.empty()) {
            add_row(t, {group_cell(g), {}, count(0), count(0)}, "No wall.");
            continue;
        }
        const auto km = fragility::kaplan_meier(limits, data.options.confidence);
        const Number end = plain_number(km.end, decimals_for(km.end));
        if (km.steps.empty())
            add_row(t, {group_cell(g), {}, count(limits.size()), count(0), {}, end},
                    "No wall reached it.");
        const bool plain = only_limits(limits);
        for (const auto& s : km.steps)
            add_row(t,
                    {group_cell(g), plain_number(s.at, end.decimals + 1), count(s.at_risk),
                     count(s.failed),
                     plain ? plain_number(s.probability, 4)
                           : with_interval(s.probability, s.band, 4),
                     end},
                    limit_note(data, i, state));
    }
    return t;
}

std::vector<NamedTable> curve_tables(const DriftData& data)
{
    std::vector<NamedTable> tables;
    for (std::size_t s = 0; s < data.states.size(); ++s) {
        const std::string file = state_file(data.states[s]);
        tables.push_back({"curve_" + file, curve_table(data, s)});
        tables.push_back({"steps_" + file, step_table(data, s)});
    }
    return tables;
}

} // namespace app
