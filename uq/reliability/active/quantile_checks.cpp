#include "uq/reliability/active/quantile_checks.hpp"

#include "core/critical.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace uq {
namespace {

constexpr int kCrossingSteps = 60; ///< of the search for a crossing, each halved further
constexpr int kCrossingHalvings = 20;

double as_seen(const QuantileRound& r, double t)
{
    return std::isinf(r.scale) ? t - r.shift : std::asinh((t - r.shift) / r.scale);
}

/// Probability of each point that y <= t.
Eigen::ArrayXd passing_at(const QuantileRound& r, double t)
{
    const double level = as_seen(r, t);
    Eigen::ArrayXd p(r.points.mean.size());
    for (Eigen::Index i = 0; i < p.size(); ++i) {
        const double sd = std::sqrt(r.points.variance(i) + r.noise);
        const double off = r.points.mean(i) - level;
        p(i) = sd > 0.0 ? 0.5 * std::erfc(off / (std::sqrt(2.0) * sd)) : off <= 0.0;
    }
    return p;
}

/// Sums over the checks of all rounds.
struct CheckSums {
    std::vector<double> value, if_below, if_above; ///< Y of each check; failed ones either way
    double expected = 0.0, points = 0.0, event_weight = 0.0;
};

void add(CheckSums& s, const QuantileRound& r, double t)
{
    const Eigen::ArrayXd p = passing_at(r, t);
    const Eigen::ArrayXd part = r.points.weight.array() * p;
    const double probability = part.sum();
    for (std::size_t k = 0; k < r.rows.size(); ++k) {
        const Eigen::Index i = r.rows[k];
        const double ratio = r.points.weight(i) / r.plan.chance(i);
        const auto y = [&](double below) { return probability + ratio * (below - p(i)); };
        const bool failed = std::isnan(r.y[k]);
        const double below = r.y[k] <= t ? 1.0 : 0.0;
        s.value.push_back(y(failed ? p(i) : below));
        s.if_below.push_back(y(failed ? 1.0 : below));
        s.if_above.push_back(y(failed ? 0.0 : below));
    }
    const auto n = static_cast<double>(r.rows.size()), size = static_cast<double>(p.size());
    const double each =
        (r.points.weight.array().square() / r.plan.chance.array() * p * (1.0 - p)).sum();
    const double variance = (part - part.mean()).square().sum() * size / (size - 1.0);
    s.expected += n * each;
    s.points += n * n * variance;
    s.event_weight += n * r.plan.event_weight;
}

double middle_of(const std::vector<double>& y)
{
    double sum = 0.0;
    for (const double v : y) sum += v;
    return sum / static_cast<double>(y.size());
}

double error_of_mean(const CheckSums& s, const std::vector<double>& y)
{
    const auto n = static_cast<double>(y.size());
    const double middle = middle_of(y);
    double squares = 0.0;
    for (const double v : y) squares += (v - middle) * (v - middle);
    const double unseen = kUnseen * s.event_weight / (n * n);
    return std::sqrt(std::max(squares / (n * (n - 1.0)), s.expected / (n * n)) +
                     s.points / (n * n) + unseen * unseen);
}

} // namespace

double process_below(const QuantileRound& r, double t)
{
    return (r.points.weight.array() * passing_at(r, t)).sum();
}

ProbabilityBelow probability_below(const std::vector<QuantileRound>& rounds, double t,
                                   double confidence)
{
    CheckSums s;
    for (const QuantileRound& r : rounds)
        if (!r.rows.empty()) add(s, r, t);
    const double freedom = static_cast<double>(s.value.size()) - 1.0;
    const auto interval = [&](const std::vector<double>& y) {
        const double value = middle_of(y);
        if (!(value > 0.0)) { // no logarithm: what the error alone allows
            const double z = core::student_factor(confidence, freedom);
            return core::Interval{0.0, std::max(0.0, value + z * error_of_mean(s, y)),
                                  confidence};
        }
        return log_interval(value, error_of_mean(s, y), confidence, freedom);
    };
    return {middle_of(s.value),
            error_of_mean(s, s.value),
            {interval(s.if_above).lower, interval(s.if_below).upper, confidence}};
}

QuantileCrossing crossing(const std::vector<QuantileRound>& rounds, double probability,
                          double least, double most, double confidence)
{
    const auto at = [&](double t) { return probability_below(rounds, t, confidence); };
    const double step = (most - least) / kCrossingSteps;
    std::vector<ProbabilityBelow> p;
    for (int i = 0; i <= kCrossingSteps; ++i) p.push_back(at(least + step * i));
    using Holds = bool (*)(const ProbabilityBelow&, double);
    // The first place after step `before` where the condition holds; at the next step it does.
    const auto refined = [&](int before, Holds holds) {
        double low = least + step * before, high = low + step;
        for (int k = 0; k < kCrossingHalvings; ++k) {
            const double middle = 0.5 * (low + high);
            (holds(at(middle), probability) ? high : low) = middle;
        }
        return high;
    };
    const auto first = [&](int from, Holds holds) {
        while (from <= kCrossingSteps && !holds(p[static_cast<std::size_t>(from)], probability))
            ++from;
        return from;
    };
    const Holds value = [](const ProbabilityBelow& x, double q) { return x.value >= q; };
    const Holds lower = [](const ProbabilityBelow& x, double q) {
        return x.interval.upper >= q;
    };
    const Holds upper = [](const ProbabilityBelow& x, double q) {
        return x.interval.lower >= q;
    };
    QuantileCrossing c;
    const int here = first(0, value);
    if (here > 0 && here <= kCrossingSteps) {
        c.value = refined(here - 1, value);
        const int above = first(here, upper);
        if (above <= kCrossingSteps) c.upper = std::max(*c.value, refined(above - 1, upper));
    }
    int below = std::min(here, kCrossingSteps);
    while (below >= 0 && lower(p[static_cast<std::size_t>(below)], probability)) --below;
    if (below >= 0) c.lower = below < kCrossingSteps ? refined(below, lower) : most;
    if (c.value && c.lower) c.lower = std::min(*c.value, *c.lower);
    return c;
}

} // namespace uq
