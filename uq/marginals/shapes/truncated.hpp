#pragma once
/// A shape cut off outside [lower, upper] and scaled up to one, accurate in what is left: deep
/// in a tail of the shape as well as close to a cut.

#include "core/gauss_legendre.hpp"
#include "uq/marginals/shapes/shape_form.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace uq::truncated {

/// Integral of the density from x to y, where it changes little except as a power of the
/// distance to an end of the support: Gauss-Legendre, on stretches that double this distance.
template <class S> [[nodiscard]] double integral(const S& s, double x, double y)
{
    const Range ends = support(s);
    const double from_lower = x - ends.lower, from_upper = ends.upper - y;
    if (y - x > std::min(from_lower, from_upper)) {
        const double middle = from_lower < from_upper ? std::min(x + from_lower, 0.5 * (x + y))
                                                      : std::max(y - from_upper, 0.5 * (x + y));
        if (x < middle && middle < y) return integral(s, x, middle) + integral(s, middle, y);
    }
    const double middle = 0.5 * (x + y), half = 0.5 * (y - x);
    double sum = 0.0;
    for (std::size_t i = 0; i < core::kGauss20.node.size(); ++i) {
        const double step = half * core::kGauss20.node[i];
        sum +=
            (density(s, middle + step) + density(s, middle - step)) * core::kGauss20.weight[i];
    }
    return half * sum;
}

/// Probability between x and y, x <= y, both inside the support. Tails are subtracted where
/// that keeps the digits, otherwise the density is integrated.
template <class S> [[nodiscard]] double between(const S& s, double x, double y)
{
    constexpr double kShare =
        0.1; // a difference above this share of its parts is good to 1e-15
    const Range ends = support(s);
    if (x <= ends.lower) return lower_tail(s, y);
    if (y >= ends.upper) return upper_tail(s, x);
    const double below = lower_tail(s, x);
    double whole = 1.0;
    double difference = 0.0;
    if (below > 0.5) {
        whole = upper_tail(s, x);
        difference = whole - upper_tail(s, y);
    } else if (const double up_to = lower_tail(s, y); up_to < 0.5) {
        whole = up_to;
        difference = up_to - below;
    } else {
        difference = 1.0 - below - upper_tail(s, y);
    }
    if (difference > kShare * whole) return difference;
    return integral(s, x, y);
}

/// The part of a shape that is left, with the numbers that are needed again and again.
struct Cut {
    double lower, upper;       ///< inside the support
    bool cut_below, cut_above; ///< whether the shape reaches beyond
    double below, above;       ///< P(X <= lower), P(X > upper) of the shape
    double from_lower = 0.0;   ///< P(X > lower) of the shape
    double to_upper = 0.0;     ///< P(X <= upper) of the shape
    double mass = 1.0;         ///< between them
};

/// mass is 0 where the cut leaves nothing that double can hold.
template <class S> [[nodiscard]] Cut cut(const S& s, double lower, double upper)
{
    const Range ends = support(s);
    Cut c{std::max(lower, ends.lower),
          std::min(upper, ends.upper),
          lower > ends.lower,
          upper < ends.upper,
          0.0,
          0.0};
    if (!(c.lower < c.upper)) {
        c.mass = 0.0;
        return c;
    }
    c.below = c.cut_below ? lower_tail(s, c.lower) : 0.0;
    c.above = c.cut_above ? upper_tail(s, c.upper) : 0.0;
    c.from_lower = c.cut_below ? upper_tail(s, c.lower) : 1.0;
    c.to_upper = c.cut_above ? lower_tail(s, c.upper) : 1.0;
    if (c.cut_below || c.cut_above) c.mass = between(s, c.lower, c.upper);
    return c;
}

template <class S> [[nodiscard]] double cdf(const S& s, const Cut& c, double x)
{
    if (x <= c.lower) return 0.0;
    if (x >= c.upper) return 1.0;
    return std::min(1.0, between(s, c.lower, x) / c.mass);
}

template <class S> [[nodiscard]] double complement(const S& s, const Cut& c, double x)
{
    if (x <= c.lower) return 1.0;
    if (x >= c.upper) return 0.0;
    return std::min(1.0, between(s, x, c.upper) / c.mass);
}

/// The step h > 0 from `edge` in `direction` (1 or -1) that spans the probability `t`, where
/// the density hardly changes: Newton for ln P(h) = ln t over ln h.
template <class S>
[[nodiscard]] double step_from(const S& s, double edge, double direction, double t)
{
    double h = t / density(s, edge);
    for (int i = 0; i < 20; ++i) {
        const double x = edge + direction * h;
        const double p = x == edge ? h * density(s, edge)
                                   : between(s, std::min(x, edge), std::max(x, edge)) * h /
                                         std::abs(x - edge); // h, not what x can resolve of it
        const double step = std::log(p / t) * p / (h * density(s, x));
        if (!std::isfinite(step)) break;
        h *= std::exp(-step);
        if (std::abs(step) < 4.0 * std::numeric_limits<double>::epsilon()) break;
    }
    return h;
}

constexpr double kLeast = std::numeric_limits<double>::min(); // of the shape's probabilities
constexpr double kClose = 0.1; // share of a tail below which steps from the cut are taken

/// x with P(X <= x) = p, p in (0, 1/2]
template <class S> [[nodiscard]] double at_lower(const S& s, const Cut& c, double p)
{
    const double t = std::max(p * c.mass, kLeast);
    if (!c.cut_below || c.below == 0.0) return std::clamp(at_lower(s, t), c.lower, c.upper);
    if (t < kClose * std::min(c.below, c.from_lower))
        return std::min(c.lower + step_from(s, c.lower, 1.0, t), c.upper);
    const double x =
        c.below + t < 0.5 ? at_lower(s, c.below + t) : at_upper(s, c.from_lower - t);
    return std::clamp(x, c.lower, c.upper);
}

/// x with P(X > x) = q, q in (0, 1/2]
template <class S> [[nodiscard]] double at_upper(const S& s, const Cut& c, double q)
{
    const double t = std::max(q * c.mass, kLeast);
    if (!c.cut_above || c.above == 0.0) return std::clamp(at_upper(s, t), c.lower, c.upper);
    if (t < kClose * std::min(c.above, c.to_upper))
        return std::max(c.upper - step_from(s, c.upper, -1.0, t), c.lower);
    const double x = c.above + t < 0.5 ? at_upper(s, c.above + t) : at_lower(s, c.to_upper - t);
    return std::clamp(x, c.lower, c.upper);
}

template <class S> [[nodiscard]] double quantile(const S& s, const Cut& c, double p)
{
    return p <= 0.5 ? at_lower(s, c, p) : at_upper(s, c, 1.0 - p);
}

template <class S> [[nodiscard]] double upper_quantile(const S& s, const Cut& c, double q)
{
    return q <= 0.5 ? at_upper(s, c, q) : at_lower(s, c, 1.0 - q);
}

} // namespace uq::truncated
