#include "fragility/fits/censored_sample.hpp"

#include "core/interval.hpp"
#include "fragility/fits/censored_likelihood.hpp"
#include "fragility/fits/gamma_likelihood.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <tuple>

namespace fragility {
namespace {

double on_axis(Law law, double x) { return positive(law) ? std::log(x) : x; }

/// Mean and spread of all finite ends: any values of the size of the data would do.
void standardise(CensoredSample& s)
{
    double sum = 0.0;
    double sum2 = 0.0;
    double n = 0.0;
    const auto visit = [&](double y) {
        sum += y;
        n += 1.0;
    };
    for (const double y : s.lower) visit(y);
    for (std::size_t i = s.observed + s.right + s.left; i < s.upper.size(); ++i)
        visit(s.upper[i]);
    s.shift = sum / n;
    for (const double y : s.lower) sum2 += (y - s.shift) * (y - s.shift);
    s.scale = sum2 > 0.0 ? std::sqrt(sum2 / n) : 1.0;
    for (double& y : s.lower) y = (y - s.shift) / s.scale;
    for (double& y : s.upper) y = (y - s.shift) / s.scale;
}

/// Entries come in this order, equal ones side by side.
struct Place {
    Censoring kind;
    double lower, upper;
    auto operator<=>(const Place&) const = default;
};

Place place(Law law, const Observation& o)
{
    const Censoring kind = censoring(o, positive(law));
    const double lower = kind == Censoring::left ? o.upper : o.lower;
    const double upper = kind == Censoring::interval ? o.upper : lower;
    return {kind, lower, upper};
}

/// Observed values of a law of positive values: ln of dy / dx.
double log_jacobian(const CensoredSample& s)
{
    if (!positive(s.law)) return 0.0;
    double sum = 0.0;
    for (std::size_t i = 0; i < s.observed; ++i)
        sum -= s.weight[i] * (s.shift + s.scale * s.lower[i]);
    return sum;
}

template <class Standard>
Likelihood location_scale_likelihood(const CensoredSample& s, const Working& theta)
{
    // on the standardised axis the dispersion is smaller by s.scale
    const double gamma = s.scale * std::exp(-theta[1]);
    const double delta = (theta[0] - s.shift) / s.scale * gamma;
    const ScaledSum t = scaled_sum<Standard>(s, delta, gamma);
    double observed = 0.0;
    for (std::size_t i = 0; i < s.observed; ++i) observed += s.weight[i];
    const double d0 = gamma / s.scale; // d delta / d location
    Likelihood l;
    l.value = t.value - observed * std::log(s.scale) + log_jacobian(s);
    l.gradient << d0 * t.d, -delta * t.d - gamma * t.g;
    const double mixed = -d0 * (delta * t.dd + gamma * t.dg + t.d);
    l.hessian << d0 * d0 * t.dd, mixed, mixed,
        delta * delta * t.dd + 2.0 * delta * gamma * t.dg + gamma * gamma * t.gg + delta * t.d +
            gamma * t.g;
    return l;
}

Likelihood gamma_likelihood(const CensoredSample& s, const Working& theta)
{
    Likelihood sum{log_jacobian(s), Eigen::Vector2d::Zero(), Eigen::Matrix2d::Zero()};
    const auto axis = [&](double y) { return s.shift + s.scale * y; };
    for (std::size_t i = 0; i < s.lower.size(); ++i) {
        if (s.weight[i] == 0.0) continue;
        double lo = axis(s.lower[i]);
        double hi = lo;
        if (i >= s.observed + s.right + s.left)
            hi = axis(s.upper[i]);
        else if (i >= s.observed + s.right)
            lo = -core::kInfinity;
        else if (i >= s.observed)
            hi = core::kInfinity;
        const Likelihood l = gamma_term(theta, lo, hi);
        sum.value += s.weight[i] * l.value;
        sum.gradient += s.weight[i] * l.gradient;
        sum.hessian += s.weight[i] * l.hessian;
    }
    return sum;
}

} // namespace

CensoredSample prepare(Law law, std::span<const Observation> data)
{
    CensoredSample s;
    s.law = law;
    std::vector<Place> places(data.size());
    for (std::size_t i = 0; i < data.size(); ++i) places[i] = place(law, data[i]);
    std::vector<std::size_t> order(data.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, {}, [&](std::size_t i) { return places[i]; });
    s.entry.resize(data.size());
    for (std::size_t k = 0; k < order.size(); ++k) {
        const Place& p = places[order[k]];
        if (k == 0 || p != places[order[k - 1]]) {
            s.lower.push_back(on_axis(law, p.lower));
            s.upper.push_back(on_axis(law, p.upper));
            s.weight.push_back(0.0);
            ++(p.kind == Censoring::none    ? s.observed
               : p.kind == Censoring::right ? s.right
               : p.kind == Censoring::left  ? s.left
                                            : s.interval);
        }
        s.weight.back() += data[order[k]].weight;
        s.entry[order[k]] = s.weight.size() - 1;
    }
    standardise(s);
    return s;
}

Working working(const Distribution& d) { return {d.location, std::log(d.dispersion)}; }

Distribution distribution(Law law, const Working& theta)
{
    return {law, theta[0], std::exp(theta[1])};
}

Likelihood log_likelihood(const CensoredSample& s, const Working& theta)
{
    switch (s.law) {
    case Law::weibull:
        return location_scale_likelihood<SmallestExtreme>(s, theta);
    case Law::gamma:
        return gamma_likelihood(s, theta);
    default:
        return location_scale_likelihood<StandardNormal>(s, theta);
    }
}

} // namespace fragility
