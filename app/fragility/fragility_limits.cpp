#include "app/fragility/fragility_limits.hpp"

#include "app/input/number_text.hpp"
#include "app/study/fragility_text.hpp"
#include "fragility/goodness_of_fit.hpp"
#include "fragility/performance_limits.hpp"
#include "fragility/stress_model.hpp"
#include "uq/designs/stream.hpp"

#include <cmath>

namespace app {
namespace {

using fragility::Observation;

constexpr std::array kLaws = {fragility::Law::lognormal, fragility::Law::normal,
                              fragility::Law::weibull, fragility::Law::gamma};

std::vector<std::string> with_start(const DriftGroup& group, const DriftState& state)
{
    return {group_cell(group), state.set.empty() ? state.name : state.set + " " + state.name};
}

std::string count_text(double n) { return number(n, 12); }

/// What can be said without a fit: "not identifiable: median > 2.73".
std::string without_fit(const fragility::PerformanceLimits& limits, const DriftGroup& group)
{
    if (limits.n == 0.0)
        return group.walls.empty() ? "no wall gave a result" : "not defined on any curve";
    const std::string bound =
        median_bound(limits.bound, decimals_for(limits.bound.median_above));
    return "not identifiable" + (bound.empty() ? "" : ": median " + bound);
}

void add_limits(const DriftData& data, const DriftGroup& group, std::size_t state, Table& t)
{
    const auto observations = limits_of(group, state);
    const auto limits =
        fragility::performance_limits(data.options.law, observations, data.options.confidence);
    auto row = with_start(group, data.states[state]);
    row.push_back(count_text(limits.n));
    row.push_back(limits.n > 0.0 ? fixed(100.0 * limits.censored_share, 0) : "");
    const double end = known_to(observations);
    row.push_back(limits.n > 0.0 ? rounded_down(end, decimals_for(end)) : "");
    if (!limits.fitted) {
        row.insert(row.end(),
                   {"", "", without_fit(limits, group), "", "", "", "", "", limits.reason});
        t.rows.push_back(row);
        return;
    }
    for (const fragility::DriftLimit& d : limits.drifts)
        row.push_back(
            with_interval(d.drift, d.interval, decimals_for(limits.drifts[2].drift), end));
    row.push_back(with_interval(limits.dispersion, limits.dispersion_interval, 2));
    row.push_back(fixed(limits.median_error, 3));
    row.push_back(fixed(limits.predictive_dispersion, 2));
    row.emplace_back();
    t.rows.push_back(row);
}

std::string states_text(const DriftData& data)
{
    std::string text;
    for (const DriftState& s : data.states)
        text += (text.empty() ? "" : "; ") + s.name + ": " + s.rule;
    return text;
}

/// The same for all limit states of a group: equal drifts have equal p-values.
fragility::RandomBits bits_of(const DriftOptions& options, std::size_t group)
{
    const std::uint64_t seed = uq::replicate_seed(options.seed, group);
    return [seed](std::uint64_t replicate, std::uint64_t draw) {
        return uq::bits(seed, replicate, uq::Purpose::bootstrap, draw);
    };
}

void add_fits(const DriftData& data, std::size_t g, std::size_t state, Table& t)
{
    const auto observations = limits_of(data.groups[g], state);
    auto row = with_start(data.groups[g], data.states[state]);
    row.push_back(std::to_string(observations.size()));
    std::string note;
    for (const fragility::Law law : kLaws) {
        const fragility::Fit fit = fragility::fit(law, observations);
        const bool ok = fit.outcome == fragility::FitOutcome::converged;
        row.push_back(ok ? fixed(fit.aic, 1) : "");
        if (law != data.options.law) continue;
        note = ok ? "" : fit.reason;
    }
    const fragility::Fit fit = fragility::fit(data.options.law, observations);
    if (fit.outcome != fragility::FitOutcome::converged || data.options.bootstrap < 1) {
        row.insert(row.end(), {"", "", "", "", "", "", note});
        t.rows.push_back(row);
        return;
    }
    const auto good = fragility::goodness_of_fit(fit, observations, bits_of(data.options, g),
                                                 data.options.bootstrap);
    if (good.available) {
        row.insert(
            row.end(),
            {fixed(good.distance.kolmogorov_smirnov, 3), fixed(good.p_kolmogorov_smirnov, 3),
             fixed(good.distance.cramer_von_mises, 3), fixed(good.p_cramer_von_mises, 3),
             fixed(good.distance.anderson_darling, 3), fixed(good.p_anderson_darling, 3), ""});
    } else {
        row.insert(row.end(), {"", "", "", "", "", "", "no test: " + good.reason});
    }
    t.rows.push_back(row);
}

/// Levels and the stresses half-way between them.
std::vector<double> asked_stresses(const DriftData& data)
{
    std::vector<double> stresses;
    for (const DriftGroup& g : data.groups)
        if (g.stress) stresses.push_back(*g.stress);
    std::sort(stresses.begin(), stresses.end());
    std::vector<double> asked;
    for (std::size_t i = 0; i < stresses.size(); ++i) {
        if (i > 0) asked.push_back(0.5 * (stresses[i - 1] + stresses[i]));
        asked.push_back(stresses[i]);
    }
    return asked;
}

/// Drift up to which walls were seen under this stress; between two levels, under either.
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

void add_model(const DriftData& data, std::size_t state, Table& t)
{
    std::vector<fragility::StressedObservation> observations;
    for (const DriftGroup& g : data.groups)
        for (const Observation& o : limits_of(g, state)) observations.push_back({*g.stress, o});
    const fragility::StressModel model = fragility::fit_stress_model(observations);
    const auto name = with_start({}, data.states[state])[1];
    if (model.outcome != fragility::FitOutcome::converged) {
        t.rows.push_back({name, "", "", "no model: " + model.reason, "", "", "", ""});
        return;
    }
    const std::string order = std::to_string(model.median_terms.size() - 1) + ", " +
                              std::to_string(model.dispersion_terms.size() - 1);
    for (const double stress : asked_stresses(data)) {
        const auto p = fragility::predict(model, stress, data.options.confidence);
        const auto at = fragility::at_stress(model, stress);
        const int d = decimals_for(p.median);
        const double end = known_near(data, state, stress);
        t.rows.push_back(
            {name, order, number(stress, 6), with_interval(p.median, p.confidence, d, end),
             with_mark(p.prediction.lower, d, end), with_mark(p.prediction.upper, d, end),
             rounded_down(end, decimals_for(end)),
             with_error(at.law.dispersion, at.law.dispersion * std::sqrt(at.covariance(1, 1)),
                        2)});
    }
}

} // namespace

Table performance_table(const DriftData& data)
{
    Table t;
    const std::string law(name(data.options.law));
    t.caption =
        "Performance limits: drifts at which 5 to 95 % of the walls have reached a limit "
        "state. " +
        counts_text(data) + ". " + data.drift + ". " + states_text(data) + ". The " + law +
        " law of all modes together by maximum likelihood; walls that had not "
        "reached the limit state where their curve ends are right-censored there. n: "
        "walls on which the limit state is defined; brackets: " +
        percent_text(data.options.confidence) +
        " intervals by profile likelihood. Dispersion: wall to wall (of ln drift; normal "
        "law: of drift); statistical: standard error of ln median; predictive: both. "
        "Without a fit, a bound of the median without any law, one-sided at the same "
        "confidence (>: walls stood there; >=: they may just have reached it). " +
        extrapolated_text("any wall of the row") +
        " (\"known to\"): it hangs on the law. Failed walls and walls not in this file are "
        "left out.";
    t.head = {data.group_head,
              "limit state",
              "n",
              "censored [%]",
              drift_head(data, "known to"),
              drift_head(data, "5 % drift"),
              drift_head(data, "16 % drift"),
              drift_head(data, "median drift"),
              drift_head(data, "84 % drift"),
              drift_head(data, "95 % drift"),
              "dispersion",
              "statistical",
              "predictive",
              "note"};
    for (const DriftGroup& group : data.groups)
        for (std::size_t s = 0; s < data.states.size(); ++s) add_limits(data, group, s, t);
    return t;
}

Table fit_table(const DriftData& data)
{
    Table t;
    const std::string law(name(data.options.law));
    t.caption =
        "Fit of laws to limit drifts. " + counts_text(data) +
        ". AIC of four laws (least: best; differences below 2 say nothing). D "
        "(Kolmogorov-Smirnov), W2 (Cramer-von Mises), A2 (Anderson-Darling) and their "
        "p-values for the " +
        law + " law, from " + std::to_string(data.options.bootstrap) +
        " samples of the fitted law, refitted, stopped as the walls were. Distances are "
        "from the shares without a law (Kaplan and Meier), up to the largest drift of "
        "any wall: of what lies beyond they say nothing.";
    t.head = {data.group_head, "limit state", "n",       "AIC lognormal", "AIC normal",
              "AIC Weibull",   "AIC gamma",   "D",       "p of D",        "W2",
              "p of W2",       "A2",          "p of A2", "note"};
    for (std::size_t g = 0; g < data.groups.size(); ++g)
        for (std::size_t s = 0; s < data.states.size(); ++s) add_fits(data, g, s, t);
    return t;
}

Table stress_table(const DriftData& data)
{
    Table t;
    t.caption =
        "Limit drifts as functions of the vertical stress: one lognormal law, ln median "
        "and ln dispersion polynomials of the stress (degrees, of median and dispersion: of "
        "least AIC, up to 2), censored maximum likelihood over all levels. " +
        counts_text(data) + ". " + data.drift + ". Median with " +
        percent_text(data.options.confidence) +
        " confidence interval; a further wall lies between \"from\" and \"to\" with that "
        "probability. Only between the lowest and the highest level. " +
        extrapolated_text("any wall at that stress (between levels: at the two beside it)") +
        " (\"known to\"): where all walls stood, it comes from the other stresses alone.";
    t.head = {"limit state",
              "degrees",
              "stress [MPa]",
              drift_head(data, "median"),
              drift_head(data, "a wall from"),
              drift_head(data, "a wall to"),
              drift_head(data, "known to"),
              "dispersion"};
    for (const DriftGroup& g : data.groups)
        if (!g.stress) return t;
    for (std::size_t s = 0; s < data.states.size(); ++s) add_model(data, s, t);
    return t;
}

} // namespace app
