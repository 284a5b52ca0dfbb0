#include "app/fragility/numbers/fragility_limits.hpp"

#include "app/fragility/numbers/drift_fits.hpp"
#include "app/fragility/numbers/table_texts.hpp"
#include "app/study/answers/fragility_text.hpp"
#include "core/interval.hpp"
#include "fragility/limits/stress_model.hpp"

#include <algorithm>
#include <cmath>

namespace app {
namespace {

using fragility::Observation;

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
