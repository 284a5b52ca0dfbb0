#include "uq/estimates/stopping.hpp"

#include "core/critical.hpp"
#include "uq/estimates/quantile_estimate.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace uq {

namespace {

std::optional<Estimate> estimate(const StoppingRule& rule, std::span<const double> y)
{
    if (sound_values(y).values.size() < 2) return {};
    switch (rule.target) {
    case StoppingTarget::mean:
        return estimate_mean(y, rule.confidence);
    case StoppingTarget::quantile:
        return estimate_quantile(y, rule.p, rule.confidence);
    case StoppingTarget::probability_below:
        return estimate_probability_below(y, rule.threshold, rule.confidence);
    }
    return {};
}

double larger_side(const StoppingRule& rule, const Estimate& e)
{
    const double side = std::max(e.interval.upper - e.value, e.value - e.interval.lower);
    if (!rule.relative || side == 0.0) return side;
    return e.value == 0.0 ? std::numeric_limits<double>::infinity() : side / std::abs(e.value);
}

} // namespace

std::string_view words(StopReason reason)
{
    switch (reason) {
    case StopReason::not_yet:
        return "not yet";
    case StopReason::precise_enough:
        return "precise enough";
    case StopReason::sample_limit:
        return "limit of samples reached";
    }
    return "";
}

void check(const StoppingRule& rule)
{
    core::check_confidence(rule.confidence);
    const auto require = [](bool ok, const std::string& what) {
        if (!ok) throw std::invalid_argument("stopping rule: " + what);
    };
    require(rule.target != StoppingTarget::quantile || (rule.p > 0.0 && rule.p < 1.0),
            "p is " + std::to_string(rule.p) + ", must be in (0, 1)");
    require(!std::isnan(rule.threshold), "the threshold is not a number");
    require(rule.half_width > 0.0,
            "half width is " + std::to_string(rule.half_width) + ", must be > 0");
    require(rule.min_n >= 2, "min_n is " + std::to_string(rule.min_n) + ", must be >= 2");
    require(rule.max_n >= rule.min_n,
            "max_n is " + std::to_string(rule.max_n) + ", must be >= min_n");
    require(rule.growth > 1.0 && std::isfinite(rule.growth),
            "growth is " + std::to_string(rule.growth) + ", must be > 1");
}

StoppingDecision judge(const StoppingRule& rule, std::span<const double> y)
{
    check(rule);
    const bool enough = y.size() >= rule.min_n;
    return judge(rule, y.size(), enough ? estimate(rule, y) : std::nullopt);
}

StoppingDecision judge(const StoppingRule& rule, std::size_t n,
                       const std::optional<Estimate>& estimate)
{
    check(rule);
    StoppingDecision d;
    d.half_width = std::numeric_limits<double>::infinity();
    if (n < rule.min_n) {
        d.next_n = rule.min_n;
        return d;
    }
    d.estimate = estimate;
    if (d.estimate) d.half_width = larger_side(rule, *d.estimate);
    if (d.half_width <= rule.half_width)
        d.reason = StopReason::precise_enough;
    else if (n >= rule.max_n)
        d.reason = StopReason::sample_limit;
    else {
        const double grown = std::ceil(rule.growth * static_cast<double>(n));
        d.next_n = grown < static_cast<double>(rule.max_n) ? static_cast<std::size_t>(grown)
                                                           : rule.max_n;
    }
    return d;
}

} // namespace uq
