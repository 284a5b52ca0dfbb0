#include "uq/inference/bounded_normal.hpp"

#include "core/gauss_legendre.hpp"
#include "core/normal.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace uq {
namespace {

constexpr double kFar = 30.0; ///< tails beyond it by their series

/// ln P(Z > z), also where the probability is too small for a double.
double log_survival(double z)
{
    if (z < kFar) return std::log(core::normal_survival(z));
    return -0.5 * (z * z + std::log(2.0 * std::numbers::pi)) - std::log(z) +
           std::log1p(-1.0 / (z * z));
}

/// -d ln P(Z > z) / dz
double hazard(double z)
{
    if (z < kFar) return core::normal_density(z) / core::normal_survival(z);
    return z + 1.0 / z - 2.0 / (z * z * z);
}

/// The integrand over x = (d - mean) / deviation of d: exp(height).
struct Bounded {
    std::span<const NoisyBound> bounds;
    double mean, deviation;

    [[nodiscard]] double beyond(double x) const
    {
        double log_p = 0.0;
        for (const NoisyBound& b : bounds)
            log_p += log_survival((b.at - mean - deviation * x) / b.deviation);
        return log_p;
    }
    [[nodiscard]] double height(double x) const { return beyond(x) - 0.5 * x * x; }
};

struct Mode {
    double at, width; ///< 1 / sqrt(-d^2 height / dx^2), at most 1
};

/// The slope of the height falls and is convex: from x = 0, where it is not negative, Newton's
/// steps reach its zero without passing it.
Mode mode_of(const Bounded& f)
{
    constexpr int kMostSteps = 200;
    constexpr double kSettled = 1e-9; // of the width
    Mode mode{0.0, 1.0};
    for (int i = 0; i < kMostSteps; ++i) {
        double slope = -mode.at, curvature = 1.0;
        for (const NoisyBound& b : f.bounds) {
            const double z = (b.at - f.mean - f.deviation * mode.at) / b.deviation;
            const double ratio = f.deviation / b.deviation, h = hazard(z);
            slope += ratio * h;
            curvature += ratio * ratio * h * std::max(0.0, h - z);
        }
        mode.width = 1.0 / std::sqrt(curvature);
        const double step = slope / curvature;
        mode.at += step;
        if (!(step > kSettled * mode.width)) break;
    }
    return mode;
}

/// Edges of panels, ascending, between the places where the integrand is nothing. The mode is
/// one of them: within a panel the integrand rises or falls.
std::vector<double> panel_edges(const Bounded& f, const Mode& mode)
{
    constexpr double kNothing = 36.0; // in ln
    constexpr double kFirst = 1.5, kLonger = 3.0;
    constexpr int kMostPanels = 60;
    const double least = f.height(mode.at) - kNothing;
    std::vector<double> edges = {mode.at};
    for (const double side : {-1.0, 1.0}) {
        double width = kFirst * mode.width;
        do edges.push_back(mode.at + side * width);
        while (f.height(edges.back()) > least && (width *= kLonger) > 0.0);
    }
    std::ranges::sort(edges);
    const double from = edges.front(), to = edges.back();
    for (const NoisyBound& b : f.bounds) {
        const double at = (b.at - f.mean) / f.deviation;
        double width = 2.0 * b.deviation / f.deviation;
        for (int i = 0; i < kMostPanels && (at - width > from || at + width < to); ++i) {
            for (const double edge : {at - width, at + width})
                if (edge > from && edge < to) edges.push_back(edge);
            width *= kLonger;
        }
    }
    std::ranges::sort(edges);
    return edges;
}

/// Integrals of the panels between the edges, over exp(highest).
std::vector<double> panel_integrals(const Bounded& f, const std::vector<double>& edges,
                                    double highest)
{
    std::vector<double> all;
    for (std::size_t p = 0; p + 1 < edges.size(); ++p) {
        const double half = 0.5 * (edges[p + 1] - edges[p]), middle = edges[p] + half;
        double sum = 0.0;
        for (std::size_t i = 0; i < core::kGauss16.node.size(); ++i)
            for (const double side : {-1.0, 1.0})
                sum +=
                    half * core::kGauss16.weight[i] *
                    std::exp(f.height(middle + side * half * core::kGauss16.node[i]) - highest);
        all.push_back(sum);
    }
    return all;
}

/// From the panels: one of them by its integral, and in it by rejection under its higher end.
double drawn_from_panels(const Bounded& f, Stream& random)
{
    const Mode mode = mode_of(f);
    const std::vector<double> edges = panel_edges(f, mode);
    const std::vector<double> integrals = panel_integrals(f, edges, f.height(mode.at));
    double left = 0.0;
    for (const double i : integrals) left += i;
    left *= random.uniform();
    std::size_t p = 0;
    while (p + 1 < integrals.size() && (left -= integrals[p]) > 0.0) ++p;
    const double top = std::max(f.height(edges[p]), f.height(edges[p + 1]));
    double x = 0.0;
    do x = edges[p] + (edges[p + 1] - edges[p]) * random.uniform();
    while (!(random.uniform() < std::exp(f.height(x) - top)));
    return x;
}

} // namespace

double log_beyond(std::span<const NoisyBound> bounds, double mean, double variance)
{
    if (bounds.empty()) return 0.0;
    if (const NoisyBound& first = bounds.front(); bounds.size() == 1)
        return log_survival((first.at - mean) /
                            std::sqrt(variance + first.deviation * first.deviation));
    const Bounded f{bounds, mean, std::sqrt(variance)};
    if (variance == 0.0) return f.beyond(0.0);
    const Mode mode = mode_of(f);
    const double highest = f.height(mode.at);
    double total = 0.0;
    for (const double i : panel_integrals(f, panel_edges(f, mode), highest)) total += i;
    return highest + std::log(total) - 0.5 * std::log(2.0 * std::numbers::pi);
}

double draw_beyond(std::span<const NoisyBound> bounds, double mean, double variance,
                   Stream& random)
{
    constexpr int kTries = 1000;
    const Bounded f{bounds, mean, std::sqrt(variance)};
    // first without the bounds, kept as often as they hold
    for (int i = 0; i < kTries; ++i) {
        const double x = random.normal();
        if (bounds.empty() || random.uniform() < std::exp(f.beyond(x)))
            return mean + f.deviation * x;
    }
    if (variance == 0.0) return mean;
    return mean + f.deviation * drawn_from_panels(f, random);
}

} // namespace uq
