#include "app/report/report_parts.hpp"

#include "app/fragility/fragility_inputs.hpp"
#include "app/text/json_text.hpp"
#include "app/text/number_text.hpp"
#include "core/moments.hpp"
#include "uq/estimates/running_mean.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace app {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

double six_digits(double x) { return std::isfinite(x) ? rounded(x, 6) : kNone; }

/// Values of an input for all walls and joints, in its shown unit.
std::vector<double> values_of(const StudyWalls& study, const StoredInput& input)
{
    std::vector<double> values;
    for (const StudyWall* w : all_walls(study))
        for (std::size_t i = 0; i < input.count; ++i)
            values.push_back(input.scale * w->drawn[input.first + i]);
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
        h["x"].push_back(six_digits(x));
        h["pdf"].push_back(six_digits(density));
    }
}

Json histogram(const StudyWalls& study, const StoredInput& input)
{
    const std::vector<double> values = values_of(study, input);
    Json h = {{"key", input.key}, {"unit", input.unit}, {"values", values.size()}};
    const auto [low, high] = std::ranges::minmax_element(values);
    if (values.size() < 2 || !(*high > *low)) return h;
    const auto n = static_cast<double>(values.size());
    const auto bins = static_cast<std::size_t>(std::clamp(std::sqrt(n) * 1.2, 5.0, 40.0));
    const double width = (*high - *low) / static_cast<double>(bins);
    std::vector<double> density(bins, 0.0);
    for (const double v : values)
        density[std::min(bins - 1, static_cast<std::size_t>((v - *low) / width))] +=
            1.0 / (n * width);
    for (std::size_t i = 0; i <= bins; ++i)
        h["edges"].push_back(six_digits(*low + width * static_cast<double>(i)));
    for (const double d : density) h["density"].push_back(six_digits(d));
    const double beyond = 0.12 * (*high - *low);
    add_density(h, input, *low - beyond, *high + beyond);
    const core::Moments m = core::moments(values);
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
        r["error"].push_back(six_digits(100.0 * m.error));
        r["band"].push_back(six_digits(100.0 * m.band));
    }
    return r;
}

Json bar_of(const uq::Estimate& e)
{
    return {six_digits(e.value), six_digits(e.interval.lower), six_digits(e.interval.upper)};
}

} // namespace

Json histograms_json(const StudyWalls& study)
{
    Json all = Json::array();
    for (const StoredInput& input : study.inputs) all.push_back(histogram(study, input));
    return all;
}

Json running_json(const StudyWalls& study)
{
    Json all = Json::array();
    const WallList everyone = all_walls(study);
    for (std::size_t level = 0; level < study.levels.size(); ++level) {
        WallList walls;
        std::vector<double> peaks;
        for (const StudyWall* w : everyone)
            if (w->key.level == level && walls.size() < kMostRunning) {
                walls.push_back(w);
                peaks.push_back(peak_force(w->reading));
            }
        if (walls.size() < 3) continue;
        for (std::size_t k = 0; k < study.inputs.size(); ++k) {
            const StoredInput& input = study.inputs[k];
            if (!input.marginal || uq::mean(*input.marginal) == 0.0) continue;
            std::vector<double> values;
            for (const StudyWall* w : walls) values.push_back(w->inputs[k] / input.scale);
            const double sd = uq::sd(*input.marginal);
            const uq::Prescribed prescribed{uq::mean(*input.marginal),
                                            input.count == 1 ? sd : core::moments(values).sd};
            all.push_back(running(uq::running_mean(values, prescribed), level, input.key));
        }
        // errors are relative: there are none of walls that carried nothing
        const bool some =
            std::ranges::any_of(peaks, [](double f) { return std::isfinite(f) && f != 0.0; });
        if (some) all.push_back(running(uq::running_mean(peaks), level, "peak force"));
    }
    return all;
}

Json sensitivity_json(const StudyWalls& study)
{
    Json all = Json::array();
    for (std::size_t level = 0; level < study.levels.size(); ++level)
        for (const WallNumber* const response :
             {&wall_number("peak_force"), &wall_number("ultimate_displacement")}) {
            const Influences found = influences(study, study.levels[level], *response);
            Json bars = Json::array();
            for (const Influence& i : found.inputs) {
                if (!i.spearman) continue; // does not vary
                bars.push_back({{"key", i.key}, {"spearman", bar_of(*i.spearman)}});
                if (i.partial) bars.back()["prcc"] = bar_of(*i.partial);
            }
            all.push_back({{"level", level},
                           {"response", words(*response)},
                           {"walls", found.walls},
                           {"bars", bars}});
        }
    return all;
}

} // namespace app
