#include "app/fragility/intensity/intensity_data.hpp"

#include "app/text/config_error.hpp"
#include "app/text/number_text.hpp"
#include "app/text/words.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string_view>

namespace app {
namespace {

std::vector<IntensityState> states_of_study(const FragilityInput& f, bool pushed)
{
    constexpr double kPushShare = 0.8; // of the drift limit of a push: choice
    const auto percent = [](double x) { return number(100.0 * x, 6) + " %"; };
    std::vector<IntensityState> states = {
        {"uplift of " + percent(f.shaken_uplift), IntensityResponse::uplift, f.shaken_uplift}};
    for (const double drift : f.shaken_drifts)
        states.push_back({"drift " + percent(drift), IntensityResponse::drift, drift});
    if (f.pushed_limit > 0.0)
        states.push_back(
            {"drift " + percent(kPushShare * f.pushed_limit) + ", 80 % of the limit of a push",
             IntensityResponse::drift, kPushShare * f.pushed_limit});
    if (pushed)
        states.push_back(
            {"80 % of the limit of its own push", IntensityResponse::pushed, kPushShare});
    for (const double residual : f.shaken_residuals)
        states.push_back(
            {"residual " + percent(residual), IntensityResponse::residual, residual});
    states.push_back(
        {"collapse", IntensityResponse::collapse, std::numeric_limits<double>::infinity()});
    return states;
}

std::optional<ground::Measure> measure_of(std::string_view text)
{
    try {
        return ground::parse_measure(lower_case(trimmed(text)));
    } catch (const std::invalid_argument&) {
        return {};
    }
}

/// The measure that the head of a column names in full: "PGA [g]", "Sa(0.3 s)".
std::optional<ground::Measure> measure_in_head(const std::string& head)
{
    if (const auto all = measure_of(head)) return all;
    return measure_of(head.substr(0, head.find_last_of("[(")));
}

/// Refuses the head of a second column that says that it holds no annual rates.
void check_rates(const Csv& csv, const std::string& head)
{
    const std::string low = lower_case(head);
    const auto has = [&](std::string_view word) { return low.find(word) != std::string::npos; };
    if (has("prob") || has("poe"))
        throw ConfigError(
            csv.path, 1, head,
            "annual rates [1/a] are read here, no probabilities; convert those of T years: "
            "rate = -ln(1 - p) / T");
    if (has("period"))
        throw ConfigError(
            csv.path, 1, head,
            "annual rates [1/a] are read here; convert return periods: rate = 1 / period");
    constexpr std::array<std::string_view, 8> kPerYear = {"1/a",      "1/y",   "1/yr", "1/year",
                                                          "per year", "/year", "a^-1", "yr^-1"};
    const std::size_t begin = low.find_first_of("[(");
    if (begin == std::string::npos) return;
    const std::string unit = low.substr(begin + 1, low.find_first_of("])", begin) - begin - 1);
    if (std::ranges::find(kPerYear, trimmed(unit)) == kPerYear.end())
        throw ConfigError(csv.path, 1, head,
                          "the rates are read in [1/a]; convert the column, and write so");
}

/// True if the head names another measure than `wanted`, if only its kind: "Sa [g]".
bool is_other_measure(const std::string& head, const ground::Measure& wanted)
{
    if (const auto named = measure_in_head(head)) return !(*named == wanted);
    const std::string name(bare_name(head));
    for (const char* const arguments : {"(1 s)", "(1 m, 1 m)"})
        if (const auto named = measure_of(name + arguments)) return named->kind != wanted.kind;
    return false;
}

} // namespace

IntensityData intensity_data(StoredHistories histories, const std::string& measure)
{
    IntensityData d;
    const std::string text = measure.empty() ? histories.study.shaking.measure : measure;
    try {
        d.measure = ground::parse_measure(text);
    } catch (const std::invalid_argument& bad) {
        throw ConfigError("drystone", 0, "--intensity", bad.what());
    }
    d.measure_name = measure_text(d.measure);
    const auto at = std::ranges::find(histories.measures, d.measure_name);
    if (at == histories.measures.end()) {
        std::string there;
        for (const std::string& m : histories.measures)
            there += (there.empty() ? "" : ", ") + m;
        throw ConfigError("drystone", 0, "--intensity",
                          in_quotes(d.measure_name) + " is not in " +
                              in_quotes(histories.name) + "; use one of " + there);
    }
    d.column = static_cast<std::size_t>(at - histories.measures.begin());
    d.unit = measure_unit(d.measure);
    d.unit_value = measure_unit_value(d.measure);
    d.states = states_of_study(histories.study.fragility, histories.study.shaking.push);
    d.confidence = histories.study.fragility.confidence;
    d.histories = std::move(histories);
    return d;
}

std::vector<fragility::HazardPoint> hazard_points(const Csv& csv, const IntensityData& data)
{
    constexpr std::size_t kColumns = 2;
    check_rows(csv);
    if (csv.head.size() != kColumns)
        throw ConfigError(csv.path, 1, "",
                          "has " + std::to_string(csv.head.size()) +
                              " columns; write two: the intensity [" + data.unit +
                              "], and the annual rate at which it is exceeded [1/a]");
    const std::string& head = csv.head.front();
    const std::string_view name = bare_name(head);
    const bool has_unit = name.size() < head.size() && !measure_of(head);
    if (has_unit) {
        const std::string unit = head.substr(name.size());
        if (unit.find("[" + data.unit + "]") == std::string::npos &&
            unit.find("(" + data.unit + ")") == std::string::npos)
            throw ConfigError(csv.path, 1, head,
                              data.measure_name + " is read in [" + data.unit +
                                  "]; convert the column, or choose another --intensity");
    }
    if (is_other_measure(head, data.measure))
        throw ConfigError(csv.path, 1, head,
                          "names another measure than " + data.measure_name +
                              ", on which the curves are; give the hazard of " +
                              data.measure_name + ", or choose another --intensity");
    check_rates(csv, csv.head[1]);
    std::vector<fragility::HazardPoint> points;
    for (const CsvRow& row : csv.rows) {
        const fragility::HazardPoint p{number_at(csv, row, 0), number_at(csv, row, 1)};
        if (!(p.intensity > 0.0)) refuse_cell(csv, row, 0, "must be above 0");
        if (!(p.rate > 0.0)) refuse_cell(csv, row, 1, "must be above 0");
        if (!points.empty() && !(p.intensity > points.back().intensity))
            refuse_cell(csv, row, 0, "must be above that of the row before");
        if (!points.empty() && !(p.rate < points.back().rate))
            refuse_cell(csv, row, 1, "must be below that of the row before");
        points.push_back(p);
    }
    if (points.size() < 2)
        throw ConfigError(csv.path, csv.rows.back().line, "",
                          "a hazard curve has two points or more");
    return points;
}

double response_of(const StoredHistory& h, IntensityResponse of)
{
    switch (of) {
    case IntensityResponse::residual:
        return h.fell ? 0.0 : std::abs(h.residual_drift);
    case IntensityResponse::uplift:
        return h.uplift;
    case IntensityResponse::pushed:
        return h.pushed_limit > 0.0 ? h.max_drift / h.pushed_limit : 0.0;
    case IntensityResponse::drift:
    case IntensityResponse::collapse:
        break;
    }
    return h.max_drift;
}

std::vector<fragility::ShakenWallPoint> shaken_points(const IntensityData& data,
                                                      std::size_t level,
                                                      const IntensityState& state,
                                                      std::optional<dem::FailureMode> mode)
{
    std::vector<fragility::ShakenWallPoint> points;
    for (const StoredHistory& h : data.histories.levels.at(level).histories) {
        if (h.failed || (mode && h.mode != *mode)) continue;
        points.push_back({h.wall, h.record, h.measures.at(data.column) / data.unit_value,
                          response_of(h, state.of), h.fell});
    }
    return points;
}

IntensityFits intensity_fits(const IntensityData& data, std::size_t level,
                             const IntensityState& state, std::optional<dem::FailureMode> mode)
{
    const std::vector<fragility::ShakenWallPoint> points =
        shaken_points(data, level, state, mode);
    IntensityFits fits;
    for (std::size_t i = 0; i < kIntensityMethods.size(); ++i) {
        const auto method = kIntensityMethods[i].first;
        if (method == fragility::IntensityMethod::ida && mode) continue;
        if (method == fragility::IntensityMethod::cloud && state.of != IntensityResponse::drift)
            continue;
        fits.by[i] = fragility::fit_clustered(method, points, state.threshold, kElasticDrift,
                                              data.confidence);
    }
    return fits;
}

std::optional<std::size_t> chosen_fit(const IntensityFits& fits)
{
    for (std::size_t i = 0; i < fits.by.size(); ++i)
        if (fits.by[i] && fits.by[i]->fit.outcome == fragility::ModelOutcome::converged)
            return i;
    return {};
}

} // namespace app
