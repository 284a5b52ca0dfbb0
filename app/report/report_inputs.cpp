#include "app/report/report_inputs.hpp"

#include "app/input/number_text.hpp"
#include "uq/estimates/running_mean.hpp"
#include "uq/sensitivity/correlation_measures.hpp"
#include "uq/sensitivity/regression.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace app {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

double rounded(double x) { return std::isfinite(x) ? std::stod(number(x, 6)) : kNone; }

/// Of all walls and joints, shown unit.
std::vector<double> values_of(const ReportStudy& study, const StoredInput& input)
{
    std::vector<double> values;
    for (const ReportWall& w : study.walls)
        for (std::size_t i = 0; i < input.count; ++i)
            values.push_back(input.scale * w.row.inputs[input.first + i]);
    return values;
}

std::string moments_text(double mean, double sd)
{
    return "mean " + number(mean, 4) + ", sd " + number(sd, 3);
}

void add_density(Json& h, const StoredInput& input, double low, double high)
{
    if (!input.marginal || std::holds_alternative<uq::Constant>(input.marginal->shape) ||
        std::holds_alternative<uq::Empirical>(input.marginal->shape))
        return;
    constexpr int kPoints = 121;
    for (int i = 0; i < kPoints; ++i) {
        const double x = low + (high - low) * i / (kPoints - 1);
        const double density = uq::pdf(*input.marginal, x / input.scale) / input.scale;
        if (!std::isfinite(density)) continue;
        h["x"].push_back(rounded(x));
        h["pdf"].push_back(rounded(density));
    }
}

Json histogram(const ReportStudy& study, const StoredInput& input)
{
    const std::vector<double> values = values_of(study, input);
    Json h = {{"key", input.key}, {"unit", input.unit}, {"values", values.size()}};
    const auto [low, high] = std::minmax_element(values.begin(), values.end());
    if (values.size() < 2 || !(*high > *low)) return h;
    const auto n = static_cast<double>(values.size());
    const auto bins = static_cast<std::size_t>(std::clamp(std::sqrt(n) * 1.2, 5.0, 40.0));
    const double width = (*high - *low) / static_cast<double>(bins);
    std::vector<double> density(bins, 0.0);
    for (const double v : values)
        density[std::min(bins - 1, static_cast<std::size_t>((v - *low) / width))] +=
            1.0 / (n * width);
    for (std::size_t i = 0; i <= bins; ++i)
        h["edges"].push_back(rounded(*low + width * static_cast<double>(i)));
    for (const double d : density) h["density"].push_back(rounded(d));
    const double beyond = 0.12 * (*high - *low);
    add_density(h, input, *low - beyond, *high + beyond);
    const uq::Moments m = uq::moments(values);
    h["sampled"] = moments_text(m.mean, m.sd);
    if (input.marginal)
        h["prescribed"] = moments_text(input.scale * uq::mean(*input.marginal),
                                       input.scale * uq::sd(*input.marginal));
    return h;
}

Json running(const std::vector<uq::RunningMean>& means, std::size_t level,
             const std::string& key)
{
    Json r = {{"level", level}, {"key", key}};
    for (const uq::RunningMean& m : means) {
        r["error"].push_back(rounded(100.0 * m.error));
        r["band"].push_back(rounded(100.0 * m.band));
    }
    return r;
}

struct Samples {
    Eigen::MatrixXd x; ///< walls x inputs
    Eigen::VectorXd y;
};

Samples samples_of(const ReportStudy& study, std::size_t level, bool ultimate)
{
    std::vector<const ReportWall*> walls;
    for (const ReportWall* w : study.sound(level))
        if (ultimate ? w->reading == fragility::Reading::observed : std::isfinite(w->peak))
            walls.push_back(w);
    const auto n = static_cast<Eigen::Index>(walls.size());
    const auto d = static_cast<Eigen::Index>(study.inputs.size());
    Samples s{Eigen::MatrixXd(n, d), Eigen::VectorXd(n)};
    for (Eigen::Index i = 0; i < n; ++i) {
        const ReportWall& w = *walls[static_cast<std::size_t>(i)];
        for (Eigen::Index k = 0; k < d; ++k)
            s.x(i, k) = shown_value(study.inputs[static_cast<std::size_t>(k)], w.row);
        s.y(i) = ultimate ? w.ultimate : w.peak;
    }
    return s;
}

Json bar_of(const uq::Estimate& e)
{
    return {rounded(e.value), rounded(e.interval.lower), rounded(e.interval.upper)};
}

Json bars_of(const ReportStudy& study, const Samples& s)
{
    Json bars = Json::array();
    if (s.y.size() < s.x.cols() + 5) return bars;
    const auto fit = uq::regress(s.x, s.y, {.scale = uq::RegressionScale::ranks});
    for (Eigen::Index k = 0; k < s.x.cols(); ++k) {
        const auto place = static_cast<std::size_t>(k);
        const auto rank = uq::spearman(s.x.col(k), s.y);
        if (!rank) continue; // does not vary
        Json bar = {{"key", study.inputs[place].key}, {"spearman", bar_of(*rank)}};
        if (fit && fit->inputs[place].identifiable)
            bar["prcc"] = bar_of(fit->inputs[place].partial);
        bars.push_back(bar);
    }
    return bars;
}

} // namespace

Json histograms_json(const ReportStudy& study)
{
    Json all = Json::array();
    for (const StoredInput& input : study.inputs) all.push_back(histogram(study, input));
    return all;
}

Json running_json(const ReportStudy& study)
{
    Json all = Json::array();
    for (std::size_t level = 0; level < study.head.levels.size(); ++level) {
        std::vector<const WallRow*> rows;
        std::vector<double> peaks;
        for (const ReportWall& w : study.walls) {
            if (w.row.key.level != level || rows.size() >= kMostRunning) continue;
            rows.push_back(&w.row);
            peaks.push_back(w.peak);
        }
        if (rows.size() < 3) continue;
        for (const StoredInput& input : study.inputs) {
            if (!input.marginal || uq::mean(*input.marginal) == 0.0) continue;
            std::vector<double> values;
            for (const WallRow* row : rows)
                values.push_back(shown_value(input, *row) / input.scale);
            const double sd = uq::sd(*input.marginal);
            const uq::Prescribed prescribed{uq::mean(*input.marginal),
                                            input.count == 1 ? sd : uq::moments(values).sd};
            all.push_back(running(uq::running_mean(values, prescribed), level, input.key));
        }
        const bool some =
            std::any_of(peaks.begin(), peaks.end(), [](double f) { return std::isfinite(f); });
        if (some) all.push_back(running(uq::running_mean(peaks), level, "peak force"));
    }
    return all;
}

Json sensitivity_json(const ReportStudy& study)
{
    Json all = Json::array();
    for (std::size_t level = 0; level < study.head.levels.size(); ++level)
        for (const bool ultimate : {false, true}) {
            const Samples s = samples_of(study, level, ultimate);
            all.push_back({{"level", level},
                           {"response", ultimate ? "ultimate displacement" : "peak force"},
                           {"walls", s.y.size()},
                           {"bars", bars_of(study, s)}});
        }
    return all;
}

} // namespace app
