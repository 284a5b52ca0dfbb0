#include "uq/estimates/two_heaps.hpp"

#include "uq/designs/stream.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

namespace uq {

namespace {

constexpr int kHeapGrid = 160;      // points at which a density is looked at
constexpr int kHeapBisections = 24; // of the width
constexpr std::uint64_t kHeapStream =
    0x68656170; // no resample of another estimate has this number

int modes(const std::vector<double>& sorted, double width)
{
    const double from = sorted.front() - 3.0 * width, to = sorted.back() + 3.0 * width;
    double before = 0.0;
    bool rising = true;
    int found = 0;
    for (int g = 0; g <= kHeapGrid; ++g) {
        const double x = from + (to - from) * g / kHeapGrid;
        const auto first = std::ranges::lower_bound(sorted, x - 6.0 * width);
        double f = 0.0;
        for (auto v = first; v != sorted.end() && *v < x + 6.0 * width; ++v)
            f += std::exp(-0.5 * (x - *v) * (x - *v) / (width * width));
        if (rising && f < before) ++found;
        if (f != before) rising = f > before;
        before = f;
    }
    return found;
}

} // namespace

double one_heap_p_value(std::span<const double> values, int resamples, std::uint64_t seed)
{
    std::vector<double> sorted(values.begin(), values.end());
    std::ranges::sort(sorted);
    if (sorted.size() < 5 || !std::isfinite(sorted.front()) || !std::isfinite(sorted.back()) ||
        !(sorted.back() > sorted.front()) || resamples < 19)
        throw std::invalid_argument("heaps: at least 5 finite values that are not all equal");
    const auto n = static_cast<double>(sorted.size());
    double mean = 0.0, square = 0.0;
    for (const double v : sorted) mean += v / n;
    for (const double v : sorted) square += (v - mean) * (v - mean) / n;
    // a width at which there is one mode is known at its upper end throughout
    double narrow = 0.0, wide = sorted.back() - sorted.front();
    for (int i = 0; i < kHeapBisections; ++i) {
        const double middle = 0.5 * (narrow + wide);
        (modes(sorted, middle) > 1 ? narrow : wide) = middle;
    }
    const double shrink = 1.0 / std::sqrt(1.0 + wide * wide / square);
    Stream draw(seed, kHeapStream, Purpose::bootstrap);
    int as_wide = 0;
    for (int b = 0; b < resamples; ++b) {
        std::vector<double> again(sorted.size());
        for (double& v : again)
            v = mean +
                shrink * (sorted[draw.below(sorted.size())] - mean + wide * draw.normal());
        std::ranges::sort(again);
        as_wide += modes(again, wide) > 1 ? 1 : 0;
    }
    return (1.0 + as_wide) / (1.0 + resamples);
}

} // namespace uq
