/// Mean and standard deviation: closed forms, or by integration on the standard normal axis,
/// where every cut shape is smooth and of known extent.

#include "uq/marginals/marginal.hpp"

#include "uq/marginals/marginal_steps.hpp"
#include "uq/marginals/normal_rule.hpp"

#include <boost/math/special_functions/gamma.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace uq {
namespace {

struct Moments {
    double mean, sd;
};

Moments moments(const Constant& s) { return {s.value, 0.0}; }
Moments moments(const Normal& s) { return {s.mean, s.sd}; }
Moments moments(const Lognormal& s)
{
    const double variance = s.sigma_log * s.sigma_log;
    const double mean = std::exp(s.mu_log + 0.5 * variance);
    return {mean, mean * std::sqrt(std::expm1(variance))};
}
Moments moments(const Uniform& s)
{
    return {s.lower + 0.5 * (s.upper - s.lower),
            (s.upper - s.lower) / (2.0 * std::numbers::sqrt3)};
}
Moments moments(const Triangular& s)
{
    const double width = s.upper - s.lower, rise = s.mode - s.lower;
    return {s.lower + (width + rise) / 3.0,
            std::sqrt((width * width + rise * rise - width * rise) / 18.0)};
}
Moments moments(const Beta& s)
{
    const double sum = s.alpha + s.beta, width = s.upper - s.lower;
    return {s.lower + width * (s.alpha / sum),
            width / sum * std::sqrt(s.alpha * s.beta / (sum + 1.0))};
}
Moments moments(const Gamma& s) { return {s.shape * s.scale, std::sqrt(s.shape) * s.scale}; }
Moments moments(const Weibull& s)
{
    const double e = 1.0 / s.shape;
    const double g1 = boost::math::tgamma1pm1(e), g2 = boost::math::tgamma1pm1(2.0 * e);
    const double mean = s.scale * (1.0 + g1);
    return {mean, mean * std::sqrt(std::expm1(std::log1p(g2) - 2.0 * std::log1p(g1)))};
}
Moments moments(const Gumbel& s)
{
    return {s.location + std::numbers::egamma * s.scale,
            s.scale * (std::numbers::pi / std::sqrt(6.0))};
}
Moments moments(const Empirical& s) { return {steps::mean(s.sorted), steps::sd(s.sorted)}; }

Moments cut_steps(const Empirical& s, const Marginal& m)
{
    const auto first = std::ranges::lower_bound(s.sorted, m.lower);
    const std::span<const double> left(first, std::upper_bound(first, s.sorted.end(), m.upper));
    return {steps::mean(left), steps::sd(left)};
}

Moments integrated(const Marginal& m)
{
    const NormalRule rule = normal_rule(kinks(m));
    std::vector<double> x(rule.z.size());
    std::ranges::transform(rule.z, x.begin(), [&](double z) { return from_normal(m, z); });
    const double origin = from_normal(m, 0.0);
    double mean = origin;
    for (std::size_t i = 0; i < x.size(); ++i) mean += rule.weight[i] * (x[i] - origin);
    double variance = 0.0;
    for (std::size_t i = 0; i < x.size(); ++i)
        variance += rule.weight[i] * (x[i] - mean) * (x[i] - mean);
    return {mean, std::sqrt(variance)};
}

Moments moments_of(const Marginal& m)
{
    const bool whole = std::isinf(m.lower) && std::isinf(m.upper);
    if (whole || std::holds_alternative<Constant>(m.shape))
        return std::visit([](const auto& s) { return moments(s); }, m.shape);
    if (const auto* s = std::get_if<Uniform>(&m.shape))
        return moments(Uniform{std::max(s->lower, m.lower), std::min(s->upper, m.upper)});
    if (const auto* s = std::get_if<Empirical>(&m.shape)) return cut_steps(*s, m);
    return integrated(m);
}

} // namespace

std::vector<double> kinks(const Marginal& m)
{
    const auto* s = std::get_if<Triangular>(&m.shape);
    if (s == nullptr || s->mode <= m.lower || s->mode >= m.upper) return {};
    return {to_normal(m, s->mode)};
}

double mean(const Marginal& m) { return moments_of(m).mean; }
double sd(const Marginal& m) { return moments_of(m).sd; }

} // namespace uq
