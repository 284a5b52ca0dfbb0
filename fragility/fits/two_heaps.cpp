#include "fragility/fits/two_heaps.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace fragility {
namespace {

constexpr std::size_t kFewestInHeap = 3;
constexpr double kNarrowest = 0.1; ///< standard deviation of a heap over that of all values [-]

/// HeapSums of values in their order.
struct HeapSums {
    double n = 0.0, first = 0.0, second = 0.0;
    void add(double x)
    {
        n += 1.0;
        first += x;
        second += x * x;
    }
    [[nodiscard]] HeapSums without(const HeapSums& part) const
    {
        return {n - part.n, first - part.first, second - part.second};
    }
    [[nodiscard]] double variance() const
    {
        return std::max(0.0, second / n - first * first / (n * n));
    }
};

/// Twice the log-likelihood of a heap and of belonging to it, without what all partings share.
double heap(const HeapSums& part, const HeapSums& all, double least_variance)
{
    return part.n * (2.0 * std::log(part.n / all.n) -
                     std::log(std::max(part.variance(), least_variance)));
}

/// Distance of two heaps over their widths.
double apart(const HeapSums& below, const HeapSums& above, double least_variance)
{
    const auto width = [&](const HeapSums& h) {
        return std::sqrt(std::max(h.variance(), least_variance));
    };
    return (above.first / above.n - below.first / below.n) / (width(below) + width(above));
}

} // namespace

Parting best_parting(std::span<const Observation> data, bool positive)
{
    std::vector<double> values;
    for (const Observation& o : data) {
        if (o.lower != o.upper) return {};
        values.push_back(o.lower);
    }
    if (values.size() < 2 * kFewestInHeap) return {};
    std::ranges::sort(values);
    const std::vector<double> given = values;
    if (positive)
        for (double& x : values) x = std::log(x);
    const double middle = values[values.size() / 2]; // so that squares lose no digits
    HeapSums all;
    for (double& x : values) all.add(x -= middle);
    if (!(all.variance() > 0.0)) return {};
    const double least = kNarrowest * kNarrowest * all.variance();
    const double one = -all.n * std::log(all.variance());
    Parting best;
    HeapSums below;
    for (std::size_t i = 0; i + kFewestInHeap < values.size(); ++i) {
        below.add(values[i]);
        if (i + 1 < kFewestInHeap) continue;
        const HeapSums above = all.without(below);
        const double gain = heap(below, all, least) + heap(above, all, least) - one;
        if (gain > best.gain) best = {gain, given[i], apart(below, above, least)};
    }
    return best;
}

double two_heaps(std::span<const Observation> data, bool positive)
{
    return best_parting(data, positive).gain;
}

} // namespace fragility
