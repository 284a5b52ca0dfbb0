#include "uq/reliability/active_learning.hpp"

#include "uq/designs/sobol.hpp"
#include "uq/marginals/normal_quantile.hpp"
#include "uq/reliability/doubtful_points.hpp"
#include "uq/reliability/pick.hpp"
#include "uq/surrogates/process_fit.hpp"

#include <gsl/gsl_cdf.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>

namespace uq {
namespace {

constexpr double kFirstSpread = 1.5; ///< of the first points, standard deviations; tuned
/// Shares of the checks drawn by doubt, by probability of the event and by the points alone.
constexpr double kByDoubt = 0.6, kByEvent = 0.3, kByPoints = 0.1;
constexpr double kUnseen = 0.5;         ///< wrong answers about the event that no check has met
constexpr double kLeastPoints = 4000.0; ///< of the process, in a round
constexpr double kMostPoints = 100000.0;
constexpr std::size_t kLeastChecks = 16; ///< fewer do not tell their own scatter

/// Scales of compression, over the median of |g|; infinite: none. Tuned.
constexpr std::array kCompressions = {std::numeric_limits<double>::infinity(), 1.0, 0.25};

/// Points that a process has at most, and those above which its parameters stay: the cost of
/// both grows with the cube.
constexpr Eigen::Index kMostKnown = 600, kMostFitted = 200;

void check_options(const LimitState& s, const ActiveOptions& o)
{
    const auto require = [](bool good, const std::string& what) {
        if (!good) throw std::invalid_argument("active learning: " + what);
    };
    require(o.max_evaluations >= least_active_budget(s.dimension),
            "max_evaluations must be at least " +
                std::to_string(least_active_budget(s.dimension)));
    require(o.target_cov > 0.0, "target_cov must be > 0");
    require(o.confidence > 0.0 && o.confidence < 1.0, "confidence must be in (0, 1)");
}

Eigen::MatrixXd first_design(Eigen::Index dimension, std::uint64_t seed)
{
    Eigen::MatrixXd u = sobol(0, first_points(dimension), static_cast<int>(dimension), seed);
    to_normal_quantiles({u.data(), static_cast<std::size_t>(u.size())});
    return kFirstSpread * u;
}

/// Evaluations that gave an answer, as far as the process can use them.
struct Known {
    Eigen::MatrixXd u;
    Eigen::VectorXd g;
    bool passed = false; ///< whether any evaluation at all saw the event
};

void learn(Known& known, const Eigen::MatrixXd& u, const Eigen::VectorXd& g)
{
    known.passed = known.passed || (g.array() <= 0.0).any(); // NaN is not
    const Eigen::Index before = known.g.size();
    Eigen::Index n = before;
    known.u.conservativeResize(before + g.size(), u.cols());
    known.g.conservativeResize(before + g.size());
    for (Eigen::Index i = 0; i < g.size(); ++i) {
        if (std::isnan(g(i)) || n == kMostKnown) continue;
        known.u.row(n) = u.row(i);
        known.g(n++) = g(i);
    }
    known.u.conservativeResize(n, u.cols());
    known.g.conservativeResize(n);
}

/// g, or asinh(g / scale), which keeps its sign and makes large values small.
Eigen::VectorXd compressed(const Eigen::VectorXd& g, double scale)
{
    return std::isinf(scale) ? g : Eigen::VectorXd((g / scale).array().asinh());
}

/// Log likelihood of g itself.
double likelihood(const GaussianProcess& p, const Eigen::VectorXd& g, double scale)
{
    if (std::isinf(scale)) return p.log_likelihood;
    return p.log_likelihood - 0.5 * (g.array().square() + scale * scale).log().sum();
}

/// The process of all that is known, of g as it is or compressed, whichever is likelier. It is
/// fitted anew when a seventh more is known than at the last fit: fits cost more than all else.
class Learner {
  public:
    const GaussianProcess& process_of(const Known& known)
    {
        if (known.g.size() < 3)
            throw std::invalid_argument("fewer than three evaluations answered");
        const Eigen::Index n = known.g.size();
        if (!last_ || (7 * n > 8 * fitted_ && fitted_ < kMostFitted))
            fit(known);
        else
            last_ = condition({known.u, compressed(known.g, scale_), {}}, last_->kernel,
                              last_->trend, ProcessParameters(last_->parameters));
        return *last_;
    }

  private:
    void fit(const Known& known)
    {
        fitted_ = known.g.size();
        const bool linear = fitted_ >= 2 * (known.u.cols() + 1);
        const auto trend = linear ? ProcessTrend::linear : ProcessTrend::constant;
        Eigen::VectorXd size = known.g.cwiseAbs();
        std::ranges::nth_element(size, size.begin() + size.size() / 2);
        const double middle = size(size.size() / 2);
        last_.reset();
        double most = -std::numeric_limits<double>::infinity();
        for (const double share : kCompressions) {
            const double scale = share * middle;
            if (!(scale > 0.0)) continue;
            GaussianProcess p =
                fit_process({known.u, compressed(known.g, scale), {}}, {.trend = trend});
            const double now = likelihood(p, known.g, scale);
            if (last_ && !(now > most)) continue;
            most = now;
            scale_ = scale;
            last_ = std::move(p);
        }
    }

    std::optional<GaussianProcess> last_;
    double scale_ = 0.0;
    Eigen::Index fitted_ = 0; ///< points of the last fit
};

/// The density of the checks among weighed points, and what a check is worth.
struct CheckPlan {
    Eigen::VectorXd chance;  ///< of each point, adds up to 1
    double variance = 0.0;   ///< of a check, as the process expects it
    double event_weight = 0; ///< phi / q where the event is sure
};

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

/// Checks so far, and what they add up to.
struct Checks {
    std::vector<double> value;     ///< Y of each
    std::vector<double> if_passed; ///< Y if failed evaluations were passed
    std::vector<double> if_safe;   ///< Y if they were safe
    double expected = 0.0;         ///< sum of the variances that the processes expect
    double points = 0.0;           ///< sum over points of (checks x standard error of P)^2
    double with_points = 0.0;      ///< checks with the last points
    double event_weight = 0.0;     ///< sum over the checks
    std::size_t surprises = 0;
    std::size_t failed = 0;
};

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

Exceedance summary(const Checks& c, const Known& known, const Ledger& ledger,
                   const ActiveOptions& o)
{
    Exceedance e;
    e.estimate.interval = {0.0, 1.0, o.confidence};
    e.estimate.failed = ledger.failed.size();
    e.estimate.n = ledger.evaluations - ledger.failed.size();
    if (c.value.empty() || c.failed == c.value.size()) return e;
    // Student's factor in place of the normal one: there are few checks
    const double tail = 0.5 * (1.0 - o.confidence);
    const double wide = gsl_cdf_tdist_Qinv(tail, static_cast<double>(c.value.size() - 1)) /
                        gsl_cdf_ugaussian_Qinv(tail);
    const auto interval = [&](const std::vector<double>& y) {
        return log_interval(std::max(0.0, mean(y)), wide * std::sqrt(variance_of_mean(c, y)),
                            o.confidence);
    };
    e.lower = std::clamp(mean(c.if_safe), 0.0, 1.0);
    e.upper = std::clamp(mean(c.if_passed), 0.0, 1.0);
    e.estimate.value = std::clamp(mean(c.value), 0.0, 1.0);
    e.estimate.std_error = std::sqrt(variance_of_mean(c, c.value));
    const bool any = known.passed;
    if (!any || !(e.estimate.value > 0.0)) {
        e.outcome = SamplingOutcome::none_passed;
        e.estimate.interval.upper =
            std::min(1.0, e.upper + gsl_cdf_ugaussian_Qinv(tail) * wide *
                                        std::sqrt(variance_of_mean(c, c.if_passed)));
        return e;
    }
    e.estimate.interval.lower = e.lower > 0.0 ? interval(c.if_safe).lower : 0.0;
    e.estimate.interval.upper = interval(c.if_passed).upper;
    const bool reached =
        c.value.size() >= kLeastChecks && coefficient_of_variation(e.estimate) <= o.target_cov;
    e.outcome = reached ? SamplingOutcome::target_reached : SamplingOutcome::limit_reached;
    return e;
}

/// Points of the process at which its own error is a third of the target.
Eigen::Index point_count(double target_cov)
{
    return static_cast<Eigen::Index>(
        std::clamp(36.0 / (target_cov * target_cov), kLeastPoints, kMostPoints));
}

/// Checks that the target would need, if the process is right.
double needed_checks(const WeighedPoints& p, const CheckPlan& plan, double target_cov)
{
    return plan.variance / std::pow(target_cov * p.probability, 2);
}

/// Whether learning saves more checks than it costs: they go with the square of the doubt.
bool learning_pays(double needed, double gain, Eigen::Index batch)
{
    const double left = 1.0 - gain;
    return needed * (1.0 - left * left) > static_cast<double>(batch) &&
           needed > static_cast<double>(kLeastChecks);
}

} // namespace

Eigen::Index first_points(Eigen::Index dimension)
{
    return kActiveBatch *
           std::max<Eigen::Index>(2, (2 * dimension + 2 + kActiveBatch - 1) / kActiveBatch);
}

std::size_t least_active_budget(Eigen::Index dimension)
{
    return static_cast<std::size_t>(first_points(dimension) + 4 * kActiveBatch);
}

ActiveResult active_learning(const LimitState& s, const ActiveOptions& o)
{
    check(s);
    check_options(s, o);
    ActiveResult r;
    Ledger ledger;
    Known known;
    Checks checks;
    Learner learner;
    WeighedPoints p;
    CheckPlan plan;
    Eigen::Index used = 0; // evaluations that p knows
    const Eigen::MatrixXd first = first_design(s.dimension, o.seed);
    learn(known, first, limit_values(s, first, ledger));
    r.learned = ledger.evaluations;
    for (std::uint64_t round = 1; ledger.evaluations < o.max_evaluations; ++round) {
        const std::uint64_t seed = replicate_seed(o.seed, round);
        const auto batch = std::min<Eigen::Index>(
            kActiveBatch, static_cast<Eigen::Index>(o.max_evaluations - ledger.evaluations));
        try {
            if (known.g.size() != used || used == 0) {
                const GaussianProcess& g = learner.process_of(known);
                used = known.g.size();
                p = weighed_points(g, point_count(o.target_cov), seed);
                plan = plan_checks(p);
                checks.with_points = 0.0;
                r.surrogate = p.probability;
                const double needed = needed_checks(p, plan, o.target_cov);
                const NextPoints next = next_points(g, p, batch, seed);
                if (2 * ledger.evaluations < o.max_evaluations && used < kMostKnown &&
                    learning_pays(needed, next.gain, batch)) {
                    learn(known, next.u, limit_values(s, next.u, ledger));
                    r.learned += static_cast<std::size_t>(batch);
                    continue;
                }
            }
        } catch (const std::invalid_argument& no_process) {
            r.trouble = no_process.what();
            break;
        }
        Stream random(seed, 2, Purpose::bootstrap);
        const std::vector<Eigen::Index> rows = pick_evenly(plan.chance, batch, random);
        const Eigen::MatrixXd u = p.u(rows, Eigen::all);
        const Eigen::VectorXd values = limit_values(s, u, ledger);
        note(checks, p, plan, rows, values);
        learn(known, u, values);
        r.exceedance = summary(checks, known, ledger, o);
        if (r.exceedance.outcome == SamplingOutcome::target_reached) break;
    }
    r.exceedance = summary(checks, known, ledger, o);
    r.checks = checks.value.size();
    r.surprises = checks.surprises;
    r.exceedance.ledger = std::move(ledger);
    return r;
}

} // namespace uq
