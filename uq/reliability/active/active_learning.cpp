#include "uq/reliability/active/active_learning.hpp"

#include "core/normal.hpp"
#include "uq/designs/sobol.hpp"
#include "uq/reliability/active/active_checks.hpp"
#include "uq/reliability/active/active_rounds.hpp"
#include "uq/reliability/active/doubtful_points.hpp"
#include "uq/reliability/active/limit_learner.hpp"
#include "uq/reliability/limit_state/pick.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace uq {
namespace {

constexpr double kFirstSpread = 1.5;    ///< of the first points, standard deviations; tuned
constexpr double kLeastPoints = 4000.0; ///< of the process, in a round
constexpr double kMostPoints = 100000.0;
constexpr double kFewChecks = 16.0; ///< needed anyway

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

/// The process of a round, and where it doubts.
struct Round {
    WeighedPoints points;
    CheckPlan plan;
    Eigen::Index known = 0; ///< evaluations behind it
};

/// Brings the round up to date with what is known.
/// @return points to learn from; none: the round checks
Eigen::MatrixXd prepare(Round& now, Learner& learner, Checks& checks, double target_cov,
                        bool may_learn, Eigen::Index batch, std::uint64_t seed)
{
    if (now.known > 0 && now.known == learner.known()) return {};
    const GaussianProcess& g = learner.process();
    now.known = learner.known();
    const double before = now.points.probability;
    now.points = weighed_points(g, active_points(target_cov), seed);
    const double change = std::abs(std::log(now.points.probability / before));
    now.plan = plan_checks(now.points);
    checks.with_points = 0.0;
    if (!may_learn || learner.full()) return {};
    NextPoints next = next_points(g, now.points, batch, seed);
    const double needed = needed_checks(now.points.probability, now.plan.variance, target_cov);
    const bool settled = change < kSettled; // NaN is not
    return !settled || learning_pays(needed, next.gain, batch) ? next.u : Eigen::MatrixXd();
}

} // namespace

Eigen::MatrixXd first_design(Eigen::Index dimension, std::uint64_t seed)
{
    Eigen::MatrixXd u = sobol(0, first_points(dimension), static_cast<int>(dimension), seed);
    core::to_normal_quantiles({u.data(), static_cast<std::size_t>(u.size())});
    return kFirstSpread * u;
}

Eigen::Index active_points(double target_cov)
{
    return static_cast<Eigen::Index>(
        std::clamp(36.0 / (target_cov * target_cov), kLeastPoints, kMostPoints));
}

double needed_checks(double probability, double variance, double target_cov)
{
    return variance / std::pow(target_cov * probability, 2);
}

bool learning_pays(double needed, double gain, Eigen::Index batch)
{
    const double left = 1.0 - gain;
    return needed * (1.0 - left * left) > static_cast<double>(batch) && needed > kFewChecks;
}

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
    Checks checks;
    Learner learner;
    Round now;
    const Eigen::MatrixXd first = first_design(s.dimension, o.seed);
    learner.learn(first, limit_values(s, first, ledger));
    r.learned = ledger.evaluations;
    for (std::uint64_t round = 1; ledger.evaluations < o.max_evaluations; ++round) {
        const std::uint64_t seed = replicate_seed(o.seed, round);
        const auto batch = std::min<Eigen::Index>(
            kActiveBatch, static_cast<Eigen::Index>(o.max_evaluations - ledger.evaluations));
        Eigen::MatrixXd lesson;
        try {
            const bool may = 2 * ledger.evaluations < o.max_evaluations;
            lesson = prepare(now, learner, checks, o.target_cov, may, batch, seed);
        } catch (const std::invalid_argument& no_process) {
            r.trouble = no_process.what();
            break;
        }
        r.surrogate = now.points.probability;
        if (lesson.rows() > 0) {
            learner.learn(lesson, limit_values(s, lesson, ledger));
            r.learned += static_cast<std::size_t>(batch);
            continue;
        }
        Stream random(seed, 2, Purpose::bootstrap);
        const std::vector<Eigen::Index> rows = pick_evenly(now.plan.chance, batch, random);
        const Eigen::MatrixXd u = now.points.u(rows, Eigen::all);
        const Eigen::VectorXd values = limit_values(s, u, ledger);
        note(checks, now.points, now.plan, rows, values);
        learner.learn(u, values);
        if (reached(summary(checks, learner.passed(), ledger, o.confidence), o.target_cov,
                    checks))
            break;
    }
    r.exceedance = summary(checks, learner.passed(), ledger, o.confidence);
    if (reached(r.exceedance, o.target_cov, checks))
        r.exceedance.outcome = SamplingOutcome::target_reached;
    r.checks = checks.value.size();
    r.surprises = checks.surprises;
    r.exceedance.ledger = std::move(ledger);
    return r;
}

} // namespace uq
