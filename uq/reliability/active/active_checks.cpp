#include "uq/reliability/active/active_checks.hpp"

#include <gsl/gsl_cdf.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace uq {
namespace {

/// Shares of the checks drawn by doubt, by probability of the event and by the points alone.
constexpr double kByDoubt = 0.6, kByEvent = 0.3, kByPoints = 0.1;

double mean(const std::vector<double>& y)
{
    return std::accumulate(y.begin(), y.end(), 0.0) / static_cast<double>(y.size());
}

/// Variance of the mean of checks.
double variance_of_mean(const Checks& c, const std::vector<double>& y)
{
    const auto n = static_cast<double>(y.size());
    const double middle = mean(y);
    double squares = 0.0;
    for (const double v : y) squares += (v - middle) * (v - middle);
    const double scatter = n > 1.0 ? squares / (n * (n - 1.0)) : middle * middle;
    const double unseen = kUnseen * c.event_weight / (n * n);
    return std::max(scatter, c.expected / (n * n)) + c.points / (n * n) + unseen * unseen;
}

} // namespace

CheckPlan plan_checks(const WeighedPoints& p)
{
    const Eigen::ArrayXd doubt = p.passing.array() * (1.0 - p.passing.array());
    const Eigen::VectorXd by_doubt = p.weight.array() * doubt.sqrt();
    const Eigen::VectorXd by_event = p.weight.array() * p.passing.array();
    CheckPlan c{
        Eigen::VectorXd::Constant(p.u.rows(), kByPoints / static_cast<double>(p.u.rows()))};
    if (by_doubt.sum() > 0.0) c.chance += kByDoubt / by_doubt.sum() * by_doubt;
    if (by_event.sum() > 0.0) c.chance += kByEvent / by_event.sum() * by_event;
    c.chance /= c.chance.sum();
    c.variance = (p.weight.array().square() / c.chance.array() * doubt).sum();
    c.event_weight = p.probability / kByEvent;
    return c;
}

void note(Checks& c, const WeighedPoints& p, const CheckPlan& plan,
          const std::vector<Eigen::Index>& rows, const Eigen::VectorXd& g)
{
    const auto n = static_cast<double>(rows.size());
    for (std::size_t k = 0; k < rows.size(); ++k) {
        const Eigen::Index i = rows[k];
        const double weight = p.weight(i) / plan.chance(i), passing = p.passing(i);
        const auto value = [&](double seen) {
            return p.probability + weight * (seen - passing);
        };
        const double now = g(static_cast<Eigen::Index>(k));
        const bool failed = std::isnan(now);
        const double seen = now <= 0.0 ? 1.0 : 0.0;
        c.value.push_back(value(failed ? passing : seen));
        c.if_safe.push_back(value(failed ? 0.0 : seen));
        c.if_passed.push_back(value(failed ? 1.0 : seen));
        c.failed += failed;
        c.surprises += !failed && std::abs(seen - passing) > 0.5;
    }
    c.expected += n * plan.variance;
    c.points += (std::pow(c.with_points + n, 2) - std::pow(c.with_points, 2)) * p.std_error *
                p.std_error;
    c.with_points += n;
    c.event_weight += n * plan.event_weight;
}

Exceedance summary(const Checks& c, bool passed, const Ledger& ledger, double confidence)
{
    Exceedance e;
    e.estimate.interval = {0.0, 1.0, confidence};
    e.estimate.failed = ledger.failed.size();
    e.estimate.n = ledger.evaluations - ledger.failed.size();
    if (c.value.empty() || c.failed == c.value.size()) return e;
    // Student's factor in place of the normal one: there are few checks
    const double tail = 0.5 * (1.0 - confidence);
    const double wide = gsl_cdf_tdist_Qinv(tail, static_cast<double>(c.value.size() - 1)) /
                        gsl_cdf_ugaussian_Qinv(tail);
    const auto interval = [&](const std::vector<double>& y) {
        return log_interval(std::max(0.0, mean(y)), wide * std::sqrt(variance_of_mean(c, y)),
                            confidence);
    };
    e.lower = std::clamp(mean(c.if_safe), 0.0, 1.0);
    e.upper = std::clamp(mean(c.if_passed), 0.0, 1.0);
    e.estimate.value = std::clamp(mean(c.value), 0.0, 1.0);
    e.estimate.std_error = std::sqrt(variance_of_mean(c, c.value));
    if (!passed || !(e.estimate.value > 0.0)) {
        e.outcome = SamplingOutcome::none_passed;
        e.estimate.interval.upper =
            std::min(1.0, e.upper + gsl_cdf_ugaussian_Qinv(tail) * wide *
                                        std::sqrt(variance_of_mean(c, c.if_passed)));
        return e;
    }
    e.estimate.interval.lower = e.lower > 0.0 ? interval(c.if_safe).lower : 0.0;
    e.estimate.interval.upper = interval(c.if_passed).upper;
    e.outcome = SamplingOutcome::limit_reached;
    return e;
}

bool reached(const Exceedance& e, double target_cov, const Checks& c)
{
    return e.outcome == SamplingOutcome::limit_reached && c.value.size() >= kLeastChecks &&
           coefficient_of_variation(e.estimate) <= target_cov;
}

} // namespace uq
