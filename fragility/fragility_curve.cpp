#include "fragility/fragility_curve.hpp"

#include "fragility/median_bound.hpp"
#include "fragility/standard_law.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace fragility {
namespace {

void check(std::span<const double> drifts, double confidence)
{
    for (const double d : drifts)
        if (std::isnan(d))
            throw std::invalid_argument("fragility curve: a drift is not a number");
    if (!(confidence > 0.0 && confidence < 1.0))
        throw std::invalid_argument("fragility curve: confidence must be in (0, 1), is " +
                                    std::to_string(confidence));
}

/// P at a drift, and its derivatives for (location, ln dispersion): those of a left-censored
/// observation there.
struct Slope {
    double probability;
    double above; ///< 1 - probability, with all its digits
    Eigen::Vector2d gradient;
};

Slope slope(const Distribution& law, double drift)
{
    const double p = cdf(law, drift);
    const double q = survival(law, drift);
    if (p <= 0.0 || q <= 0.0) return {p, q, Eigen::Vector2d::Zero()};
    const Observation below[] = {left_censored(drift)};
    const Likelihood l = log_likelihood(prepare(law.law, below), working(law));
    return {p, q, p * l.gradient};
}

/// On the logit; [0, 1] where the probability is 0 or 1 within rounding has no width.
Interval logit_band(double p, double q, double std_error, double confidence)
{
    if (!(p > 0.0 && q > 0.0)) return {p, p, confidence};
    const double z = StandardNormal::quantile(0.5 + 0.5 * confidence);
    const double logit = std::log(p) - std::log(q);
    const double half = z * std_error / (p * q);
    return {StandardLogistic::cdf(logit - half), StandardLogistic::cdf(logit + half),
            confidence};
}

struct ModeAt {
    double least = 0.0, most = 0.0; ///< P of this mode's walls
    double variance = 0.0;          ///< of `least`, from the fit
};

ModeAt mode_at(const ModeGroup& mode, const Fit& f, double drift, double confidence)
{
    if (f.outcome == FitOutcome::converged) {
        const Slope s = slope(f.law, drift);
        return {s.probability, s.probability, s.gradient.dot(f.covariance * s.gradient)};
    }
    if (mode.limits.empty() || drift <= 0.0) return {};
    double failed = 0.0, n = 0.0;
    for (const Observation& o : mode.limits) {
        n += o.weight;
        if (o.upper <= drift) failed += o.weight;
    }
    const double least = failed / n;
    return {least, std::max(least, reached_at_most(mode.limits, drift, confidence).at_most),
            least * (1.0 - least) / n};
}

/// The bounds at one drift if no mode has a fit: one of all walls together is sharper than those of
/// their parts.
MixturePoint unfitted_point(const ModeGroup& all, double drift, double confidence)
{
    const ModeAt at = mode_at(all, {}, drift, confidence);
    MixturePoint point{drift, at.least, at.most, std::sqrt(at.variance), {}};
    point.band = logit_band(at.least, 1.0 - at.least, point.std_error, confidence);
    point.band.upper = std::max(point.band.upper, at.most);
    return point;
}

MixturePoint mixture_point(std::span<const ModeGroup> modes, const Mixture& m, double n,
                           double drift, double confidence)
{
    MixturePoint point{drift, 0.0, 0.0, 0.0, {}};
    double variance = 0.0;
    double squares = 0.0;
    for (std::size_t k = 0; k < modes.size(); ++k) {
        const ModeAt at = mode_at(modes[k], m.fits[k], drift, confidence);
        point.least += m.shares[k] * at.least;
        point.most += m.shares[k] * at.most;
        squares += m.shares[k] * at.least * at.least;
        variance += m.shares[k] * m.shares[k] * at.variance;
    }
    // multinomial: var(sum p_k F_k) = (sum p_k F_k^2 - (sum p_k F_k)^2) / n
    variance += std::max(0.0, squares - point.least * point.least) / n;
    point.std_error = std::sqrt(variance);
    point.band = logit_band(point.least, 1.0 - point.least, point.std_error, confidence);
    if (point.most > point.least)
        point.band.upper = std::max(
            point.band.upper,
            logit_band(point.most, 1.0 - point.most, point.std_error, confidence).upper);
    return point;
}

/// The probability does not fall, so that the bounds at all drifts before and beyond hold too.
void never_fall(std::vector<MixturePoint>& points)
{
    for (std::size_t i = 1; i < points.size(); ++i)
        points[i].band.lower = std::max(points[i].band.lower, points[i - 1].band.lower);
    for (std::size_t i = points.size(); i-- > 1;)
        points[i - 1].band.upper = std::min(points[i - 1].band.upper, points[i].band.upper);
}

/// Shares and fits alone.
Mixture mixture_of(std::span<const ModeGroup> modes, double& n)
{
    Mixture m;
    n = 0.0;
    for (const ModeGroup& mode : modes) {
        m.fits.push_back(fit(mode.law, mode.limits));
        if (m.fits.back().outcome == FitOutcome::invalid_value ||
            m.fits.back().outcome == FitOutcome::not_positive)
            throw std::invalid_argument("fragility curve: mode " +
                                        std::to_string(m.fits.size() - 1) + ": " +
                                        m.fits.back().reason);
        m.shares.push_back(count(mode.limits, positive(mode.law)).n);
        n += m.shares.back();
        if (!mode.described) {
            m.fits.back() = Fit{};
            m.fits.back().reason = "its law does not describe the walls";
        }
    }
    if (!(n > 0.0)) throw std::invalid_argument("fragility curve: no walls");
    for (double& s : m.shares) s /= n;
    return m;
}

} // namespace

std::vector<FragilityPoint> fragility_curve(const Fit& f, std::span<const double> drifts,
                                            double confidence)
{
    check(drifts, confidence);
    if (f.outcome != FitOutcome::converged)
        throw std::invalid_argument("fragility curve: the fit has not converged: " + f.reason);
    std::vector<FragilityPoint> points;
    for (const double drift : drifts) {
        const Slope s = slope(f.law, drift);
        const double error = std::sqrt(s.gradient.dot(f.covariance * s.gradient));
        points.push_back({drift, s.probability, error,
                          logit_band(s.probability, s.above, error, confidence)});
    }
    return points;
}

Mixture mixture_curve(std::span<const ModeGroup> modes, std::span<const double> drifts,
                      double confidence)
{
    check(drifts, confidence);
    if (!std::ranges::is_sorted(drifts))
        throw std::invalid_argument("fragility curve: drifts of a mixture must not fall");
    double n = 0.0;
    Mixture m = mixture_of(modes, n);
    const bool fitted = std::ranges::any_of(
        m.fits, [](const Fit& f) { return f.outcome == FitOutcome::converged; });
    ModeGroup all;
    for (const ModeGroup& mode : modes)
        all.limits.insert(all.limits.end(), mode.limits.begin(), mode.limits.end());
    for (const double drift : drifts)
        m.points.push_back(fitted ? mixture_point(modes, m, n, drift, confidence)
                                  : unfitted_point(all, drift, confidence));
    never_fall(m.points);
    return m;
}

} // namespace fragility
