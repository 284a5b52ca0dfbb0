#include "fragility/limits/model_factor.hpp"

#include "core/fit_factors.hpp"
#include "fragility/laws/standard_law.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace fragility {
namespace {

constexpr double kNotKnown = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t kLawPoints = 1000;
constexpr std::array kShares = {0.16, 0.50, 0.84};
constexpr double kSixteen = 0.994457883209753; ///< of 84 % on the normal axis

/// Sums of weights are rounded: those of 10 of 20 walls may lie on either side of one half.
constexpr double kSumRounding = 1e-12;

/// Smallest of the values at which their weights reach p; infinite where they do not.
double step_quantile(const DriftDistribution& walls, double p)
{
    double below = 0.0;
    for (std::size_t i = 0; i < walls.drifts.size(); ++i) {
        below += walls.weights[i];
        if (below >= p - kSumRounding) return walls.drifts[i];
    }
    return core::kInfinity;
}

/// Quantile of the values times the factor; infinite where their weights only just reach p.
/// @param last probability of values at `end`; the rest lies at infinity
double smooth_quantile(const DriftDistribution& walls, double dispersion, double p, double last)
{
    const double most = std::accumulate(walls.weights.begin(), walls.weights.end(), 0.0) + last;
    if (!(most > p + kSumRounding)) return core::kInfinity;
    const auto probability = [&](double log_x) {
        double sum = 0.0;
        for (std::size_t i = 0; i < walls.drifts.size(); ++i)
            sum += walls.weights[i] *
                   StandardNormal::cdf((log_x - std::log(walls.drifts[i])) / dispersion);
        if (last > 0.0)
            sum += last * StandardNormal::cdf((log_x - std::log(walls.end)) / dispersion);
        return sum;
    };
    const double reach = 9.0 * dispersion;
    double lower = std::log(walls.drifts.empty() ? walls.end : walls.drifts.front()) - reach;
    double upper = std::log(std::max(walls.drifts.empty() ? 0.0 : walls.drifts.back(),
                                     last > 0.0 ? walls.end : 0.0)) +
                   reach;
    for (int i = 0; i < 60; ++i) {
        const double middle = 0.5 * (lower + upper);
        (probability(middle) < p ? lower : upper) = middle;
    }
    return std::exp(0.5 * (lower + upper));
}

/// Half the distance of both ends on the logarithmic axis, or of the one that is known, per
/// standard error.
double sampling_error(const core::Interval& median, double value)
{
    const double z = core::fit_normal_factor(median.confidence);
    const bool below = median.lower > 0.0, above = std::isfinite(median.upper);
    if (below && above) return std::log(median.upper / median.lower) / (2.0 * z);
    if (!std::isfinite(value) || !(below || above)) return kNotKnown;
    return below ? std::log(value / median.lower) / z : std::log(median.upper / value) / z;
}

double material_dispersion(const DriftDistribution& walls)
{
    const double low = step_quantile(walls, kShares[0]),
                 high = step_quantile(walls, kShares[2]);
    return std::isfinite(high) ? std::log(high / low) / (2.0 * kSixteen) : kNotKnown;
}

/// The interval of the walls' median, scaled and widened on the logarithmic axis.
core::Interval widened(const core::Interval& median, double from, double to,
                       double median_error)
{
    const double more = median_error * core::fit_normal_factor(median.confidence);
    const auto end = [&](double bound, double sign) {
        return to * std::exp(sign * std::hypot(std::log(bound / from), more));
    };
    return {median.lower > 0.0 ? end(std::min(median.lower, from), -1.0) : 0.0,
            std::isfinite(median.upper) ? end(std::max(median.upper, from), 1.0)
                                        : core::kInfinity,
            median.confidence};
}

} // namespace

DriftDistribution drift_distribution(const KaplanMeier& observed)
{
    DriftDistribution walls;
    double below = 0.0;
    for (const KaplanMeierStep& step : observed.steps) {
        if (!(step.at > 0.0) || !(step.probability > below)) continue;
        walls.drifts.push_back(step.at);
        walls.weights.push_back(step.probability - below);
        below = step.probability;
    }
    walls.beyond = below > 1.0 - 1e-12 ? 0.0 : 1.0 - below;
    walls.end = observed.end;
    return walls;
}

DriftDistribution drift_distribution(const Distribution& law)
{
    DriftDistribution walls;
    for (std::size_t i = 0; i < kLawPoints; ++i) {
        const double x =
            quantile(law, (static_cast<double>(i) + 0.5) / static_cast<double>(kLawPoints));
        if (x > 0.0) walls.drifts.push_back(x);
    }
    walls.weights.assign(walls.drifts.size(), 1.0 / static_cast<double>(walls.drifts.size()));
    return walls;
}

QuantileBounds factored_quantile(const DriftDistribution& walls, double median,
                                 double dispersion, double p)
{
    if (dispersion > 0.0)
        return {median * smooth_quantile(walls, dispersion, p, walls.beyond),
                median * smooth_quantile(walls, dispersion, p, 0.0)};
    const double x = step_quantile(walls, p);
    return std::isfinite(x) ? QuantileBounds{median * x, median * x}
                            : QuantileBounds{median * walls.end, core::kInfinity};
}

Dispersions dispersions(double material, double sampling, const ModelFactor& factor)
{
    const double model = model_dispersion(factor);
    return {material, sampling, model, std::hypot(material, sampling, model)};
}

DoubtedLimit with_model_doubt(const DriftDistribution& walls, const core::Interval& median,
                              double sampling, const ModelFactor& factor)
{
    DoubtedLimit limit;
    const double own = step_quantile(walls, 0.5);
    if (std::isnan(sampling)) sampling = sampling_error(median, own);
    limit.dispersion = dispersions(material_dispersion(walls), sampling, factor);
    const double doubt =
        std::hypot(std::isnan(sampling) ? 0.0 : sampling, model_dispersion(factor));
    for (std::size_t i = 0; i < kShares.size(); ++i)
        limit.quantiles[i] = factored_quantile(walls, factor.median, doubt, kShares[i]);
    const QuantileBounds& middle = limit.quantiles[1];
    if (std::isfinite(own) && std::isfinite(middle.lower))
        limit.median_interval = widened(median, own, middle.lower, factor.median_error);
    else
        limit.median_interval = {0.0, core::kInfinity, median.confidence};
    return limit;
}

DoubtedLimit with_model_doubt(const Distribution& law, const core::Interval& median,
                              double sampling, const ModelFactor& factor, double freedom)
{
    if (law.law != Law::lognormal)
        return with_model_doubt(drift_distribution(law), median, sampling, factor);
    const double own = std::exp(law.location);
    if (std::isnan(sampling)) sampling = sampling_error(median, own);
    DoubtedLimit limit;
    limit.dispersion = dispersions(law.dispersion, sampling, factor);
    const double t = std::isfinite(freedom)
                         ? core::fit_student_factor(kShares[2] - kShares[0], freedom)
                         : kSixteen;
    const double walls = std::hypot(law.dispersion, std::isnan(sampling) ? 0.0 : sampling);
    const double deviate = std::hypot(t * walls, kSixteen * model_dispersion(factor));
    const double middle = factor.median * own;
    const auto at = [&](double sign) {
        const double x = middle * std::exp(sign * deviate);
        return QuantileBounds{x, x};
    };
    limit.quantiles = {at(-1.0), at(0.0), at(1.0)};
    limit.median_interval = widened(median, own, middle, factor.median_error);
    return limit;
}

DoubtedLimit bounded_with_model_doubt(double above, double confidence,
                                      const ModelFactor& factor)
{
    DoubtedLimit limit;
    limit.quantiles.fill({0.0, core::kInfinity});
    limit.quantiles[1].lower = factor.median * above;
    limit.median_interval = {factor.median * above, core::kInfinity, confidence};
    limit.dispersion = dispersions(kNotKnown, kNotKnown, factor);
    return limit;
}

} // namespace fragility
