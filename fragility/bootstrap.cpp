#include "fragility/bootstrap.hpp"

#include "fragility/resampling.hpp"
#include "fragility/standard_law.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace fragility {
namespace {

constexpr std::size_t kFewestRefits = 20;

/// One for each wall: an observation of weight 3 is three.
std::vector<std::size_t> whole_walls(std::span<const Observation> data)
{
    std::vector<std::size_t> walls;
    for (std::size_t i = 0; i < data.size(); ++i) {
        if (data[i].weight != std::floor(data[i].weight))
            throw std::invalid_argument(
                "bootstrap: weights must be whole numbers, observation " +
                std::to_string(i + 1) + " has " + std::to_string(data[i].weight));
        walls.insert(walls.end(), static_cast<std::size_t>(data[i].weight), i);
    }
    return walls;
}

/// Enough spread and information left for a fit, without building the observations again.
bool fittable(const CensoredSample& s)
{
    std::size_t entries = 0;
    double informative = 0.0;
    double left = 0.0;
    double n = 0.0;
    double highest_lower = -1e300;
    double lowest_upper = 1e300;
    for (std::size_t i = 0; i < s.weight.size(); ++i) {
        if (s.weight[i] == 0.0) continue;
        ++entries;
        n += s.weight[i];
        const bool is_right = i >= s.observed && i < s.observed + s.right;
        const bool is_left = i >= s.observed + s.right && i < s.observed + s.right + s.left;
        if (!is_right && !is_left) informative += s.weight[i];
        if (is_left) left += s.weight[i];
        if (!is_left) highest_lower = std::max(highest_lower, s.lower[i]);
        if (!is_right) lowest_upper = std::min(lowest_upper, s.upper[i]);
    }
    informative += std::min(left, n - left);
    return entries >= 2 && informative >= kFewestInformative && n >= kFewestWalls &&
           highest_lower > lowest_upper + 1e-9;
}

void keep(Bootstrap& b, const Fit& f)
{
    if (f.outcome == FitOutcome::converged)
        b.laws.push_back(f.law);
    else
        ++b.failed;
}

void resample_walls(Bootstrap& b, CensoredSample sample,
                    std::span<const std::size_t> observation_of, const RandomBits& bits,
                    std::size_t replicates)
{
    std::vector<std::size_t> entry_of;
    for (const std::size_t i : observation_of) entry_of.push_back(sample.entry[i]);
    for (std::size_t r = 0; r < replicates; ++r) {
        draw_walls(sample.weight, entry_of, bits, r);
        if (fittable(sample))
            keep(b, fit(sample, &b.estimate));
        else
            ++b.failed;
    }
}

void resample_law(Bootstrap& b, std::span<const Observation> data,
                  std::span<const std::size_t> observation_of, const RandomBits& bits,
                  std::size_t replicates)
{
    std::vector<Observation> walls;
    for (const std::size_t i : observation_of) {
        const Censoring kind = censoring(data[i], positive(b.estimate.law));
        if (kind == Censoring::left || kind == Censoring::interval)
            throw std::invalid_argument(
                "bootstrap: left- and interval-censored data can only be resampled as walls");
        walls.push_back(data[i]);
    }
    const StoppingPoints stops(walls);
    for (std::size_t r = 0; r < replicates; ++r)
        keep(b, fit(b.estimate.law, draw_law(b.estimate, stops, walls.size(), bits, r)));
}

void jackknife(Bootstrap& b, CensoredSample sample)
{
    for (std::size_t e = 0; e < sample.weight.size(); ++e) {
        const double weight = sample.weight[e];
        sample.weight[e] = weight - 1.0;
        if (fittable(sample)) {
            const Fit f = fit(sample, &b.estimate);
            if (f.outcome == FitOutcome::converged) {
                b.without_one.push_back(f.law);
                b.without_weight.push_back(weight);
            }
        }
        sample.weight[e] = weight;
    }
}

std::vector<double> values(const std::vector<Distribution>& laws, Quantity q)
{
    std::vector<double> v;
    v.reserve(laws.size());
    for (const Distribution& d : laws) v.push_back(value(d, q));
    return v;
}

/// Skewness of the jackknife values over 6 (Efron 1987, eq. 6.6).
double acceleration(const Bootstrap& b, Quantity q)
{
    const std::vector<double> v = values(b.without_one, q);
    double n = 0.0;
    double mean = 0.0;
    for (std::size_t i = 0; i < v.size(); ++i) {
        n += b.without_weight[i];
        mean += b.without_weight[i] * v[i];
    }
    if (n == 0.0) return 0.0;
    mean /= n;
    double squares = 0.0;
    double cubes = 0.0;
    for (std::size_t i = 0; i < v.size(); ++i) {
        const double d = mean - v[i];
        squares += b.without_weight[i] * d * d;
        cubes += b.without_weight[i] * d * d * d;
    }
    return squares > 0.0 ? cubes / (6.0 * std::pow(squares, 1.5)) : 0.0;
}

std::vector<double> sorted_values(const Bootstrap& b, Quantity q, double confidence)
{
    if (b.laws.size() < kFewestRefits)
        throw std::invalid_argument("bootstrap interval: only " +
                                    std::to_string(b.laws.size()) + " refits succeeded, " +
                                    std::to_string(b.failed) + " did not");
    if (!(confidence > 0.0 && confidence < 1.0))
        throw std::invalid_argument("bootstrap interval: confidence must be in (0, 1), is " +
                                    std::to_string(confidence));
    std::vector<double> v = values(b.laws, q);
    std::ranges::sort(v);
    return v;
}

} // namespace

Bootstrap bootstrap(const Fit& f, std::span<const Observation> data, const RandomBits& bits,
                    const BootstrapOptions& options)
{
    if (f.outcome != FitOutcome::converged)
        throw std::invalid_argument("bootstrap: the fit has not converged: " + f.reason);
    if (options.replicates == 0)
        throw std::invalid_argument("bootstrap: at least one replicate");
    Bootstrap b;
    b.estimate = f.law;
    const CensoredSample sample = prepare(f.law.law, data);
    const std::vector<std::size_t> walls = whole_walls(data);
    if (options.resampling == Resampling::walls)
        resample_walls(b, sample, walls, bits, options.replicates);
    else
        resample_law(b, data, walls, bits, options.replicates);
    jackknife(b, sample);
    return b;
}

double sample_quantile(std::span<const double> sorted, double p)
{
    const double at = p * static_cast<double>(sorted.size() - 1);
    const auto k = static_cast<std::size_t>(at);
    if (k + 1 >= sorted.size()) return sorted.back();
    return sorted[k] + (at - static_cast<double>(k)) * (sorted[k + 1] - sorted[k]);
}

Interval percentiles(std::vector<double> v, double confidence)
{
    std::ranges::sort(v);
    return {sample_quantile(v, 0.5 - 0.5 * confidence),
            sample_quantile(v, 0.5 + 0.5 * confidence), confidence};
}

Interval percentile_interval(const Bootstrap& b, Quantity q, double confidence)
{
    return percentiles(sorted_values(b, q, confidence), confidence);
}

Interval bca_interval(const Bootstrap& b, Quantity q, double confidence)
{
    const std::vector<double> v = sorted_values(b, q, confidence);
    const double estimate = value(b.estimate, q);
    const auto below_or_tied = [&](auto bound) {
        return static_cast<double>(bound(v, estimate) - v.begin());
    };
    const double below =
        0.5 *
        (below_or_tied([](const auto& s, double x) { return std::ranges::lower_bound(s, x); }) +
         below_or_tied([](const auto& s, double x) { return std::ranges::upper_bound(s, x); }));
    const double size = static_cast<double>(v.size());
    const double z0 =
        StandardNormal::quantile(std::clamp(below / size, 0.5 / size, 1.0 - 0.5 / size));
    const double a = acceleration(b, q);
    const auto end = [&](double z) {
        const double shifted = z0 + z;
        const double room = std::max(1.0 - a * shifted, 1e-3);
        return sample_quantile(v, StandardNormal::cdf(z0 + shifted / room));
    };
    const double z = StandardNormal::quantile(0.5 + 0.5 * confidence);
    return {end(-z), end(z), confidence};
}

} // namespace fragility
