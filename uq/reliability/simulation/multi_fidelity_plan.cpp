#include "uq/reliability/simulation/multi_fidelity_plan.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace uq {

namespace {

/// Models of a set with the expensive one in front, best correlated first.
struct Chain {
    std::vector<std::size_t> use;
    std::vector<double> cost, square; ///< rho^2, 1 for the expensive one and 0 behind the last
};

Chain chain(double expensive_cost, std::span<const CheapQuality> cheap, std::size_t set)
{
    Chain c;
    for (std::size_t i = 0; i < cheap.size(); ++i)
        if (set >> i & 1U) c.use.push_back(i);
    std::ranges::stable_sort(c.use, std::greater{},
                             [&](std::size_t i) { return std::abs(cheap[i].correlation); });
    c.cost.push_back(expensive_cost);
    // A perfect copy would leave nothing for the expensive model to do.
    const double most = 1.0 - 1e-8;
    c.square.push_back(1.0);
    for (const std::size_t i : c.use) {
        c.cost.push_back(cheap[i].cost);
        c.square.push_back(std::min(most, std::pow(cheap[i].correlation, 2)));
    }
    c.square.push_back(0.0);
    return c;
}

/// Samples of each model over those of the expensive one.
std::vector<double> ratios(const Chain& c)
{
    std::vector<double> r;
    for (std::size_t i = 0; i < c.cost.size(); ++i)
        r.push_back(std::sqrt(c.cost[0] * (c.square[i] - c.square[i + 1]) /
                              (c.cost[i] * (1.0 - c.square[1]))));
    return r;
}

double variance_ratio(const Chain& c)
{
    double sum = 0.0;
    for (std::size_t i = 0; i < c.cost.size(); ++i)
        sum += std::sqrt(c.cost[i] * (c.square[i] - c.square[i + 1]));
    return sum * sum / c.cost[0];
}

std::vector<std::size_t> samples(const Chain& c, double budget, std::size_t least_expensive)
{
    const std::vector<double> r = ratios(c);
    double per_expensive = 0.0;
    for (std::size_t i = 0; i < r.size(); ++i) per_expensive += r[i] * c.cost[i];
    double scale = budget / per_expensive;
    std::vector<std::size_t> n{static_cast<std::size_t>(scale)};
    if (n[0] < least_expensive) { // what is left goes to the cheap ones
        n[0] = least_expensive;
        scale = std::max(0.0, budget - static_cast<double>(least_expensive) * c.cost[0]) /
                (per_expensive - c.cost[0]);
    }
    for (std::size_t i = 1; i < r.size(); ++i)
        n.push_back(std::max(n.back(), static_cast<std::size_t>(scale * r[i])));
    return n;
}

} // namespace

EffortPlan plan_effort(double expensive_cost, std::span<const CheapQuality> cheap,
                       double budget, std::size_t least_expensive)
{
    const auto require = [](bool good, const std::string& what) {
        if (!good) throw std::invalid_argument("effort: " + what);
    };
    require(expensive_cost > 0.0 && std::isfinite(expensive_cost),
            "the expensive cost must be > 0");
    require(cheap.size() <= 16, "at most 16 cheap models");
    for (const CheapQuality& q : cheap) {
        require(q.cost > 0.0 && std::isfinite(q.cost), "costs must be > 0");
        require(std::abs(q.correlation) <= 1.0, "correlations must be in [-1, 1]");
    }
    require(least_expensive >= 1, "least_expensive must be at least 1");
    require(std::isfinite(budget) &&
                budget >= static_cast<double>(least_expensive) * expensive_cost,
            "the budget does not reach for the expensive samples needed");

    Chain best = chain(expensive_cost, cheap, 0);
    double least = kWorthwhileRatio;
    for (std::size_t set = 1; set < (std::size_t{1} << cheap.size()); ++set) {
        const Chain c = chain(expensive_cost, cheap, set);
        if (!std::ranges::is_sorted(ratios(c)) || variance_ratio(c) >= least) continue;
        least = variance_ratio(c);
        best = c;
    }
    EffortPlan plan;
    plan.pays = !best.use.empty();
    plan.use = best.use;
    plan.variance_ratio = plan.pays ? least : 1.0;
    plan.samples = samples(best, budget, least_expensive);
    return plan;
}

} // namespace uq
