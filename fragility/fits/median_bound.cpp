#include "fragility/fits/median_bound.hpp"

#include "core/binomial.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

namespace fragility {
namespace {

void check(std::span<const Observation> data, double confidence)
{
    if (!(confidence > 0.0 && confidence < 1.0))
        throw std::invalid_argument("lower bound: confidence must be in (0, 1), is " +
                                    std::to_string(confidence));
    for (const Observation& o : data)
        if (std::isnan(o.lower) || std::isnan(o.upper) || !(o.weight > 0.0))
            throw std::invalid_argument("lower bound: an observation is not a number");
}

/// Which side of x a value at x itself is on.
enum class At { stood, failed };

bool has_failed(const Observation& o, double x, At at)
{
    if (o.upper < x) return true;
    if (o.upper > x) return false;
    return at == At::failed || o.lower != o.upper; // a left-censored wall: it was below
}

bool has_stood(const Observation& o, double x, At at)
{
    if (o.lower != x) return o.lower > x;
    return at == At::stood || std::isinf(o.upper); // right-censored: it is above
}

ReachedBound bound(std::span<const Observation> data, double x, At at, double confidence)
{
    ReachedBound b;
    for (const Observation& o : data) {
        const bool failed = has_failed(o, x, at);
        if (failed) b.failed += o.weight;
        if (failed || has_stood(o, x, at)) b.walls += o.weight;
    }
    b.walls = std::floor(b.walls);
    b.failed = std::ceil(b.failed);
    if (b.walls >= 1.0 && b.failed <= b.walls)
        b.at_most = core::binomial_upper_bound(b.failed, b.walls, confidence);
    return b;
}

} // namespace

ReachedBound reached_at_most(std::span<const Observation> data, double x, double confidence)
{
    check(data, confidence);
    return bound(data, x, At::failed, confidence);
}

MedianBound median_bound(std::span<const Observation> data, double confidence)
{
    check(data, confidence);
    std::vector<double> ends;
    for (const Observation& o : data)
        if (std::isfinite(o.lower)) ends.push_back(o.lower);
    std::ranges::sort(ends);
    MedianBound b;
    b.confidence = confidence;
    const auto past = std::ranges::partition_point(
        ends, [&](double x) { return bound(data, x, At::stood, confidence).at_most < 0.5; });
    if (past == ends.begin()) return b;
    b.median_bounded = true;
    b.median_above = *std::prev(past);
    b.strictly = bound(data, b.median_above, At::failed, confidence).at_most < 0.5;
    return b;
}

} // namespace fragility
