#include "app/fragility/fragility_limits.hpp"

#include "app/fragility/table_texts.hpp"
#include "app/input/number_text.hpp"
#include "app/study/fragility_text.hpp"
#include "fragility/goodness_of_fit.hpp"
#include "fragility/performance_limits.hpp"
#include "fragility/stress_model.hpp"
#include "uq/designs/stream.hpp"

#include <algorithm>
#include <cmath>

namespace app {
namespace {

using fragility::Observation;

/// Why there are no numbers; the law's own reason where there are walls.
std::string without_fit(const fragility::PerformanceLimits& limits, const DriftGroup& group)
{
    if (limits.n > 0.0) return "Not identifiable: " + limits.reason + ".";
    return group.walls.empty() ? "No wall gave a result."
                               : "The limit state is not defined on any curve.";
}

Row limits_row(const DriftData& data, const DriftGroup& group, std::size_t state)
{
    const auto observations = limits_of(group, state);
    const auto limits =
        fragility::performance_limits(data.options.law, observations, data.options.confidence);
    const double end = known_to(observations);
    const bool any = limits.n > 0.0;
    Row row = {group_cell(group), state_name(data.states[state]), count(limits.n),
               any ? plain_number(100.0 * limits.censored_share, 0) : Number{},
               any ? plain_number(end, decimals_for(end)) : Number{}};
    if (!limits.fitted) {
        const int d = decimals_for(limits.bound.median_above);
        row.insert(row.end(), {{},
                               {},
                               median_bound(limits.bound, d),
                               {},
                               {},
                               {},
                               {},
                               {},
                               without_fit(limits, group)});
        return row;
    }
    const int d = decimals_for(limits.drifts[2].drift);
    for (const fragility::DriftLimit& at : limits.drifts)
        row.emplace_back(with_interval(at.drift, at.interval, d, end));
    row.emplace_back(with_interval(limits.dispersion, limits.dispersion_interval, 2));
    row.emplace_back(plain_number(limits.median_error, 3));
    row.emplace_back(plain_number(limits.predictive_dispersion, 2));
    row.emplace_back();
    return row;
}

/// The same for all limit states of a group: equal drifts have equal p-values.
fragility::RandomBits bits_of(const DriftOptions& options, std::size_t group)
{
    const std::uint64_t seed = uq::replicate_seed(options.seed, group);
    return [seed](std::uint64_t replicate, std::uint64_t draw) {
        return uq::bits(seed, replicate, uq::Purpose::bootstrap, draw);
    };
}

Row fit_row(const DriftData& data, std::size_t g, std::size_t state)
{
    const auto observations = limits_of(data.groups[g], state);
    Row row = {group_cell(data.groups[g]), state_name(data.states[state]),
               count(static_cast<double>(observations.size()))};
    const fragility::Fit fit = fragility::fit(data.options.law, observations);
    std::string note;
    if (fit.outcome != fragility::FitOutcome::converged) {
        note = "No fit: " + fit.reason + ".";
    } else if (data.options.bootstrap > 0) {
        const auto good = fragility::goodness_of_fit(
            fit, observations, bits_of(data.options, g), data.options.bootstrap);
        if (good.available) {
            const auto& d = good.distance;
            for (const double x :
                 {d.kolmogorov_smirnov, good.p_kolmogorov_smirnov, d.cramer_von_mises,
                  good.p_cramer_von_mises, d.anderson_darling, good.p_anderson_darling})
                row.emplace_back(plain_number(x, 3));
            row.emplace_back();
            return row;
        }
        note = "No test: " + good.reason + ".";
    }
    row.insert(row.end(), {{}, {}, {}, {}, {}, {}, note});
    return row;
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

void add_model(const DriftData& data, std::size_t state, Table& t)
{
    std::vector<fragility::StressedObservation> observations;
    for (const DriftGroup& g : data.groups)
        for (const Observation& o : limits_of(g, state)) observations.push_back({*g.stress, o});
    const fragility::StressModel model = fragility::fit_stress_model(observations);
    const std::string name = state_name(data.states[state]);
    if (model.outcome != fragility::FitOutcome::converged) {
        t.rows.push_back({name, {}, {}, {}, {}, {}, {}, {}, "No model: " + model.reason + "."});
        return;
    }
    for (const double stress : asked_stresses(data)) {
        const auto p = fragility::predict(model, stress, data.options.confidence);
        const auto at = fragility::at_stress(model, stress);
        const int d = decimals_for(p.median);
        const double end = known_near(data, state, stress);
        t.rows.push_back({name,
                          given(stress),
                          count(static_cast<double>(model.median_terms.size() - 1)),
                          count(static_cast<double>(model.dispersion_terms.size() - 1)),
                          with_interval(p.median, p.confidence, d, end),
                          Number{.lower = p.prediction.lower,
                                 .upper = p.prediction.upper,
                                 .decimals = d,
                                 .known_to = end},
                          plain_number(end, decimals_for(end)),
                          with_error(at.law.dispersion,
                                     at.law.dispersion * std::sqrt(at.covariance(1, 1)), 2),
                          {}});
    }
}

} // namespace

Table performance_table(const DriftData& data)
{
    Table t = titled_table("performance_limits", words_of(data));
    t.keys = 2;
    t.head = {data.group_head, "limit state", "n", "censored [%]",
              drift_head(data, "tested up to")};
    for (const char* const share :
         {"5 % drift", "16 % drift", "median drift", "84 % drift", "95 % drift"})
        t.head.emplace_back(drift_head(data, share), kInterval | kExtrapolated);
    t.head.insert(t.head.end(), {{"dispersion", kInterval},
                                 {"std error of ln median", kProgramsOnly},
                                 {"total dispersion", kProgramsOnly},
                                 {"note", kNote}});
    for (const DriftGroup& group : data.groups)
        for (std::size_t s = 0; s < data.states.size(); ++s)
            t.rows.push_back(limits_row(data, group, s));
    return t;
}

Table fit_table(const DriftData& data)
{
    Table t = titled_table("goodness_of_fit", words_of(data));
    t.keys = 2;
    t.head = {data.group_head, "limit state",  "n", "D", "p of D", "W2", "p of W2", "A2",
              "p of A2",       {"note", kNote}};
    for (std::size_t g = 0; g < data.groups.size(); ++g)
        for (std::size_t s = 0; s < data.states.size(); ++s)
            t.rows.push_back(fit_row(data, g, s));
    return t;
}

void note_rejected(const Table& fits, Table& limits)
{
    constexpr double kRejected = 0.01;
    for (std::size_t r = 0; r < fits.rows.size(); ++r) {
        double least = 1.0;
        for (std::size_t c = 0; c < fits.head.size(); ++c)
            if (const auto* const p = std::get_if<Number>(&fits.rows[r][c]);
                p && fits.head[c].name.starts_with("p of ") && p->value < least)
                least = p->value;
        if (least < kRejected)
            limits.rows[r].back() =
                "The goodness-of-fit tests reject the law (p = " + number(least, 2) +
                "): its drifts do not describe these walls.";
    }
}

Table stress_table(const DriftData& data)
{
    Table t = titled_table("stress_model", words_of(data));
    t.keys = 2;
    t.head = {"limit state",
              "stress [MPa]",
              "degree of ln median",
              "degree of ln dispersion",
              {drift_head(data, "median"), kInterval | kExtrapolated},
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
