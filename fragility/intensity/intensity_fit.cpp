#include "fragility/intensity/intensity_fit.hpp"

#include "core/fit_factors.hpp"
#include "fragility/fits/censored_fit.hpp"
#include "fragility/intensity/ida.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <utility>

namespace fragility {
namespace {

constexpr double kUnknownError = std::numeric_limits<double>::quiet_NaN();

bool has_reached(const ShakenWallPoint& p, double threshold)
{
    return p.fell || p.response > threshold;
}

IntensityFit no_curve(ModelOutcome outcome, std::string reason)
{
    IntensityFit f;
    f.outcome = outcome;
    f.reason = std::move(reason);
    return f;
}

/// The curve of a probit that rises.
IntensityFit rising(const CollapseFit& probit)
{
    if (probit.outcome != ModelOutcome::converged)
        return no_curve(probit.outcome, probit.reason);
    if (!(probit.slope > 0.0))
        return no_curve(ModelOutcome::wrong_slope, "fewer reach it as the intensity grows");
    IntensityFit f;
    f.outcome = ModelOutcome::converged;
    f.curve = {std::exp(-probit.constant / probit.slope), 1.0 / probit.slope};
    return f;
}

IntensityFit fit_stripes(std::span<const ShakenWallPoint> points, double threshold)
{
    std::map<std::pair<double, bool>, double> counts; // equal histories are one with a weight
    double reached = 0.0;
    // the lowest intensity that reached the threshold, and the highest that did not
    double lowest = std::numeric_limits<double>::infinity(), highest = 0.0;
    for (const ShakenWallPoint& p : points) {
        const bool yes = has_reached(p, threshold);
        if (yes)
            lowest = std::min(lowest, p.intensity);
        else
            highest = std::max(highest, p.intensity);
        counts[{p.intensity, yes}] += 1.0;
        reached += yes ? 1.0 : 0.0;
    }
    std::vector<CloudPoint> rows;
    for (const auto& [at, n] : counts) rows.push_back({at.first, {1.0, 1.0, n}, at.second});
    CollapseFit probit = fit_collapse(rows, Link::probit);
    if (probit.outcome == ModelOutcome::absent_mode)
        probit.reason = reached == 0.0 ? "no history reaches it" : "all histories reach it";
    else if (probit.outcome == ModelOutcome::separated)
        probit.reason = lowest == highest
                            ? "histories differ at a single intensity; add intensities near it"
                            : "the intensity tells without error which histories reach it";
    IntensityFit f = rising(probit);
    f.n = static_cast<double>(points.size());
    f.reached = reached;
    return f;
}

IntensityFit fit_capacities(std::span<const ShakenWallPoint> points, double threshold)
{
    std::vector<Observation> capacities;
    double reached = 0.0;
    for (const PairCapacity& c : pair_capacities(points, threshold)) {
        capacities.push_back(c.capacity);
        reached += std::isfinite(c.capacity.upper) ? 1.0 : 0.0;
    }
    const Fit law = fit(Law::lognormal, capacities);
    IntensityFit f;
    if (law.outcome == FitOutcome::converged) {
        f.outcome = ModelOutcome::converged;
        f.curve = {std::exp(law.law.location), law.law.dispersion};
    } else {
        f = no_curve(ModelOutcome::not_converged, law.reason);
    }
    f.n = static_cast<double>(capacities.size());
    f.reached = reached;
    return f;
}

/// Walls that fell lie above what was seen of them.
IntensityFit fit_bounded_cloud(std::span<const ShakenWallPoint> points, double threshold,
                               double least)
{
    std::vector<CloudPoint> cloud;
    double reached = 0.0;
    for (const ShakenWallPoint& p : points) {
        reached += has_reached(p, threshold) ? 1.0 : 0.0;
        const double seen = std::max(p.response, least);
        cloud.push_back({p.intensity,
                         p.fell               ? right_censored(seen)
                         : p.response < least ? left_censored(least)
                                              : observed(seen),
                         p.fell});
    }
    IntensityFit f;
    if (!std::isfinite(threshold)) {
        f = rising(fit_collapse(cloud, Link::probit));
    } else {
        const CloudFit line = fit_cloud(cloud);
        if (line.outcome != ModelOutcome::converged)
            f = no_curve(line.outcome, line.reason);
        else if (!(line.slope > 0.0))
            f = no_curve(ModelOutcome::wrong_slope,
                         "the response falls as the intensity grows");
        else {
            f.outcome = ModelOutcome::converged;
            f.curve = cloud_curve(line, threshold);
        }
    }
    f.n = static_cast<double>(points.size());
    f.reached = reached;
    return f;
}

/// The cluster of a point: its record, or its wall.
using ClusterOf = std::size_t ShakenWallPoint::*;

std::set<std::size_t> clusters(std::span<const ShakenWallPoint> points, ClusterOf of)
{
    std::set<std::size_t> all;
    for (const ShakenWallPoint& p : points) all.insert(p.*of);
    return all;
}

/// Variances of ln median and ln dispersion.
struct JackknifeVariance {
    double median = kUnknownError, dispersion = kUnknownError;
    double freedom = 0.0;
};

JackknifeVariance jackknife(IntensityMethod method, std::span<const ShakenWallPoint> points,
                            double threshold, double least, ClusterOf of)
{
    const std::set<std::size_t> all = clusters(points, of);
    const auto n = static_cast<double>(all.size());
    std::vector<IntensityCurve> without;
    for (const std::size_t left_out : all) {
        std::vector<ShakenWallPoint> rest;
        for (const ShakenWallPoint& p : points)
            if (p.*of != left_out) rest.push_back(p);
        const IntensityFit f = fit_intensity(method, rest, threshold, least);
        if (f.outcome != ModelOutcome::converged) return {};
        without.push_back(f.curve);
    }
    const auto variance = [&](double IntensityCurve::*member) {
        double mean = 0.0, sum = 0.0;
        for (const IntensityCurve& c : without) mean += std::log(c.*member) / n;
        for (const IntensityCurve& c : without) {
            const double d = std::log(c.*member) - mean;
            sum += d * d;
        }
        return (n - 1.0) / n * sum;
    };
    return {variance(&IntensityCurve::median), variance(&IntensityCurve::dispersion), n - 1.0};
}

/// Whether some record shakes several walls and some wall is shaken by several records.
bool is_crossed(std::span<const ShakenWallPoint> points)
{
    std::map<std::size_t, std::size_t> record_of;
    for (const ShakenWallPoint& p : points) {
        const auto [at, first] = record_of.try_emplace(p.wall, p.record);
        if (!first && at->second != p.record) return true;
    }
    return false;
}

core::Interval student_interval(double value, double a, double b, double freedom_a,
                                double freedom_b, double confidence)
{
    const double v = a + b;
    double freedom = a * a / freedom_a + (b > 0.0 ? b * b / freedom_b : 0.0);
    freedom = v > 0.0 ? std::max(1.0, v * v / freedom) : freedom_a;
    const double half = std::sqrt(v) * core::fit_student_factor(confidence, freedom);
    return {value * std::exp(-half), value * std::exp(half), confidence};
}

} // namespace

std::vector<PairCapacity> pair_capacities(std::span<const ShakenWallPoint> points,
                                          double threshold)
{
    std::map<std::pair<std::size_t, std::size_t>, std::vector<IdaStep>> pairs;
    for (const ShakenWallPoint& p : points)
        pairs[{p.wall, p.record}].push_back({p.intensity, p.response, p.fell});
    std::vector<PairCapacity> all;
    for (auto& [pair, steps] : pairs) {
        std::ranges::sort(steps, {}, &IdaStep::intensity);
        // A record that is there twice gives the same intensity twice.
        const auto twice =
            std::unique(steps.begin(), steps.end(), [](const IdaStep& a, const IdaStep& b) {
                return a.intensity == b.intensity;
            });
        steps.erase(twice, steps.end());
        all.push_back({pair.first, pair.second, ida_capacity(steps, threshold)});
    }
    return all;
}

IntensityFit fit_intensity(IntensityMethod method, std::span<const ShakenWallPoint> points,
                           double threshold, double least)
{
    if (points.empty()) return no_curve(ModelOutcome::no_data, "no histories");
    switch (method) {
    case IntensityMethod::stripes:
        return fit_stripes(points, threshold);
    case IntensityMethod::ida:
        return fit_capacities(points, threshold);
    case IntensityMethod::cloud:
        return fit_bounded_cloud(points, threshold, least);
    }
    __builtin_unreachable();
}

ClusteredFit fit_clustered(IntensityMethod method, std::span<const ShakenWallPoint> points,
                           double threshold, double least, double confidence)
{
    ClusteredFit c;
    c.fit = fit_intensity(method, points, threshold, least);
    c.records = clusters(points, &ShakenWallPoint::record).size();
    c.walls = clusters(points, &ShakenWallPoint::wall).size();
    c.crossed = c.walls > 1 && is_crossed(points);
    c.record_error = c.wall_error = kUnknownError;
    c.median = c.dispersion = {0.0, core::kInfinity, confidence};
    if (c.fit.outcome != ModelOutcome::converged) {
        c.reason = c.fit.reason;
        return c;
    }
    if (c.records < 2 && c.walls < 2) {
        c.reason = "one record and one wall have no scatter";
        return c;
    }
    JackknifeVariance of_records{0.0, 0.0, 1.0}, of_walls{0.0, 0.0, 1.0};
    if (c.records > 1)
        of_records = jackknife(method, points, threshold, least, &ShakenWallPoint::record);
    if (c.crossed || c.records == 1)
        of_walls = jackknife(method, points, threshold, least, &ShakenWallPoint::wall);
    if (std::isnan(of_records.median) || std::isnan(of_walls.median)) {
        c.reason = "without one of its records or walls it has no curve";
        return c;
    }
    c.record_error = std::sqrt(of_records.median);
    c.wall_error = std::sqrt(of_walls.median);
    c.median = student_interval(c.fit.curve.median, of_records.median, of_walls.median,
                                of_records.freedom, of_walls.freedom, confidence);
    c.dispersion =
        student_interval(c.fit.curve.dispersion, of_records.dispersion, of_walls.dispersion,
                         of_records.freedom, of_walls.freedom, confidence);
    return c;
}

} // namespace fragility
