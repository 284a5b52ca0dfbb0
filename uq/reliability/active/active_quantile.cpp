#include "uq/reliability/active/active_quantile.hpp"

#include "uq/reliability/active/active_rounds.hpp"
#include "uq/reliability/active/limit_learner.hpp"
#include "uq/reliability/active/quantile_checks.hpp"
#include "uq/reliability/limit_state/pick.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace uq {
namespace {

constexpr double kNoEnd = std::numeric_limits<double>::infinity();
constexpr int kMostMoves = 4; ///< of the threshold, until the points lie at the quantile
constexpr double kQuantileMoved =
    0.15; ///< change of ln P from which on the points are drawn anew
constexpr int kQuantileHalvings = 50; ///< of the search for the quantile of a process
constexpr double kFarthest = 30.0;    ///< factors of P between which the quantile is looked for

void check_options(const LimitState& s, const ActiveQuantileOptions& o)
{
    const auto require = [](bool good, const std::string& what) {
        if (!good) throw std::invalid_argument("active quantile: " + what);
    };
    require(o.probability > 0.0 && o.probability <= 0.5, "probability must be in (0, 1/2]");
    require(s.passing == Passing::at_or_below, "the event must be at or below the quantile");
    require(o.active.max_evaluations >= least_active_budget(s.dimension),
            "max_evaluations must be at least " +
                std::to_string(least_active_budget(s.dimension)));
    require(o.active.target_cov > 0.0, "target_cov must be > 0");
    require(o.active.confidence > 0.0 && o.active.confidence < 1.0,
            "confidence must be in (0, 1)");
}

/// Response at which the process has the probability, among those near all that was answered.
double process_quantile(const QuantileRound& r, double probability, const Eigen::VectorXd& y)
{
    const double width = y.maxCoeff() - y.minCoeff();
    double low = y.minCoeff() - 2.0 * width, high = y.maxCoeff() + 2.0 * width;
    for (int i = 0; i < kQuantileHalvings; ++i) {
        const double middle = 0.5 * (low + high);
        (process_below(r, middle) < probability ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

/// The round of the process of all that is known, with its points at its own quantile.
/// @param shift where that quantile is looked for first
QuantileRound round_at_quantile(Learner& learner, double shift, const ActiveQuantileOptions& o,
                                std::uint64_t seed)
{
    QuantileRound r{};
    for (int move = 0; move < kMostMoves; ++move) {
        const GaussianProcess& g = learner.process(shift);
        r.shift = shift;
        r.scale = learner.scale();
        r.noise = g.parameters.noise;
        r.points = weighed_points(g, active_points(o.active.target_cov), seed);
        if (std::abs(std::log(r.points.probability / o.probability)) < kQuantileMoved) break;
        shift = process_quantile(r, o.probability, learner.values());
    }
    r.plan = plan_checks(r.points);
    return r;
}

/// The points to learn from in this round; none where the round checks.
Eigen::MatrixXd lesson_of(const QuantileRound& now, const Learner& learner,
                          const GaussianProcess& g, double change, double target_cov,
                          Eigen::Index batch, std::uint64_t seed)
{
    if (learner.full()) return {};
    NextPoints next = next_points(g, now.points, batch, seed);
    const double needed = needed_checks(now.points.probability, now.plan.variance, target_cov);
    const bool settled = change < kSettled; // NaN is not
    return !settled || learning_pays(needed, next.gain, batch) ? next.u : Eigen::MatrixXd();
}

Eigen::VectorXd check_points(QuantileRound& now, const LimitState& s, Eigen::Index batch,
                             std::uint64_t seed, Eigen::MatrixXd& u, Ledger& ledger)
{
    Stream random(seed, 2, Purpose::bootstrap);
    const std::vector<Eigen::Index> rows = pick_evenly(now.plan.chance, batch, random);
    u = now.points.u(rows, Eigen::all);
    const Eigen::VectorXd y = limit_values(s, u, ledger);
    now.rows.insert(now.rows.end(), rows.begin(), rows.end());
    now.y.insert(now.y.end(), y.begin(), y.end());
    return y;
}

/// Counts checks, and those on the side of the quantile that the process thought less likely.
void count(ActiveQuantileResult& r, const std::vector<QuantileRound>& rounds)
{
    r.checks = r.surprises = 0;
    for (const QuantileRound& round : rounds)
        for (std::size_t k = 0; k < round.rows.size(); ++k) {
            const double below = round.y[k] <= round.shift ? 1.0 : 0.0;
            ++r.checks;
            r.surprises += !std::isnan(round.y[k]) &&
                           std::abs(below - round.points.passing(round.rows[k])) > 0.5;
        }
}

std::size_t sound_checks(const std::vector<QuantileRound>& rounds)
{
    std::size_t n = 0;
    for (const QuantileRound& r : rounds)
        for (const double y : r.y) n += !std::isnan(y);
    return n;
}

bool reached(const std::vector<QuantileRound>& rounds, const ActiveQuantileOptions& o)
{
    if (sound_checks(rounds) < kLeastChecks) return false;
    const ProbabilityBelow p =
        probability_below(rounds, rounds.back().shift, o.active.confidence);
    return p.std_error <= o.active.target_cov * o.probability;
}

/// Few checks do not tell a quantile just below censored answers from one among them: an upper
/// end that lies nearer to them than the interval is wide is unknown, and then an estimate that
/// lies nearer to them than to the lower end.
void leave_open(ActiveQuantileResult& r, double known_below)
{
    if (std::isinf(known_below)) return;
    if (known_below - r.interval.upper <= r.interval.upper - r.interval.lower)
        r.interval.upper = kNoEnd;
    if (std::isinf(r.interval.upper) && known_below - r.value <= r.value - r.interval.lower)
        r.value = std::numeric_limits<double>::quiet_NaN();
}

/// The quantile and its interval from all checks.
void answer(ActiveQuantileResult& r, const std::vector<QuantileRound>& rounds,
            const ActiveQuantileOptions& o, const Eigen::VectorXd& y)
{
    r.value = std::numeric_limits<double>::quiet_NaN();
    r.interval = {-kNoEnd, kNoEnd, o.active.confidence};
    if (sound_checks(rounds) < 2) return;
    const QuantileRound& now = rounds.back();
    const double least = process_quantile(now, o.probability / kFarthest, y);
    const double most = process_quantile(
        now, std::min(kFarthest * o.probability, 0.5 * (1.0 + o.probability)), y);
    const QuantileCrossing c =
        crossing(rounds, o.probability, least,
                 std::min(most, std::nextafter(o.known_below, -kNoEnd)), o.active.confidence);
    if (c.lower) r.interval.lower = *c.lower;
    if (c.upper) r.interval.upper = *c.upper;
    if (c.value) r.value = *c.value;
    leave_open(r, o.known_below);
    r.outcome = std::isnan(r.value)  ? SamplingOutcome::none_passed
                : reached(rounds, o) ? SamplingOutcome::target_reached
                                     : SamplingOutcome::limit_reached;
}

} // namespace

ActiveQuantileResult active_quantile(const LimitState& limit, const ActiveQuantileOptions& o)
{
    check(limit);
    check_options(limit, o);
    LimitState s = limit;
    s.threshold = 0.0; // g is the response itself
    ActiveQuantileResult r;
    Ledger ledger;
    Learner learner;
    std::vector<QuantileRound> rounds;
    const Eigen::MatrixXd first = first_design(s.dimension, o.active.seed);
    learner.learn(first, limit_values(s, first, ledger));
    r.learned = ledger.evaluations;
    Eigen::Index known = 0; // behind the last round
    for (std::uint64_t round = 1; ledger.evaluations < o.active.max_evaluations; ++round) {
        const std::uint64_t seed = replicate_seed(o.active.seed, round);
        const auto batch = std::min<Eigen::Index>(
            kActiveBatch,
            static_cast<Eigen::Index>(o.active.max_evaluations - ledger.evaluations));
        Eigen::MatrixXd u;
        bool learns = false;
        try {
            if (rounds.empty() || known != learner.known()) {
                const bool begun = !rounds.empty();
                const double before = begun                 ? rounds.back().shift
                                      : learner.known() > 0 ? learner.values().mean()
                                                            : 0.0;
                QuantileRound now = round_at_quantile(learner, before, o, seed);
                const double change =
                    begun ? std::abs(std::log(process_below(now, before) / o.probability))
                          : kNoEnd;
                known = learner.known();
                if (2 * ledger.evaluations < o.active.max_evaluations) {
                    u = lesson_of(now, learner, learner.process(now.shift), change,
                                  o.active.target_cov, batch, seed);
                    learns = u.rows() > 0;
                }
                if (begun && rounds.back().rows.empty()) rounds.pop_back();
                rounds.push_back(std::move(now));
            }
        } catch (const std::invalid_argument& no_process) {
            r.trouble = no_process.what();
            break;
        }
        r.surrogate = process_quantile(rounds.back(), o.probability, learner.values());
        if (learns) {
            learner.learn(u, limit_values(s, u, ledger));
            r.learned += static_cast<std::size_t>(batch);
            continue;
        }
        const Eigen::VectorXd y = check_points(rounds.back(), s, batch, seed, u, ledger);
        learner.learn(u, y);
        if (reached(rounds, o)) break;
    }
    if (r.trouble.empty()) answer(r, rounds, o, learner.values());
    count(r, rounds);
    r.ledger = std::move(ledger);
    return r;
}

} // namespace uq
