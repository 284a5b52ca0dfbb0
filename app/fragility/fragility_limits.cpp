#include "app/fragility/fragility_limits.hpp"

#include "app/fragility/drift_fits.hpp"
#include "app/fragility/limit_drifts.hpp"
#include "app/fragility/table_texts.hpp"
#include "app/study/fragility_text.hpp"
#include "app/text/words.hpp"
#include "core/interval.hpp"
#include "fragility/performance_limits.hpp"
#include "fragility/stress_model.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>

namespace app {
namespace {

using fragility::Observation;

/// Why there are no numbers: where there are walls, for the law's own reason.
std::string without_fit(const fragility::PerformanceLimits& limits, const DriftGroup& group)
{
    if (limits.n > 0.0 && limits.censored_share == 1.0)
        return "Not identifiable: no wall reached it.";
    if (limits.n > 0.0) {
        constexpr std::string_view opening = "not identifiable: ";
        const bool opened = limits.reason.starts_with(opening);
        return "Not identifiable: " + limits.reason.substr(opened ? opening.size() : 0) + ".";
    }
    return group.walls.empty() ? "No wall gave a result."
                               : "The limit state is not defined on any curve.";
}

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

/// Adds the row of each group and limit state.
template <class Add> void add_rows(const DriftData& data, Add add, Table& t)
{
    for (std::size_t g = 0; g < data.groups.size(); ++g)
        for (std::size_t s = 0; s < data.states.size(); ++s)
            if (!names_of(data, s).empty()) add(data, g, s, t);
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

/// The drifts; a drift limit that is set is a plain number: it has no interval.
void add_quantiles(const LimitDrifts& limits, const std::vector<fragility::Cap>& caps, Row& row)
{
    for (const fragility::LimitQuantile& q : limits.quantiles.at) {
        const int d = decimals_for(q.value.value_or(q.interval.lower));
        const bool cap =
            q.value && std::ranges::count(caps, *q.value, &fragility::Cap::value) > 0;
        row.emplace_back(cap ? plain_number(*q.value, d) : quantile_cell(q, d));
    }
}

/// Dispersion, error of ln median, total dispersion with that of the model.
Row dispersion_cells(const LimitDrifts& limits, const fragility::ModelFactor& factor)
{
    if (limits.quantiles.source == fragility::QuantileSource::law)
        return {with_interval(limits.law.dispersion, limits.law.dispersion_interval, 2),
                plain_number(limits.law.median_error, 3),
                plain_number(std::hypot(limits.law.predictive_dispersion,
                                        fragility::model_dispersion(factor)),
                             2)};
    const auto dispersion = dispersion_of(limits);
    return {dispersion ? Cell(plain_number(*dispersion, 2)) : Cell()};
}

std::string pier_note(const std::string& piers)
{
    return "Drift limit of " + piers + " of walls.";
}

void add_limits(const DriftData& data, std::size_t g, std::size_t state, Table& t)
{
    const DriftGroup& group = data.groups[g];
    const auto observations = limits_of(group, state);
    const LimitDrifts limits = limit_drifts(data, g, state);
    const fragility::PerformanceLimits& law = limits.law;
    const std::string pier = pier_text(data, g, state);
    const auto add = [&](const Row& cells, std::string note) {
        const std::string more = inaccurate_text(group, state);
        if (!pier.empty()) note += (note.empty() ? "" : " ") + pier_note(pier);
        add_row(t, cells, note + (note.empty() || more.empty() ? "" : " ") + more);
    };
    const double tested = limits.quantiles.tested_to;
    const double end = std::isfinite(tested) ? tested : known_to(observations);
    const bool any = law.n > 0.0;
    Row row = {group_cell(group),
               names_of(data, state),
               count(law.n),
               any ? plain_number(100.0 * law.censored_share, 0) : Number{},
               any ? plain_number(end, decimals_for(end)) : Number{},
               source_text(limits.quantiles)};
    if (const std::string limit = limit_text(data, g, state); !limit.empty()) {
        const bool alone = only_limits(observations);
        row.back() = alone ? "limit" : "observed";
        add_quantiles(limits, fragility::caps(observations), row);
        return add(
            row,
            limit + (alone ? "." : ": the drifts are those observed (Kaplan-Meier), no law."));
    }
    const bool mixed = fragility::is_mixture(limits.quantiles.source);
    if (!law.fitted && !mixed) {
        row.back() = Cell();
        const int d = decimals_for(law.bound.median_above);
        return add(joined(row, {{}, {}, median_bound(law.bound, d)}), without_fit(law, group));
    }
    add_quantiles(limits, {}, row);
    const auto factor = pier.empty() ? group.model.factor : fragility::ModelFactor{};
    add(joined(row, dispersion_cells(limits, factor)), source_note(limits));
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

/// Levels and the stresses half-way between them.
std::vector<double> asked_stresses(const DriftData& data)
{
    std::vector<double> stresses;
    for (const DriftGroup& g : data.groups)
        if (g.stress) stresses.push_back(*g.stress);
    std::ranges::sort(stresses);
    std::vector<double> asked;
    for (std::size_t i = 0; i < stresses.size(); ++i) {
        if (i > 0) asked.push_back(0.5 * (stresses[i - 1] + stresses[i]));
        asked.push_back(stresses[i]);
    }
    return asked;
}

/// Drift up to which walls were tested under this stress; between two levels, under either.
double known_near(const DriftData& data, std::size_t state, double stress)
{
    const DriftGroup *below = nullptr, *above = nullptr;
    for (const DriftGroup& g : data.groups) {
        if (*g.stress <= stress && (!below || *g.stress > *below->stress)) below = &g;
        if (*g.stress >= stress && (!above || *g.stress < *above->stress)) above = &g;
    }
    double end = 0.0;
    for (const DriftGroup* const g : {below, above})
        if (g) end = std::max(end, known_to(limits_of(*g, state)));
    return end;
}

/// "0.4 MPa and 0.6 MPa": whose lognormal law the tests reject.
std::string rejected_stresses(const DriftData& data, std::size_t state)
{
    std::string text;
    for (std::size_t g = 0; g < data.groups.size(); ++g)
        if (rejected(judged_lognormal(data, g, state)))
            text += (text.empty() ? "" : " and ") + data.groups[g].name;
    return text;
}

double tested_end(double upper, double end)
{
    return fragility::is_known(upper, end) ? upper : core::kInfinity;
}

/// "> 2.72" where the value lies beyond the drift tested.
Number tested_cell(double value, const core::Interval& i, int decimals, double end)
{
    if (fragility::is_known(value, end))
        return with_interval(value, i.lower, tested_end(i.upper, end), decimals);
    return {.lower = std::min(i.lower, end), .decimals = decimals, .sense = Sense::above};
}

void add_model(const DriftData& data, std::size_t state, Table& t)
{
    const std::string name = state_name(data.states[state]);
    if (const std::string who = rejected_stresses(data, state); !who.empty())
        return add_row(t, {name},
                       "No model: the goodness-of-fit tests reject the lognormal law at " +
                           who + ".");
    std::vector<fragility::StressedObservation> observations;
    for (const DriftGroup& g : data.groups)
        for (const Observation& o : limits_of(g, state)) observations.push_back({*g.stress, o});
    const fragility::StressModel model = fragility::fit_stress_model(observations);
    if (model.outcome != fragility::FitOutcome::converged)
        return add_row(t, {name}, "No model: " + model.reason + ".");
    for (const double stress : asked_stresses(data)) {
        const auto p = fragility::predict(model, stress, data.options.confidence);
        const auto at = fragility::at_stress(model, stress);
        const int d = decimals_for(p.median);
        const double end = known_near(data, state, stress);
        add_row(t, {name, given(stress), count(model.median_terms.size() - 1),
                    count(model.dispersion_terms.size() - 1),
                    tested_cell(p.median, p.confidence, d, end),
                    Number{.lower = p.prediction.lower,
                           .upper = tested_end(p.prediction.upper, end),
                           .decimals = d},
                    plain_number(end, decimals_for(end)),
                    with_error(at.law.dispersion,
                               at.law.dispersion * std::sqrt(at.covariance(1, 1)), 2)});
    }
}

} // namespace

Table performance_table(const DriftData& data)
{
    Table t = titled_table("performance_limits", words_of(data));
    if (!data.no_limit.empty()) t.caption += " " + data.no_limit;
    t.keys = 2;
    t.head = {data.group_head,
              "limit state",
              "n",
              "censored [%]",
              {drift_head(data, "tested up to"), kDetail},
              {"drifts from", kProgramsOnly}};
    for (const char* const share :
         {"5 % drift", "16 % drift", "median drift", "84 % drift", "95 % drift"}) {
        const bool median = std::string_view(share) == "median drift";
        t.head.emplace_back(drift_head(data, share),
                            kInterval | kCensored | (median ? 0U : unsigned{kDetail}));
    }
    t.head.insert(t.head.end(), {{"dispersion", kInterval},
                                 {"std error of ln median", kProgramsOnly},
                                 {"total dispersion", kProgramsOnly},
                                 {"note", kNote}});
    add_rows(data, add_limits, t);
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
    add_rows(data, add_tests, t);
    return t;
}

Table stress_table(const DriftData& data)
{
    Table t = titled_table("stress_model", words_of(data));
    t.keys = 2;
    t.head = {"limit state",
              "stress [MPa]",
              "degree of ln median",
              "degree of ln dispersion",
              {drift_head(data, "median"), kInterval | kCensored},
              {drift_head(data, "prediction interval"), kRange},
              drift_head(data, "tested up to"),
              {"dispersion", kError},
              {"note", kNote}};
    for (const DriftGroup& g : data.groups)
        if (!g.stress) return t;
    for (std::size_t s = 0; s < data.states.size(); ++s) add_model(data, s, t);
    return t;
}

} // namespace app
