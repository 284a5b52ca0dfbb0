#include "fragility/censored_fit.hpp"
#include "fragility/gamma_likelihood.hpp"
#include "fragility/standard_law.hpp"

#include <boost/math/quadrature/gauss.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace fragility {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
using Rule = boost::math::quadrature::gauss<double, 16>;

template <class Standard> Likelihood standard_term(const Working& theta, double y, bool above)
{
    const double sigma = std::exp(theta[1]);
    const double z = (y - theta[0]) / sigma;
    const LogTerm t = above ? Standard::log_survival(z) : Standard::log_density(z);
    Likelihood l;
    l.value = t.value - (above ? 0.0 : theta[1]);
    l.gradient << -t.d1 / sigma, -z * t.d1 - (above ? 0.0 : 1.0);
    l.hessian.setZero(); // not needed
    return l;
}

/// Log density of y, or log of the probability above it, with its gradient.
Likelihood term(Law law, const Working& theta, double y, bool above)
{
    switch (law) {
    case Law::weibull:
        return standard_term<SmallestExtreme>(theta, y, above);
    case Law::gamma:
        return gamma_term(theta, y, above ? kInfinity : y);
    default:
        return standard_term<StandardNormal>(theta, y, above);
    }
}

/// Ends of y outside which the density holds less than rounding.
std::pair<double, double> support(const Distribution& d)
{
    const double lo = quantile(d, 1e-18);
    double hi = quantile(d, 0.5);
    while (survival(d, hi) > 1e-18) hi = positive(d.law) ? 1.1 * hi : hi + 0.1 * d.dispersion;
    return positive(d.law) ? std::pair{std::log(lo), std::log(hi)} : std::pair{lo, hi};
}

/// Right-censoring value common to all (infinity: none); nothing if the plan is another.
std::optional<double> common_limit(std::span<const Observation> data, bool positive)
{
    double limit = kInfinity;
    double highest = -kInfinity;
    for (const Observation& o : data) {
        const Censoring kind = censoring(o, positive);
        if (kind == Censoring::left || kind == Censoring::interval) return std::nullopt;
        if (kind == Censoring::none) {
            highest = std::max(highest, o.lower);
        } else {
            if (limit < kInfinity && limit != o.lower) return std::nullopt;
            limit = o.lower;
        }
    }
    if (highest > limit) return std::nullopt;
    return limit;
}

} // namespace

std::optional<Eigen::Matrix2d> expected_covariance(const Fit& fit,
                                                   std::span<const Observation> data)
{
    if (fit.outcome != FitOutcome::converged) return std::nullopt;
    const auto limit = common_limit(data, positive(fit.law.law));
    if (!limit) return std::nullopt;
    const Working theta = working(fit.law);
    const auto [lo, top] = support(fit.law);
    const double end = positive(fit.law.law) ? std::log(*limit) : *limit;
    const double hi = std::min(top, end);
    Eigen::Matrix2d information = Eigen::Matrix2d::Zero(); // of one wall: E[score score^T]
    const auto add = [&](double weight, const Likelihood& l) {
        information += weight * std::exp(l.value) * l.gradient * l.gradient.transpose();
    };
    constexpr int kPanels = 60;
    const double half = 0.5 * (hi - lo) / kPanels;
    for (int k = 0; k < kPanels; ++k) {
        const double middle = lo + (2 * k + 1) * half;
        for (std::size_t i = 0; i < Rule::abscissa().size(); ++i) {
            const double x = half * Rule::abscissa()[i];
            const double w = half * Rule::weights()[i];
            add(w, term(fit.law.law, theta, middle + x, false));
            add(w, term(fit.law.law, theta, middle - x, false));
        }
    }
    if (end < top) add(1.0, term(fit.law.law, theta, end, true));
    return Eigen::Matrix2d((fit.counts.n * information).inverse());
}

} // namespace fragility
