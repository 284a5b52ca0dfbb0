#include "app/fragility/numbers/model_doubt.hpp"

#include "app/fragility/numbers/drift_fits.hpp"
#include "app/fragility/numbers/fragility_limits.hpp"
#include "app/fragility/numbers/limit_drifts.hpp"
#include "app/fragility/numbers/sampling_errors.hpp"
#include "app/fragility/numbers/table_texts.hpp"
#include "app/output/table/cells.hpp"
#include "app/text/number_text.hpp"
#include "core/fit_factors.hpp"
#include "core/interval.hpp"
#include "fragility/fits/fit_intervals.hpp"
#include "fragility/fits/observed_quantile.hpp"
#include "fragility/laws/standard_law.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace app {
namespace {

using fragility::DoubtedLimit;
using fragility::Observation;

Number quantile_cell(const fragility::QuantileBounds& bounds, int decimals, double known_to)
{
    if (!(bounds.lower > 0.0) || !std::isfinite(bounds.lower)) return {};
    if (std::isfinite(bounds.upper) && bounds.upper <= bounds.lower * (1.0 + 1e-9))
        return {.value = bounds.lower, .decimals = decimals, .known_to = known_to};
    if (std::isfinite(bounds.upper)) // it depends on what lies beyond the drift tested
        return {.lower = bounds.lower, .upper = bounds.upper, .decimals = decimals};
    return {.lower = bounds.lower, .decimals = decimals, .sense = Sense::at_least};
}

Number dispersion_cell(double x) { return std::isfinite(x) ? plain_number(x, 2) : Number{}; }

/// The cells that both tables share, from the factor on.
Row doubt_cells(const DoubtedLimit& limit, const AppliedFactor& model, double known_to)
{
    const auto& q = limit.quantiles;
    const int d = decimals_for(q[1].lower);
    Number median = quantile_cell(q[1], d, known_to);
    if (median.sense == Sense::equal && std::isfinite(median.value)) {
        median.lower = limit.median_interval.lower;
        median.upper = limit.median_interval.upper;
    }
    return {plain_number(model.factor.median, 2),
            model.source,
            median,
            quantile_cell(q[0], d, known_to),
            quantile_cell(q[2], d, known_to),
            dispersion_cell(limit.dispersion.material),
            dispersion_cell(limit.dispersion.sampling),
            dispersion_cell(limit.dispersion.model),
            dispersion_cell(limit.dispersion.total)};
}

std::string unlike_text(const AppliedFactor& model)
{
    return model.unlike.empty() ? ""
                                : "Not like the walls tested: " + model.unlike +
                                      ". The median of the factor is 1 here.";
}

void add_drift(const DriftData& data, std::size_t g, std::size_t s, Table& t)
{
    const DriftGroup& group = data.groups[g];
    const auto observations = limits_of(group, s);
    Row row = {group_cell(group), names_of_row(data, s), count(observations.size())};
    const std::string code = limit_text(data, g, s), pier = pier_text(data, g, s);
    if (!code.empty()) return add_row(t, row, code + ": no property of the walls.");
    if (!pier.empty())
        return add_row(t, row,
                       "Drift limit of " + pier +
                           " of walls: the error of the model, at the ultimate drift, does not "
                           "concern it.");
    std::string note = unlike_text(group.model);
    if (const LimitDrifts limits = limit_drifts(data, g, s); !identified(limits))
        note = not_identified_text(limits, group) + (note.empty() ? "" : " ") + note;
    const auto limit = doubted_limit(data, g, s);
    if (!limit) return add_row(t, row, note);
    const bool all_reached = std::ranges::all_of(
        observations, [](const Observation& o) { return o.lower == o.upper; });
    const double end =
        all_reached ? kNoEnd : group.model.factor.median * known_to(observations);
    add_row(t, joined(row, doubt_cells(*limit, group.model, end)), note);
}

std::vector<Head> doubt_head(const std::string& median, const std::string& low,
                             const std::string& high)
{
    return {{"model factor", kDetail},
            {"factor from", kProgramsOnly},
            {median, kInterval | kExtrapolated},
            {low, kInterval | kExtrapolated},
            {high, kInterval | kExtrapolated},
            {"material", kDetail},
            {"sampling", kDetail},
            {"model", kDetail},
            {"total", 0},
            {"note", kNote}};
}

/// ln of the peaks: mean, standard deviation and number.
struct LogPeaks {
    double mean = 0.0, sd = 0.0, n = 0.0;
};

LogPeaks log_peaks(const StudyLevel& level)
{
    std::vector<double> logs;
    for (const StudyWall& w : level.walls)
        if (const double peak = peak_force(w.reading); peak > 0.0)
            logs.push_back(std::log(peak / 1e3));
    LogPeaks p{0.0, 0.0, static_cast<double>(logs.size())};
    for (const double x : logs) p.mean += x / p.n;
    for (const double x : logs) p.sd += (x - p.mean) * (x - p.mean);
    p.sd = logs.size() > 1 ? std::sqrt(p.sd / (p.n - 1.0)) : 0.0;
    return p;
}

} // namespace

std::optional<DoubtedLimit> doubted_limit(const DriftData& data, std::size_t g,
                                          std::size_t state)
{
    const DriftGroup& group = data.groups[g];
    const auto observations = limits_of(group, state);
    if (observations.empty() || !limit_text(data, g, state).empty() ||
        !pier_text(data, g, state).empty())
        return {};
    const fragility::ModelFactor& factor = group.model.factor;
    const double confidence = data.options.confidence;
    const LimitDrifts limits = limit_drifts(data, g, state);
    if (!identified(limits)) {
        const fragility::MedianBound& bound = limits.law.bound;
        if (!bound.median_bounded || !(bound.median_above > 0.0)) return {};
        return fragility::bounded_with_model_doubt(bound.median_above, confidence, factor);
    }
    const auto& at = limits.quantiles.at;
    if (at.empty()) return {};
    const core::Interval median = at.at(at.size() / 2).interval;
    if (const fragility::Fit& f = limits.judged.fit; of_one_law(limits.quantiles)) {
        const double error = fragility::uncertain(f, fragility::median()).axis_error;
        return with_model_doubt(f.law, median, positive(f.law.law) ? error : kUnknown, factor);
    }
    const auto walls =
        fragility::drift_distribution(fragility::kaplan_meier(observations, confidence));
    if (walls.drifts.empty()) return {};
    return with_model_doubt(walls, median, kUnknown, factor);
}

Table drift_doubt_table(const DriftData& data)
{
    Words words = words_of(data);
    words["factor"] = data.model_text;
    Table t = titled_table("limits_with_doubt", words);
    t.keys = 2;
    t.head = {data.group_head, "limit state", {"n", kDetail}};
    for (Head& h : doubt_head(drift_head(data, "median drift"), drift_head(data, "16 % drift"),
                              drift_head(data, "84 % drift")))
        t.head.push_back(std::move(h));
    for (std::size_t g = 0; g < data.groups.size(); ++g)
        for (std::size_t s = 0; s < data.states.size(); ++s)
            if (!names_of_row(data, s).empty()) add_drift(data, g, s, t);
    return t;
}

Table force_doubt_table(const StudyWalls& walls)
{
    Words words = words_of(walls);
    words["factor"] = factor_text(walls.study.solver, walls.study.fragility, Answer::force);
    Table t = titled_table("forces_with_doubt", words);
    t.head = {"stress [MPa]", {"n", kDetail}};
    for (Head& h : doubt_head("median peak [kN]", "16 % peak [kN]", "84 % peak [kN]"))
        t.head.push_back(std::move(h));
    for (const StudyLevel& level : walls.levels) {
        const LogPeaks p = log_peaks(level);
        Row row = {stress_cell(level.stress), count(p.n)};
        if (p.n < 2.0) {
            add_row(t, row, "Too few walls gave a result.");
            continue;
        }
        const AppliedFactor model = applied_factor(walls.study, level.stress, Answer::force);
        const SamplingError sampling =
            log_peak_error(walls, level)
                .value_or(SamplingError{p.sd / std::sqrt(p.n), p.n - 1.0});
        const double confidence = walls.study.fragility.confidence;
        const double half =
            core::fit_student_factor(confidence, sampling.freedom) * sampling.error;
        const core::Interval median = {std::exp(p.mean - half), std::exp(p.mean + half),
                                       confidence};
        const fragility::Distribution law{fragility::Law::lognormal, p.mean, p.sd};
        add_row(t,
                joined(row, doubt_cells(with_model_doubt(law, median, sampling.error,
                                                         model.factor, p.n - 1.0),
                                        model, kNoEnd)),
                unlike_text(model));
    }
    return t;
}

} // namespace app
