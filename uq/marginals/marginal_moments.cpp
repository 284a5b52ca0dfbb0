/// Mean and standard deviation: closed forms, or by integration on the standard normal axis,
/// where every cut shape is smooth and of known extent.

#include "uq/marginals/marginal.hpp"

#include "uq/marginals/normal_rule.hpp"
#include "uq/marginals/shapes/discrete.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace uq {
namespace {

template <Discrete S> MeanSd whole(const S& s)
{
    return {discrete::mean(values_of(s)), discrete::sd(values_of(s))};
}
template <class S> MeanSd whole(const S& s) { return mean_sd(s); }

MeanSd cut_values(const Empirical& s, const Marginal& m)
{
    const auto first = std::ranges::lower_bound(s.sorted, m.lower);
    const std::span<const double> left(first, std::upper_bound(first, s.sorted.end(), m.upper));
    return {discrete::mean(left), discrete::sd(left)};
}

MeanSd integrated(const Marginal& m)
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

MeanSd moments_of(const Marginal& m)
{
    const bool uncut = std::isinf(m.lower) && std::isinf(m.upper);
    if (uncut || std::holds_alternative<Constant>(m.shape))
        return std::visit([](const auto& s) { return whole(s); }, m.shape);
    if (const auto* s = std::get_if<Uniform>(&m.shape))
        return mean_sd(Uniform{std::max(s->lower, m.lower), std::min(s->upper, m.upper)});
    if (const auto* s = std::get_if<Empirical>(&m.shape)) return cut_values(*s, m);
    return integrated(m);
}

} // namespace

std::vector<double> kinks(const Marginal& m)
{
    return std::visit(
        [&](const auto& s) -> std::vector<double> {
            if constexpr (requires { kink(s); })
                if (kink(s) > m.lower && kink(s) < m.upper) return {to_normal(m, kink(s))};
            return {};
        },
        m.shape);
}

double mean(const Marginal& m) { return moments_of(m).mean; }
double sd(const Marginal& m) { return moments_of(m).sd; }

} // namespace uq
