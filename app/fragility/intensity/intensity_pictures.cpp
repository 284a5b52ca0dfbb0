#include "app/fragility/intensity/intensity_histories.hpp"
#include "app/fragility/intensity/intensity_output.hpp"
#include "app/output/picture/chart_svg.hpp"
#include "app/study/stored/study_walls.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace app {
namespace {

constexpr std::size_t kCurvePoints = 120;
constexpr std::size_t kMostThin = 100; ///< curves of single walls under single records

/// Pictures of drifts, whichever states the study asks for.
const IntensityState kAnyDrift{"drift", IntensityResponse::drift, 0.0};

double largest_intensity(const std::vector<fragility::ShakenWallPoint>& points)
{
    double most = 0.0;
    for (const auto& p : points) most = std::max(most, p.intensity);
    return most;
}

/// Shares of the histories that reached a state, at equal intensities; of intensities that all
/// differ none.
Series share_dots(const std::vector<fragility::ShakenWallPoint>& points, double threshold)
{
    std::map<double, std::pair<double, double>> by; // reached, all
    for (const auto& p : points) {
        // Records that were scaled to one value differ in the last digits.
        const double x = std::stod(std::to_string(p.intensity));
        by[x].first += p.fell || p.response > threshold ? 1.0 : 0.0;
        by[x].second += 1.0;
    }
    Series dots;
    dots.line = LineStyle::none;
    dots.points = true;
    if (2 * by.size() > points.size()) return dots;
    for (const auto& [x, n] : by) {
        dots.x.push_back(x);
        dots.y.push_back(n.first / n.second);
    }
    return dots;
}

NamedPicture curves_of(const IntensityData& data, const std::vector<IntensityFits>& fits,
                       std::size_t level)
{
    Chart c;
    c.title = stress_text(data.histories.levels[level].stress);
    c.x_label = data.measure_name + " [" + data.unit + "]";
    c.y_label = "share that reached the state";
    for (std::size_t s = 0; s < data.states.size(); ++s) {
        const auto points = shaken_points(data, level, data.states[s]);
        const auto chosen = chosen_fit(fits[s]);
        Series dots = share_dots(points, data.states[s].threshold);
        dots.colour = palette(s);
        if (!chosen) {
            if (!dots.x.empty()) dots.name = data.states[s].name;
            c.series.push_back(std::move(dots));
            continue;
        }
        const auto& fit = *fits[s].by[*chosen];
        const auto probability = [&](double x, double median) {
            return fragility::share_reached({median, fit.fit.curve.dispersion}, x);
        };
        Series line;
        line.name = data.states[s].name + ", " + kIntensityMethods[*chosen].second;
        line.colour = palette(s);
        Series low, high;
        low.colour = high.colour = palette(s);
        low.line = high.line = LineStyle::dotted;
        low.width = high.width = 1.0;
        const double most = largest_intensity(points);
        for (std::size_t i = 1; i <= kCurvePoints; ++i) {
            const double x = most * static_cast<double>(i) / static_cast<double>(kCurvePoints);
            line.x.push_back(x);
            line.y.push_back(probability(x, fit.fit.curve.median));
            if (!fit.reason.empty()) continue;
            low.x.push_back(x);
            high.x.push_back(x);
            low.y.push_back(probability(x, fit.median.upper));
            high.y.push_back(probability(x, fit.median.lower));
        }
        for (Series* const one : {&line, &low, &high, &dots}) c.series.push_back(*one);
    }
    return {"fragility_" + level_file(data.histories.levels[level]),
            "Fragility under " + c.title +
                ", with the shares that were seen; dotted: the "
                "interval of the median",
            line_chart(c)};
}

NamedPicture ida_of(const IntensityData& data, std::size_t level)
{
    Chart c;
    c.title = stress_text(data.histories.levels[level].stress);
    c.x_label = "largest drift [%]";
    c.y_label = data.measure_name + " [" + data.unit + "]";
    std::map<std::pair<std::size_t, std::size_t>, std::vector<std::pair<double, double>>> pairs;
    for (const auto& p : shaken_points(data, level, kAnyDrift))
        if (!p.fell) pairs[{p.wall, p.record}].emplace_back(p.intensity, 100.0 * p.response);
    std::size_t drawn = 0;
    for (auto& [pair, steps] : pairs) {
        if (++drawn > kMostThin) break;
        std::ranges::sort(steps);
        Series thin;
        thin.colour = "#b8b8b8";
        thin.width = 0.7;
        thin.points = steps.size() < 2;
        for (const auto& [x, drift] : steps) {
            thin.x.push_back(drift);
            thin.y.push_back(x);
        }
        c.series.push_back(std::move(thin));
    }
    constexpr std::array kNames = {"16 %", "50 %", "84 %"};
    for (std::size_t i = 0; i < kNames.size(); ++i) {
        Series line;
        line.name = kNames[i];
        line.colour = palette(i);
        for (const DriftFractiles& f : drift_fractiles(data, level)) {
            if (!std::isfinite(f.at[i])) continue;
            line.x.push_back(100.0 * f.at[i]);
            line.y.push_back(f.intensity);
        }
        c.series.push_back(std::move(line));
    }
    return {
        "ida_" + level_file(data.histories.levels[level]),
        "Drift against intensity under " + c.title +
            ": walls under records, and the 16, 50 and 84 % drifts; walls that fell are left "
            "out of the thin lines",
        line_chart(c)};
}

NamedPicture cloud_of(const IntensityData& data, std::size_t level)
{
    Chart c;
    c.title = stress_text(data.histories.levels[level].stress);
    c.x_label = data.measure_name + " [" + data.unit + "]";
    c.y_label = "largest drift [%]";
    c.log_x = c.log_y = true;
    Series stood, fell;
    stood.name = "stood";
    fell.name = "fell";
    std::vector<fragility::CloudPoint> points;
    double least = 1e300, largest = 0.0;
    for (const auto& p : shaken_points(data, level, kAnyDrift)) {
        Series& s = p.fell ? fell : stood;
        const double drift = std::max(p.response, kElasticDrift);
        s.x.push_back(p.intensity);
        s.y.push_back(100.0 * drift);
        least = std::min(least, drift);
        largest = std::max(largest, drift);
        points.push_back({p.intensity,
                          p.fell                       ? fragility::right_censored(drift)
                          : p.response < kElasticDrift ? fragility::left_censored(kElasticDrift)
                                                       : fragility::observed(drift),
                          p.fell});
    }
    stood.colour = palette(0);
    fell.colour = palette(1);
    for (Series* const s : {&stood, &fell}) {
        s->line = LineStyle::none;
        s->points = true;
        if (!s->x.empty()) c.series.push_back(*s);
    }
    const fragility::CloudFit f = fragility::fit_cloud(points);
    if (f.outcome == fragility::ModelOutcome::converged && f.slope != 0.0) {
        const auto [low, high] = std::ranges::minmax(
            points, {}, [](const fragility::CloudPoint& p) { return p.intensity; });
        Series line;
        line.name = "median, fallen walls above what was seen";
        line.colour = palette(2);
        for (const double end : {low.intensity, high.intensity}) {
            // not beyond the drifts that were seen
            const double ln_drift = std::clamp(f.intercept + f.slope * std::log(end),
                                               std::log(least), std::log(largest));
            line.x.push_back(std::exp((ln_drift - f.intercept) / f.slope));
            line.y.push_back(100.0 * std::exp(ln_drift));
        }
        c.series.push_back(std::move(line));
    }
    return {"cloud_" + level_file(data.histories.levels[level]),
            "Largest drifts against intensity under " + c.title, line_chart(c)};
}

} // namespace

std::vector<NamedPicture> intensity_pictures(const IntensityData& data,
                                             const AllIntensityFits& fits)
{
    std::vector<NamedPicture> all;
    for (std::size_t l = 0; l < fits.size(); ++l) {
        if (shaken_points(data, l, data.states.front()).empty()) continue;
        all.push_back(curves_of(data, fits[l], l));
        all.push_back(ida_of(data, l));
        all.push_back(cloud_of(data, l));
    }
    return all;
}

} // namespace app
