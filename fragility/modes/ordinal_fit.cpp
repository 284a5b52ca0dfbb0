#include "fragility/modes/ordinal_fit.hpp"

#include "core/fit_factors.hpp"
#include "fragility/laws/chi_squared.hpp"
#include "fragility/laws/maximise.hpp"
#include "fragility/laws/standard_law.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace fragility {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

using Refused = std::optional<std::pair<ModelOutcome, std::string>>;

Refused screen_values(std::span<const StateCounts> data)
{
    using enum ModelOutcome;
    if (data.empty()) return std::pair{no_data, std::string("no data")};
    for (std::size_t i = 0; i < data.size(); ++i) {
        bool sound = data[i].intensity > 0.0 && std::isfinite(data[i].intensity) &&
                     data[i].walls.size() == data[0].walls.size() && data[i].walls.size() >= 2;
        for (const double n : data[i].walls) sound = sound && n >= 0.0 && std::isfinite(n);
        if (!sound)
            return std::pair{invalid_value,
                             "row " + std::to_string(i + 1) +
                                 ": needs intensity > 0 and the same two or more states, "
                                 "counts >= 0"};
    }
    return std::nullopt;
}

Refused screen(std::span<const StateCounts> data)
{
    using enum ModelOutcome;
    if (auto no = screen_values(data)) return no;
    const std::size_t states = data[0].walls.size();
    double least = HUGE_VAL;
    double most = 0.0;
    std::vector<double> total(states, 0.0);
    std::vector<double> lowest(states, HUGE_VAL); // intensity at which a state is seen
    std::vector<double> highest(states, 0.0);
    for (const StateCounts& d : data)
        for (std::size_t k = 0; k < states; ++k) {
            if (d.walls[k] == 0.0) continue;
            total[k] += d.walls[k];
            lowest[k] = std::min(lowest[k], d.intensity);
            highest[k] = std::max(highest[k], d.intensity);
            least = std::min(least, d.intensity);
            most = std::max(most, d.intensity);
        }
    for (std::size_t k = 0; k < states; ++k)
        if (total[k] == 0.0)
            return std::pair{absent_mode, "state " + std::to_string(k) +
                                              " never occurs: its median is not finite"};
    if (least == most) return std::pair{no_contrast, std::string("only one intensity")};
    bool apart = true; // each state begins where the one before has ended
    for (std::size_t k = 1; k < states; ++k) apart = apart && highest[k - 1] <= lowest[k];
    if (apart)
        return std::pair{separated, std::string("separated: intensities tell the states apart "
                                                "without error, the dispersion cannot be told "
                                                "from zero")};
    return std::nullopt;
}

/// ln P(lower < Z < upper) with derivatives for both ends; an end may be infinite.
struct BetweenEnds {
    double value, lower, upper, ll, lu, uu;
};

BetweenEnds between_ends(double lower, double upper)
{
    if (std::isinf(lower)) {
        const LogTerm t = StandardNormal::log_cdf(upper);
        return {t.value, 0.0, t.d1, 0.0, 0.0, t.d2};
    }
    if (std::isinf(upper)) {
        const LogTerm t = StandardNormal::log_survival(lower);
        return {t.value, t.d1, 0.0, t.d2, 0.0, 0.0};
    }
    const LogBetween t = StandardNormal::log_between(0.5 * (lower + upper), upper - lower);
    return {t.value,
            0.5 * t.m - t.h,
            0.5 * t.m + t.h,
            0.25 * t.mm - t.mh + t.hh,
            0.25 * t.mm - t.hh,
            0.25 * t.mm + t.mh + t.hh};
}

/// Parameters: thresholds c_1 < c_2 < ..., slope b; P(state <= k) = Phi(c_k+1 - b t).
Local likelihood(std::span<const StateCounts> data, double middle, const VectorXd& theta)
{
    const Index cuts = theta.size() - 1;
    const double infinity = std::numeric_limits<double>::infinity();
    Local l{-infinity, VectorXd::Zero(theta.size()),
            Eigen::MatrixXd::Zero(theta.size(), theta.size())};
    for (Index k = 1; k < cuts; ++k)
        if (!(theta[k] > theta[k - 1])) return l;
    l.value = 0.0;
    for (const StateCounts& d : data) {
        const double t = std::log(d.intensity) - middle;
        for (Index k = 0; k <= cuts; ++k) {
            const double n = d.walls[static_cast<std::size_t>(k)];
            if (n == 0.0) continue;
            const double lower = k == 0 ? -infinity : theta[k - 1] - theta[cuts] * t;
            const double upper = k == cuts ? infinity : theta[k] - theta[cuts] * t;
            const BetweenEnds e = between_ends(lower, upper);
            VectorXd from = VectorXd::Zero(theta.size()); // of the lower end
            VectorXd to = from;
            if (k > 0) from[k - 1] = 1.0, from[cuts] = -t;
            if (k < cuts) to[k] = 1.0, to[cuts] = -t;
            l.value += n * e.value;
            l.gradient += n * (e.lower * from + e.upper * to);
            l.hessian += n * (e.ll * from * from.transpose() + e.uu * to * to.transpose() +
                              e.lu * (from * to.transpose() + to * from.transpose()));
        }
    }
    return l;
}

/// Thresholds of the pooled shares, no slope.
VectorXd start(std::span<const StateCounts> data)
{
    const std::size_t states = data[0].walls.size();
    std::vector<double> total(states, 0.0);
    double n = 0.0;
    for (const StateCounts& d : data)
        for (std::size_t k = 0; k < states; ++k) {
            total[k] += d.walls[k];
            n += d.walls[k];
        }
    VectorXd theta = VectorXd::Zero(static_cast<Index>(states));
    double below = 0.0;
    for (std::size_t k = 0; k + 1 < states; ++k) {
        below += total[k] / n;
        theta[static_cast<Index>(k)] = StandardNormal::quantile(below);
    }
    return theta;
}

void complete(OrdinalFit& f, const Maximum& m, double middle)
{
    const Index cuts = m.at.size() - 1;
    f.outcome = ModelOutcome::converged;
    f.dispersion = 1.0 / m.at[cuts];
    Eigen::MatrixXd d = Eigen::MatrixXd::Zero(cuts + 1, cuts + 1);
    for (Index k = 0; k < cuts; ++k) {
        f.medians.push_back(std::exp(middle + m.at[k] * f.dispersion));
        d(k, k) = f.dispersion;
        d(k, cuts) = -m.at[k] * f.dispersion * f.dispersion;
    }
    d(cuts, cuts) = -f.dispersion * f.dispersion;
    f.covariance = d * inverse_information(m.local.hessian) * d.transpose();
    f.log_likelihood = m.local.value;
}

/// Compares with the observed shares, whose log-likelihood is the largest that any curves could
/// have.
void compare_with_shares(OrdinalFit& f, std::span<const StateCounts> data)
{
    double saturated = 0.0;
    double free_shares = 0.0;
    for (const StateCounts& d : data) {
        double n = 0.0;
        for (const double w : d.walls) n += w;
        if (n == 0.0) continue;
        free_shares += static_cast<double>(d.walls.size() - 1);
        for (const double w : d.walls)
            if (w > 0.0) saturated += w * std::log(w / n);
    }
    f.deviance = 2.0 * (saturated - f.log_likelihood);
    f.freedom = free_shares - static_cast<double>(f.medians.size() + 1);
}

double two_sided(double confidence) { return core::fit_normal_factor(confidence); }

core::Interval log_interval(double value, double log_error, double confidence)
{
    const double factor = std::exp(two_sided(confidence) * log_error);
    return {value / factor, value * factor, confidence};
}

} // namespace

OrdinalFit fit_ordinal(std::span<const StateCounts> data)
{
    OrdinalFit f;
    if (const auto no = screen(data)) {
        f.outcome = no->first;
        f.reason = no->second;
        return f;
    }
    double middle = 0.0;
    for (const StateCounts& d : data)
        middle += std::log(d.intensity) / static_cast<double>(data.size());
    const Maximum m = maximise(
        [&](const VectorXd& theta) { return likelihood(data, middle, theta); }, start(data));
    if (!m.converged) {
        f.outcome = ModelOutcome::not_converged;
        f.reason = "not converged after " + std::to_string(m.iterations) + " iterations";
    } else if (!(m.at[m.at.size() - 1] > 0.0)) {
        f.outcome = ModelOutcome::wrong_slope;
        f.reason = "damage does not grow with intensity";
    } else {
        complete(f, m, middle);
        compare_with_shares(f, data);
    }
    return f;
}

double p_value(const OrdinalFit& fit)
{
    return fit.freedom > 0.0 ? chi_squared_survival(std::max(0.0, fit.deviance), fit.freedom)
                             : std::numeric_limits<double>::quiet_NaN();
}

LogEstimate median(const OrdinalFit& fit, std::size_t state, double confidence)
{
    const auto k = static_cast<Index>(state - 1);
    const double value = fit.medians[state - 1], log_error = std::sqrt(fit.covariance(k, k));
    return {value, value * log_error, log_error, log_interval(value, log_error, confidence)};
}

LogEstimate dispersion(const OrdinalFit& fit, double confidence)
{
    const Index last = fit.covariance.rows() - 1;
    const double value = fit.dispersion, error = std::sqrt(fit.covariance(last, last));
    return {value, error, error / value, log_interval(value, error / value, confidence)};
}

StateProbability probability(const OrdinalFit& fit, std::size_t state, double intensity)
{
    const auto k = static_cast<Index>(state - 1);
    const Index last = fit.covariance.rows() - 1;
    const double probit = std::log(intensity / fit.medians[state - 1]) / fit.dispersion;
    // d probit = -(d ln median + probit d dispersion) / dispersion
    const double variance = fit.covariance(k, k) + 2.0 * probit * fit.covariance(k, last) +
                            probit * probit * fit.covariance(last, last);
    return {StandardNormal::cdf(probit), probit, std::sqrt(variance) / fit.dispersion};
}

core::Interval band(const StateProbability& p, double confidence)
{
    const double z = two_sided(confidence);
    return {StandardNormal::cdf(p.probit - z * p.probit_error),
            StandardNormal::cdf(p.probit + z * p.probit_error), confidence};
}

std::vector<StateCounts> reaching(std::span<const StateCounts> data, std::size_t state)
{
    std::vector<StateCounts> two;
    for (const StateCounts& d : data) {
        StateCounts c{d.intensity, {0.0, 0.0}};
        for (std::size_t k = 0; k < d.walls.size(); ++k)
            c.walls[k < state ? 0 : 1] += d.walls[k];
        two.push_back(c);
    }
    return two;
}

} // namespace fragility
