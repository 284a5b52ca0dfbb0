#include "fragility/lower_bound.hpp"

#include "fragility/binomial.hpp"

#include <cmath>
#include <set>
#include <stdexcept>

namespace fragility {
namespace {

struct Told {
    double walls = 0.0, failed = 0.0;
};

Told told_at(std::span<const Observation> data, double t)
{
    Told told;
    for (const Observation& o : data) {
        const bool failed = o.upper <= t && o.upper != o.lower;
        const bool observed_below = o.upper == o.lower && o.lower < t;
        if (failed || observed_below) told.failed += o.weight;
        if (failed || observed_below || o.lower >= t) told.walls += o.weight;
    }
    told.walls = std::floor(told.walls);
    told.failed = std::ceil(told.failed);
    return told;
}

} // namespace

LowerBound lower_bound(std::span<const Observation> data, double confidence)
{
    if (!(confidence > 0.0 && confidence < 1.0))
        throw std::invalid_argument("lower bound: confidence must be in (0, 1), is " +
                                    std::to_string(confidence));
    std::set<double> ends;
    for (const Observation& o : data) {
        if (std::isnan(o.lower) || std::isnan(o.upper) || !(o.weight > 0.0))
            throw std::invalid_argument("lower bound: an observation is not a number");
        if (std::isfinite(o.lower)) ends.insert(o.lower);
    }
    LowerBound b;
    b.confidence = confidence;
    for (const double t : ends) {
        const Told told = told_at(data, t);
        if (told.walls < 1.0 || told.failed > told.walls) continue;
        const double below = binomial_upper_bound(told.failed, told.walls, confidence);
        if (below < 0.5) {
            b.median_bounded = true;
            b.median_above = t;
        }
        b.at = t;
        b.walls_at = told.walls;
        b.failed_at = told.failed;
        b.probability_below = below;
    }
    return b;
}

} // namespace fragility
