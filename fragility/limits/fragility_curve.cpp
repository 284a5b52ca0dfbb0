#include "fragility/limits/fragility_curve.hpp"

#include "core/fit_factors.hpp"
#include "fragility/fits/kaplan_meier.hpp"
#include "fragility/fits/median_bound.hpp"
#include "fragility/laws/small_sample.hpp"
#include "fragility/laws/standard_law.hpp"

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
core::Interval logit_band(double p, double q, double std_error, double confidence)
{
    if (!(p > 0.0 && q > 0.0)) return {p, p, confidence};
    const double z = core::fit_normal_factor(confidence);
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

/// The bounds at one drift if no mode has a fit: one of all walls together is sharper than
/// those of their parts.
MixturePoint unfitted_point(const ModeGroup& all, double drift, double confidence)
{
    const ModeAt at = mode_at(all, {}, drift, confidence);
    MixturePoint point{drift, at.least, at.most, std::sqrt(at.variance), {}};
    point.band = logit_band(at.least, 1.0 - at.least, point.std_error, confidence);
    point.band.upper = std::max(point.band.upper, at.most);
    return point;
}

/// The modes at one drift, added up.
/// @param at of each mode  @param n walls
MixturePoint mixture_point(const Mixture& m, std::span<const ModeAt> at, double n, double drift,
                           double confidence)
{
    MixturePoint point{drift, 0.0, 0.0, 0.0, {}};
    double variance = 0.0;
    double squares = 0.0;
    for (std::size_t k = 0; k < at.size(); ++k) {
        point.least += m.shares[k] * at[k].least;
        point.most += m.shares[k] * at[k].most;
        squares += m.shares[k] * at[k].least * at[k].least;
        variance += m.shares[k] * m.shares[k] * at[k].variance;
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

MixturePoint mixture_point(std::span<const ModeGroup> modes, const Mixture& m, double n,
                           double drift, double confidence)
{
    std::vector<ModeAt> at;
    for (std::size_t k = 0; k < modes.size(); ++k)
        at.push_back(mode_at(modes[k], m.fits[k], drift, confidence));
    return mixture_point(m, at, n, drift, confidence);
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

namespace {

/// The mixture where a mode without a law counts as observed: Kaplan and Meier's share, and
/// Greenwood's error.
class MixtureReader {
  public:
    MixtureReader(std::span<const ModeGroup> modes, double confidence)
        : modes_(modes), mixture_(mixture_of(modes, walls_))
    {
        double parameters = 0.0, reached = 0.0;
        for (std::size_t k = 0; k < modes.size(); ++k) {
            const bool fitted = mixture_.fits[k].outcome == FitOutcome::converged;
            observed_.push_back(fitted ? KaplanMeier{} : kaplan_meier(modes[k].limits));
            parameters += fitted ? 2.0 : 0.0;
            reached += count(modes[k].limits, positive(modes[k].law)).observed;
        }
        confidence_ = small_sample(confidence, reached - parameters);
    }
    [[nodiscard]] MixturePoint at(double drift) const
    {
        std::vector<ModeAt> modes;
        for (std::size_t k = 0; k < modes_.size(); ++k)
            modes.push_back(mixture_.fits[k].outcome == FitOutcome::converged
                                ? mode_at(modes_[k], mixture_.fits[k], drift, confidence_)
                                : observed_at(observed_[k], drift));
        return mixture_point(mixture_, modes, walls_, drift, confidence_);
    }
    [[nodiscard]] const Mixture& mixture() const { return mixture_; }

  private:
    static ModeAt observed_at(const KaplanMeier& km, double drift)
    {
        const auto after = std::ranges::upper_bound(km.steps, drift, {}, &KaplanMeierStep::at);
        if (after == km.steps.begin()) return {};
        const KaplanMeierStep& step = *(after - 1);
        return {step.probability, step.probability, step.std_error * step.std_error};
    }
    std::span<const ModeGroup> modes_;
    double confidence_ = 0.0;
    double walls_ = 0.0;
    Mixture mixture_;
    std::vector<KaplanMeier> observed_;
};

/// Drifts that part the curve finely: quantiles of the fitted laws and the drifts of the walls,
/// ascending.
std::vector<double> parting_drifts(const MixtureReader& reader,
                                   std::span<const ModeGroup> modes)
{
    constexpr int kParts = 60;
    constexpr double kFarthest = 4.5; ///< standard normal deviate of the outermost drifts
    std::vector<double> drifts;
    for (const Fit& f : reader.mixture().fits)
        for (int i = -kParts; i <= kParts && f.outcome == FitOutcome::converged; ++i)
            drifts.push_back(
                quantile(f.law, StandardNormal::cdf(kFarthest * i / double{kParts})));
    for (const ModeGroup& mode : modes)
        for (const Observation& o : mode.limits) drifts.push_back(o.lower);
    std::erase_if(drifts, [](double x) { return !std::isfinite(x); });
    std::ranges::sort(drifts);
    drifts.erase(std::unique(drifts.begin(), drifts.end()), drifts.end());
    return drifts;
}

/// The drift between two points at which the probability reaches p, by bisection.
template <class Probability>
double reached_between(double below, double above, double p, const Probability& probability)
{
    constexpr int kHalvings = 50;
    for (int i = 0; i < kHalvings; ++i) {
        const double middle = 0.5 * (below + above);
        (probability(middle) < p ? below : above) = middle;
    }
    return above;
}

} // namespace

std::vector<MixtureQuantile> mixture_quantiles(std::span<const ModeGroup> modes,
                                               std::span<const double> shares,
                                               double confidence)
{
    check(shares, confidence);
    const MixtureReader reader(modes, confidence);
    const std::vector<double> drifts = parting_drifts(reader, modes);
    std::vector<MixturePoint> points;
    for (const double x : drifts) points.push_back(reader.at(x));
    never_fall(points);
    const auto reached = [&](double p, auto&& part) {
        const auto at = std::ranges::find_if(
            points, [&](const MixturePoint& point) { return part(point) >= p; });
        if (at == points.end()) return core::kInfinity;
        if (at == points.begin()) return at->drift;
        return reached_between((at - 1)->drift, at->drift, p,
                               [&](double x) { return part(reader.at(x)); });
    };
    std::vector<MixtureQuantile> found;
    for (const double p : shares) {
        if (!(p > 0.0 && p < 1.0))
            throw std::invalid_argument("mixture quantiles: shares must be in (0, 1)");
        const double lower = reached(p, [](const MixturePoint& x) { return x.band.upper; });
        const bool from_first = !points.empty() && lower == points.front().drift;
        found.push_back(
            {reached(p, [](const MixturePoint& x) { return x.least; }),
             {from_first ? std::min(0.0, lower) : lower,
              reached(p, [](const MixturePoint& x) { return x.band.lower; }), confidence}});
    }
    return found;
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
