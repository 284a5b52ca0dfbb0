#include "fragility/limits/stress_model.hpp"

#include "core/fit_factors.hpp"
#include "fragility/laws/maximise.hpp"
#include "fragility/laws/standard_law.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <stdexcept>

namespace fragility {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// ln dispersion [-] outside of which a search has gone astray.
constexpr double kLeastLog = -12.0;
constexpr double kMostLog = 12.0;

VectorXd powers(double t, Index terms)
{
    VectorXd v(terms);
    double p = 1.0;
    for (Index j = 0; j < terms; ++j, p *= t) v[j] = p;
    return v;
}

/// Log-likelihood of one observation and its derivatives by ln median and ln dispersion.
struct Term {
    double value, m, s, mm, ms, ss;
};

/// From derivatives for z = (y - m) e^-s.
Term from_z(const LogTerm& t, double z, double sigma)
{
    return {t.value,
            -t.d1 / sigma,
            -t.d1 * z,
            t.d2 / (sigma * sigma),
            (t.d2 * z + t.d1) / sigma,
            (t.d2 * z + t.d1) * z};
}

Term term(const Observation& o, double m, double s)
{
    const double sigma = std::exp(s);
    const auto z = [&](double x) { return (std::log(x) - m) / sigma; };
    switch (censoring(o, true)) {
    case Censoring::right: {
        const double at = z(o.lower);
        return from_z(StandardNormal::log_survival(at), at, sigma);
    }
    case Censoring::left: {
        const double at = z(o.upper);
        return from_z(StandardNormal::log_cdf(at), at, sigma);
    }
    case Censoring::interval: {
        const double c = 0.5 * (z(o.lower) + z(o.upper));
        const double h = z(o.upper) - z(o.lower);
        const LogBetween t = StandardNormal::log_between(c, h);
        const double along = t.m * c + t.h * h; // -d/ds
        return {t.value,
                -t.m / sigma,
                -along,
                t.mm / (sigma * sigma),
                (t.m + t.mm * c + t.mh * h) / sigma,
                along + t.mm * c * c + 2.0 * t.mh * c * h + t.hh * h * h};
    }
    case Censoring::none:
        break;
    }
    const double at = z(o.lower);
    Term t = from_z(StandardNormal::log_density(at), at, sigma);
    t.value -= s + std::log(o.lower);
    t.s -= 1.0;
    return t;
}

struct Prepared {
    std::span<const StressedObservation> data;
    double centre, scale;
    Index median, dispersion; ///< numbers of terms
};

Local likelihood(const Prepared& p, const VectorXd& theta)
{
    Local l{0.0, VectorXd::Zero(theta.size()), MatrixXd::Zero(theta.size(), theta.size())};
    for (const StressedObservation& d : p.data) {
        const double t = (d.stress - p.centre) / p.scale;
        const VectorXd a = powers(t, p.median);
        const VectorXd b = powers(t, p.dispersion);
        const double s = theta.tail(p.dispersion).dot(b);
        if (!(s > kLeastLog && s < kMostLog)) {
            l.value = -std::numeric_limits<double>::infinity();
            return l;
        }
        const Term e = term(d.limit, theta.head(p.median).dot(a), s);
        const double w = d.limit.weight;
        l.value += w * e.value;
        l.gradient.head(p.median) += w * e.m * a;
        l.gradient.tail(p.dispersion) += w * e.s * b;
        l.hessian.topLeftCorner(p.median, p.median) += w * e.mm * a * a.transpose();
        l.hessian.topRightCorner(p.median, p.dispersion) += w * e.ms * a * b.transpose();
        l.hessian.bottomRightCorner(p.dispersion, p.dispersion) += w * e.ss * b * b.transpose();
    }
    l.hessian.bottomLeftCorner(p.dispersion, p.median) =
        l.hessian.topRightCorner(p.median, p.dispersion).transpose();
    return l;
}

StressModel refused(FitOutcome outcome, std::string reason)
{
    StressModel m;
    m.outcome = outcome;
    m.reason = std::move(reason);
    return m;
}

std::vector<Observation> limits(std::span<const StressedObservation> data)
{
    std::vector<Observation> all;
    for (const StressedObservation& d : data) all.push_back(d.limit);
    return all;
}

/// Levels at which something else than lower limits is known: only these carry a polynomial.
std::size_t telling_levels(std::span<const StressedObservation> data)
{
    std::set<double> levels;
    for (const StressedObservation& d : data)
        if (censoring(d.limit, true) != Censoring::right) levels.insert(d.stress);
    return levels.size();
}

std::optional<StressModel> screen_stress(std::span<const StressedObservation> data,
                                         StressOrder order)
{
    for (std::size_t i = 0; i < data.size(); ++i)
        if (!std::isfinite(data[i].stress))
            return refused(FitOutcome::invalid_value, "observation " + std::to_string(i + 1) +
                                                          ": stress is not a finite number");
    const std::size_t levels = telling_levels(data);
    const int most = std::max(order.median, order.dispersion);
    if (!data.empty() && levels < static_cast<std::size_t>(most) + 1)
        return refused(FitOutcome::too_few,
                       "too few: " + std::to_string(levels) +
                           " stress levels at which limits were reached, a polynomial of "
                           "degree " +
                           std::to_string(most) + " needs " + std::to_string(most + 1));
    return std::nullopt;
}

void complete(StressModel& model, const Prepared& p, const Maximum& m, const Counts& counts)
{
    model.outcome = FitOutcome::converged;
    model.median_terms = m.at.head(p.median);
    model.dispersion_terms = m.at.tail(p.dispersion);
    model.covariance = inverse_information(m.local.hessian);
    model.centre = p.centre;
    model.scale = p.scale;
    const auto ends =
        std::ranges::minmax(p.data, {}, [](const StressedObservation& d) { return d.stress; });
    model.least_stress = ends.min.stress;
    model.most_stress = ends.max.stress;
    model.counts = counts;
    model.log_likelihood = m.local.value;
    model.aic = 2.0 * static_cast<double>(m.at.size()) - 2.0 * m.local.value;
}

Prepared prepared(std::span<const StressedObservation> data, StressOrder order)
{
    double mean = 0.0;
    double squares = 0.0;
    const double n = static_cast<double>(data.size());
    for (const StressedObservation& d : data) mean += d.stress / n;
    for (const StressedObservation& d : data) squares += (d.stress - mean) * (d.stress - mean);
    return {data, mean, squares > 0.0 ? std::sqrt(squares / n) : 1.0,
            static_cast<Index>(order.median) + 1, static_cast<Index>(order.dispersion) + 1};
}

} // namespace

StressModel fit_stress_model(std::span<const StressedObservation> data, StressOrder order)
{
    if (std::min(order.median, order.dispersion) < 0 ||
        std::max(order.median, order.dispersion) > 3)
        throw std::invalid_argument("stress model: degrees must be 0 to 3, are " +
                                    std::to_string(order.median) + " and " +
                                    std::to_string(order.dispersion));
    if (auto no = screen_stress(data, order)) return *no;
    const std::vector<Observation> all = limits(data);
    const Fit pooled = fit(Law::lognormal, all);
    if (pooled.outcome != FitOutcome::converged) return refused(pooled.outcome, pooled.reason);
    const Prepared p = prepared(data, order);
    VectorXd start = VectorXd::Zero(p.median + p.dispersion);
    start[0] = pooled.law.location;
    start[p.median] = std::log(pooled.law.dispersion);
    const Maximum m =
        maximise([&](const VectorXd& theta) { return likelihood(p, theta); }, start);
    if (!m.converged)
        return refused(FitOutcome::not_converged,
                       "not converged after " + std::to_string(m.iterations) + " iterations");
    StressModel model;
    complete(model, p, m, pooled.counts);
    return model;
}

StressModel fit_stress_model(std::span<const StressedObservation> data)
{
    StressModel best = fit_stress_model(data, {0, 0});
    if (best.outcome != FitOutcome::converged) return best;
    for (int median = 0; median <= 2; ++median)
        for (int dispersion = 0; dispersion <= 2; ++dispersion) {
            StressModel m = fit_stress_model(data, {median, dispersion});
            if (m.outcome == FitOutcome::converged && m.aic < best.aic) best = std::move(m);
        }
    return best;
}

AtStress at_stress(const StressModel& m, double stress)
{
    if (m.outcome != FitOutcome::converged)
        throw std::invalid_argument("stress model: there is none: " + m.reason);
    const double t = (stress - m.centre) / m.scale;
    const VectorXd a = powers(t, m.median_terms.size());
    const VectorXd b = powers(t, m.dispersion_terms.size());
    MatrixXd j = MatrixXd::Zero(2, a.size() + b.size());
    j.row(0).head(a.size()) = a;
    j.row(1).tail(b.size()) = b;
    return {{Law::lognormal, m.median_terms.dot(a), std::exp(m.dispersion_terms.dot(b))},
            j * m.covariance * j.transpose(),
            stress < m.least_stress || stress > m.most_stress};
}

StressPrediction predict(const StressModel& m, double stress, double confidence)
{
    if (!(confidence > 0.0 && confidence < 1.0))
        throw std::invalid_argument("stress model: confidence must be in (0, 1), is " +
                                    std::to_string(confidence));
    const AtStress at = at_stress(m, stress);
    const double z = core::fit_normal_factor(confidence);
    const double se = std::sqrt(at.covariance(0, 0));
    const double both = std::hypot(se, at.law.dispersion);
    const double median = std::exp(at.law.location);
    return {median,
            {median * std::exp(-z * se), median * std::exp(z * se), confidence},
            {median * std::exp(-z * both), median * std::exp(z * both), confidence}};
}

} // namespace fragility
