#include "uq/marginals/marginal.hpp"

#include "uq/marginals/marginal_cut.hpp"
#include "uq/marginals/marginal_shape.hpp"
#include "uq/marginals/marginal_steps.hpp"
#include "uq/marginals/normal_quantile.hpp"

#include <gsl/gsl_cdf.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <stdexcept>
#include <string>
#include <type_traits>

namespace uq {
namespace {

template <class S>
constexpr bool kStepped = std::is_same_v<S, Constant> || std::is_same_v<S, Empirical>;

std::span<const double> values_of(const Constant& s) { return {&s.value, 1}; }
std::span<const double> values_of(const Empirical& s) { return s.sorted; }

/// What the cut leaves of the values.
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
    if constexpr (kStepped<S>) {
        return z <= 0.0 ? steps::quantile(values(s, m), tail)
                        : steps::upper_quantile(values(s, m), tail);
    } else {
        const shape::Cut c = shape::cut(s, m.lower, m.upper);
        return z <= 0.0 ? shape::at_lower(s, c, tail) : shape::at_upper(s, c, tail);
    }
}

template <class S> void fill_quantiles(const S& s, const Marginal& m, std::span<double> u)
{
    if constexpr (kStepped<S>) {
        for (double& x : u) x = steps::quantile(values(s, m), x);
    } else {
        const shape::Cut c = shape::cut(s, m.lower, m.upper);
        for (double& x : u) x = shape::quantile(s, c, x);
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
            if constexpr (kStepped<std::decay_t<decltype(s)>>) {
                throw std::invalid_argument(
                    "marginal: a constant or empirical variable has no density");
            } else {
                const shape::Cut c = shape::cut(s, m.lower, m.upper);
                return x < c.lower || x > c.upper ? 0.0 : shape::density(s, x) / c.mass;
            }
        },
        m.shape);
}

double cdf(const Marginal& m, double x)
{
    check_number(x);
    return std::visit(
        [&](const auto& s) {
            if constexpr (kStepped<std::decay_t<decltype(s)>>)
                return steps::cdf(values(s, m), x);
            else
                return shape::cdf(s, shape::cut(s, m.lower, m.upper), x);
        },
        m.shape);
}

double complement(const Marginal& m, double x)
{
    check_number(x);
    return std::visit(
        [&](const auto& s) {
            if constexpr (kStepped<std::decay_t<decltype(s)>>)
                return steps::complement(values(s, m), x);
            else
                return shape::complement(s, shape::cut(s, m.lower, m.upper), x);
        },
        m.shape);
}

double quantile(const Marginal& m, double p)
{
    check_probability(p);
    return std::visit(
        [&](const auto& s) {
            if constexpr (kStepped<std::decay_t<decltype(s)>>)
                return steps::quantile(values(s, m), p);
            else
                return shape::quantile(s, shape::cut(s, m.lower, m.upper), p);
        },
        m.shape);
}

double upper_quantile(const Marginal& m, double q)
{
    check_probability(q);
    return std::visit(
        [&](const auto& s) {
            if constexpr (kStepped<std::decay_t<decltype(s)>>)
                return steps::upper_quantile(values(s, m), q);
            else
                return shape::upper_quantile(s, shape::cut(s, m.lower, m.upper), q);
        },
        m.shape);
}

void to_quantiles(const Marginal& m, std::span<double> u)
{
    for (const double p : u) check_probability(p);
    if (whole(m)) { // the same bits by a shorter way
        if (const auto* s = std::get_if<Normal>(&m.shape)) {
            to_normal_quantiles(u);
            for (double& x : u) x = s->mean + s->sd * x;
            return;
        }
        if (const auto* s = std::get_if<Lognormal>(&m.shape)) {
            to_normal_quantiles(u);
            for (double& x : u) x = std::exp(s->mu_log + s->sigma_log * x);
            return;
        }
    }
    std::visit([&](const auto& s) { fill_quantiles(s, m, u); }, m.shape);
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
            if constexpr (kStepped<std::decay_t<decltype(s)>>)
                return normal_quantile(steps::middle(values(s, m), x));
            else {
                const shape::Cut c = shape::cut(s, m.lower, m.upper);
                const double p = shape::cdf(s, c, x);
                return p <= 0.5 ? normal_quantile(kept(p))
                                : upper_normal_quantile(kept(shape::complement(s, c, x)));
            }
        },
        m.shape);
}

} // namespace uq
