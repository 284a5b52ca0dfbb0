#include "uq/marginals/marginal.hpp"

#include "core/normal.hpp"
#include "uq/marginals/shapes/discrete.hpp"
#include "uq/marginals/shapes/truncated.hpp"

#include <gsl/gsl_cdf.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <stdexcept>
#include <string>
#include <type_traits>

namespace uq {
namespace {

/// The values that the cut leaves.
template <class S> std::span<const double> values(const S& s, const Marginal& m)
{
    const std::span<const double> all = values_of(s);
    const auto first = std::lower_bound(all.begin(), all.end(), m.lower);
    return {first, std::upper_bound(first, all.end(), m.upper)};
}

void check_number(double x)
{
    if (std::isnan(x)) throw std::invalid_argument("marginal: asked at x = nan");
}

void check_probability(double p)
{
    if (!(p > 0.0 && p < 1.0))
        throw std::invalid_argument("marginal: probability " + std::to_string(p) +
                                    " is not in (0, 1)");
}

/// A probability that double cannot tell from 0 (|z| > 37.5) is taken as the smallest it can.
double kept(double p) { return std::max(p, std::numeric_limits<double>::min()); }

template <class S> double from_normal(const S& s, const Marginal& m, double z)
{
    const double tail = kept(gsl_cdf_ugaussian_P(-std::abs(z)));
    if constexpr (Discrete<S>) {
        return z <= 0.0 ? discrete::quantile(values(s, m), tail)
                        : discrete::upper_quantile(values(s, m), tail);
    } else {
        const truncated::Cut c = truncated::cut(s, m.lower, m.upper);
        return z <= 0.0 ? truncated::at_lower(s, c, tail) : truncated::at_upper(s, c, tail);
    }
}

bool whole(const Marginal& m)
{
    return m.lower == -std::numeric_limits<double>::infinity() &&
           m.upper == std::numeric_limits<double>::infinity();
}

} // namespace

double pdf(const Marginal& m, double x)
{
    check_number(x);
    return std::visit(
        [&](const auto& s) -> double {
            if constexpr (Discrete<std::decay_t<decltype(s)>>) {
                throw std::invalid_argument(
                    "marginal: a constant or empirical variable has no density");
            } else {
                const truncated::Cut c = truncated::cut(s, m.lower, m.upper);
                return x < c.lower || x > c.upper ? 0.0 : density(s, x) / c.mass;
            }
        },
        m.shape);
}

double cdf(const Marginal& m, double x)
{
    check_number(x);
    return std::visit(
        [&](const auto& s) {
            if constexpr (Discrete<std::decay_t<decltype(s)>>)
                return discrete::cdf(values(s, m), x);
            else
                return truncated::cdf(s, truncated::cut(s, m.lower, m.upper), x);
        },
        m.shape);
}

double complement(const Marginal& m, double x)
{
    check_number(x);
    return std::visit(
        [&](const auto& s) {
            if constexpr (Discrete<std::decay_t<decltype(s)>>)
                return discrete::complement(values(s, m), x);
            else
                return truncated::complement(s, truncated::cut(s, m.lower, m.upper), x);
        },
        m.shape);
}

double quantile(const Marginal& m, double p)
{
    check_probability(p);
    return std::visit(
        [&](const auto& s) {
            if constexpr (Discrete<std::decay_t<decltype(s)>>)
                return discrete::quantile(values(s, m), p);
            else
                return truncated::quantile(s, truncated::cut(s, m.lower, m.upper), p);
        },
        m.shape);
}

double upper_quantile(const Marginal& m, double q)
{
    check_probability(q);
    return std::visit(
        [&](const auto& s) {
            if constexpr (Discrete<std::decay_t<decltype(s)>>)
                return discrete::upper_quantile(values(s, m), q);
            else
                return truncated::upper_quantile(s, truncated::cut(s, m.lower, m.upper), q);
        },
        m.shape);
}

double from_normal(const Marginal& m, double z)
{
    check_number(z);
    if (whole(m)) {
        if (const auto* s = std::get_if<Normal>(&m.shape)) return s->mean + s->sd * z;
        if (const auto* s = std::get_if<Lognormal>(&m.shape))
            return std::exp(s->mu_log + s->sigma_log * z);
    }
    return std::visit([&](const auto& s) { return from_normal(s, m, z); }, m.shape);
}

double to_normal(const Marginal& m, double x)
{
    check_number(x);
    if (whole(m)) {
        if (const auto* s = std::get_if<Normal>(&m.shape)) return (x - s->mean) / s->sd;
        if (const auto* s = std::get_if<Lognormal>(&m.shape); s != nullptr && x > 0.0)
            return (std::log(x) - s->mu_log) / s->sigma_log;
    }
    return std::visit(
        [&](const auto& s) {
            if constexpr (Discrete<std::decay_t<decltype(s)>>)
                return core::normal_quantile(discrete::middle(values(s, m), x));
            else {
                const truncated::Cut c = truncated::cut(s, m.lower, m.upper);
                const double p = truncated::cdf(s, c, x);
                return p <= 0.5
                           ? core::normal_quantile(kept(p))
                           : core::upper_normal_quantile(kept(truncated::complement(s, c, x)));
            }
        },
        m.shape);
}

} // namespace uq
