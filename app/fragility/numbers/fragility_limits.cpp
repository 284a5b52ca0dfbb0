#include "app/fragility/numbers/fragility_limits.hpp"

#include "app/fragility/numbers/drift_fits.hpp"
#include "app/fragility/numbers/limit_drifts.hpp"
#include "app/fragility/numbers/table_texts.hpp"
#include "app/output/table/table_columns.hpp"
#include "app/study/answers/fragility_text.hpp"
#include "app/text/words.hpp"
#include "fragility/limits/performance_limits.hpp"

#include <algorithm>
#include <cmath>

namespace app {
namespace {

/// Whether two limit states are read by one rule. Such states have one row.
bool alike(const StateName& a, const StateName& b)
{
    return !a.rule.empty() && a.rule == b.rule;
}

/// The names of all limit states of the row; nothing where an earlier row has this one.
std::string names_of(const DriftData& data, std::size_t state)
{
    std::string names;
    for (std::size_t s = 0; s < data.states.size(); ++s) {
        if (s != state && !alike(data.states[s], data.states[state])) continue;
        if (s < state) return {};
        names += (names.empty() ? "" : ", ") + state_name(data.states[s]);
    }
    return names;
}

/// The same for any state: the names of the row that has it.
std::string first_names_of(const DriftData& data, std::size_t state)
{
    for (std::size_t s = 0; s < state; ++s)
        if (alike(data.states[s], data.states[state])) return names_of(data, s);
    return names_of(data, state);
}

/// A group and a limit state: one row for all states of one rule.
struct StateRow {
    std::size_t g, state;
};

std::vector<StateRow> rows_of(const DriftData& data)
{
    std::vector<StateRow> rows;
    for (std::size_t g = 0; g < data.groups.size(); ++g)
        for (std::size_t s = 0; s < data.states.size(); ++s)
            if (!names_of(data, s).empty()) rows.push_back({g, s});
    return rows;
}

/// " 2 of 50 walls miss the accuracy asked of the solver: the brackets hold whatever their
/// drifts are within their error."
std::string inaccurate_text(const DriftGroup& group, std::size_t state)
{
    const std::size_t n = inaccurate_walls(group, state);
    if (n == 0) return {};
    return counted(n, "wall misses", "walls miss") +
           " the accuracy asked of the solver: brackets hold wherever the drifts of such "
           "walls lie within their error.";
}

/// The limit drifts of a row, chosen once.
struct LimitsRow {
    const DriftGroup* group;
    std::string names;
    LimitDrifts drifts;
    bool set = false;                   ///< some drifts are drift limits that are set
    std::vector<fragility::Cap> caps{}; ///< those drift limits
    bool fitted = true;                 ///< else only a bound of the median is known
    double tested = 0.0;                ///< [%]
    std::string source{};               ///< of the drifts: "law", "observed", "limit"
    std::string note{};
    std::string piers{}; ///< that govern, with their shares
};

void add_sentence(std::string& text, const std::string& more)
{
    text += (text.empty() || more.empty() ? "" : " ") + more;
}

LimitsRow limits_row(const DriftData& data, const StateRow& at)
{
    const DriftGroup& group = data.groups[at.g];
    const auto observations = limits_of(group, at.state);
    LimitsRow r{&group, names_of(data, at.state), limit_drifts(data, at.g, at.state)};
    const fragility::LimitQuantiles& q = r.drifts.quantiles;
    r.tested = std::isfinite(q.tested_to) ? q.tested_to : known_to(observations);
    if (const std::string limit = limit_text(data, at.g, at.state); !limit.empty()) {
        const bool alone = only_limits(observations);
        r.set = true;
        r.caps = fragility::caps(observations);
        r.source = alone ? "limit" : "observed";
        r.note =
            limit + (alone ? "." : ": the drifts are those observed (Kaplan-Meier), no law.");
    } else if (identified(r.drifts)) {
        r.source = source_text(q);
        r.note = source_note(r.drifts);
    } else {
        r.fitted = false;
        r.note = not_identified_text(r.drifts, group);
    }
    r.piers = pier_text(data, at.g, at.state);
    if (!r.piers.empty()) add_sentence(r.note, "Drift limit of " + r.piers + " of walls.");
    add_sentence(r.note, inaccurate_text(group, at.state));
    return r;
}

constexpr std::size_t kMedian = 2; // of the five shares

/// A drift limit that is set is a plain number: it has no interval.
Cell quantile_of(const LimitsRow& r, std::size_t share)
{
    if (!r.fitted) {
        const auto& bound = r.drifts.law.bound;
        if (share != kMedian) return {};
        return median_bound(bound, decimals_for(bound.median_above));
    }
    if (share >= r.drifts.quantiles.at.size()) return {};
    const fragility::LimitQuantile& q = r.drifts.quantiles.at[share];
    const int d = decimals_for(q.value.value_or(q.interval.lower));
    const bool cap =
        q.value && std::ranges::count(r.caps, *q.value, &fragility::Cap::value) > 0;
    return cap ? plain_number(*q.value, d) : quantile_cell(q, d);
}

/// Whether one law of all walls gives the drifts.
bool of_a_law(const LimitsRow& r)
{
    return r.fitted && !r.set && r.drifts.quantiles.source == fragility::QuantileSource::law;
}

Cell dispersion_cell(const LimitsRow& r)
{
    if (!r.fitted || r.set) return {};
    if (of_a_law(r))
        return with_interval(r.drifts.law.dispersion, r.drifts.law.dispersion_interval, 2);
    const auto dispersion = dispersion_of(r.drifts);
    return dispersion ? Cell(plain_number(*dispersion, 2)) : Cell();
}

/// A drift limit of a pier, which a code sets, has no doubt of the model.
fragility::ModelFactor factor_of(const LimitsRow& r)
{
    return r.piers.empty() ? r.group->model.factor : fragility::ModelFactor{};
}

TableColumns<LimitsRow> limit_columns_of(const DriftData& data)
{
    const auto of_any = [](auto number) {
        return [number](const LimitsRow& r) {
            return r.drifts.law.n > 0.0 ? number(r) : Number{};
        };
    };
    const auto of_law = [](auto value, int decimals) {
        return [value, decimals](const LimitsRow& r) {
            return of_a_law(r) ? Cell(plain_number(value(r), decimals)) : Cell();
        };
    };
    TableColumns<LimitsRow> all = {
        {data.group_head, [](const LimitsRow& r) { return group_cell(*r.group); }},
        {"limit state", &LimitsRow::names},
        {"n", [](const LimitsRow& r) { return count(r.drifts.law.n); }},
        {"censored [%]", of_any([](const LimitsRow& r) {
             return plain_number(100.0 * r.drifts.law.censored_share, 0);
         })},
        {{drift_head(data, "tested up to"), kDetail}, of_any([](const LimitsRow& r) {
             return plain_number(r.tested, decimals_for(r.tested));
         })},
        {{"drifts from", kProgramsOnly}, &LimitsRow::source}};
    for (std::size_t i = 0;
         const char* const share :
         {"5 % drift", "16 % drift", "median drift", "84 % drift", "95 % drift"}) {
        all.push_back({{drift_head(data, share),
                        kInterval | kCensored | (i == kMedian ? 0U : unsigned{kDetail})},
                       [i](const LimitsRow& r) { return quantile_of(r, i); }});
        ++i;
    }
    append(all, {{{"dispersion", kInterval}, dispersion_cell},
                 {{"std error of ln median", kProgramsOnly},
                  of_law([](const LimitsRow& r) { return r.drifts.law.median_error; }, 3)},
                 {{"total dispersion", kProgramsOnly},
                  of_law(
                      [](const LimitsRow& r) {
                          return std::hypot(r.drifts.law.predictive_dispersion,
                                            fragility::model_dispersion(factor_of(r)));
                      },
                      2)},
                 {{"note", kNote}, &LimitsRow::note}});
    return all;
}

void add_tests(const DriftData& data, std::size_t g, std::size_t state, Table& t)
{
    const DriftGroup& group = data.groups[g];
    Row row = {group_cell(group), names_of(data, state), count(limits_of(group, state).size())};
    const JudgedFit f = judged_fit(data, g, state);
    if (f.fit.outcome != fragility::FitOutcome::converged)
        return add_row(t, row, "No fit: " + f.fit.reason + ".");
    if (!f.tests.available)
        return add_row(t, row,
                       data.options.bootstrap > 0 ? "No test: " + f.tests.reason + "." : "");
    const auto& d = f.tests.distance;
    for (const double x :
         {d.kolmogorov_smirnov, f.tests.p_kolmogorov_smirnov, d.cramer_von_mises,
          f.tests.p_cramer_von_mises, d.anderson_darling, f.tests.p_anderson_darling})
        row.emplace_back(plain_number(x, 3));
    row.emplace_back(d.two_heaps > 0.0 ? plain_number(f.tests.p_two_heaps, 3) : Number{});
    row.emplace_back(count(f.tests.replicates));
    add_row(t, row, rejected(f) ? rejected_text(f) : "");
}

} // namespace

Table performance_table(const DriftData& data)
{
    Table t = titled_table("performance_limits", words_of(data));
    if (!data.no_limit.empty()) t.caption += " " + data.no_limit;
    t.keys = 2;
    std::vector<LimitsRow> rows;
    for (const StateRow& at : rows_of(data)) rows.push_back(limits_row(data, at));
    fill(t, limit_columns_of(data), rows);
    return t;
}

std::string names_of_row(const DriftData& data, std::size_t state)
{
    return names_of(data, state);
}

std::vector<std::size_t> severest_rows(const DriftData& data, const Table& limits)
{
    std::vector<std::string> severest;
    for (std::size_t s = 0; s < data.states.size(); ++s)
        if (s + 1 == data.states.size() || data.states[s + 1].set != data.states[s].set)
            severest.push_back(first_names_of(data, s));
    std::vector<std::size_t> rows;
    for (std::size_t r = 0; r < limits.rows.size(); ++r)
        if (std::ranges::count(severest, cell_text(limits.rows[r][1])) > 0) rows.push_back(r);
    return rows;
}

Table fit_table(const DriftData& data)
{
    Table t = titled_table("goodness_of_fit", words_of(data));
    t.keys = 2;
    t.head = {data.group_head,
              "limit state",
              "n",
              "D",
              "p of D",
              "W2",
              "p of W2",
              "A2",
              "p of A2",
              "p of two heaps",
              {"samples", kProgramsOnly},
              {"note", kNote}};
    for (const auto& [g, state] : rows_of(data)) add_tests(data, g, state, t);
    return t;
}

} // namespace app
