#include "uq/reliability/reliability.hpp"

#include "core/normal.hpp"
#include "uq/designs/sobol.hpp"
#include "uq/reliability/active/active_learning.hpp"
#include "uq/reliability/active/active_quantile.hpp"
#include "uq/reliability/design_methods.hpp"
#include "uq/reliability/method_answers.hpp"
#include "uq/reliability/noted_model.hpp"
#include "uq/reliability/simulation/crude_monte_carlo.hpp"
#include "uq/reliability/simulation/subset_simulation.hpp"
#include "uq/sensitivity/regression.hpp"
#include "uq/sensitivity/sobol_indices.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <stdexcept>
#include <utility>

namespace uq {
namespace {

constexpr Eigen::Index kBatch = 100; ///< evaluations asked for at a time
/// Levels that the budget of subset simulation is meant for: probabilities down to about 1e-5.
constexpr int kSubsetLevels = 5;

void plain(const ReliabilityProblem& p, ReliabilityAnswer& a)
{
    MonteCarloOptions o;
    o.max_samples = static_cast<std::size_t>(p.budget);
    o.batch = std::min<std::size_t>(100, o.max_samples);
    o.target_cov = p.target_cov;
    o.seed = p.seed;
    add("Monte Carlo", crude_monte_carlo(p.event, o), a);
}

void subsets(const ReliabilityProblem& p, ReliabilityAnswer& a)
{
    SubsetOptions o;
    o.samples = static_cast<std::size_t>(p.budget) / (10 * kSubsetLevels) * 10;
    o.max_evaluations = static_cast<std::size_t>(p.budget);
    o.target_cov = p.target_cov;
    o.seed = p.seed;
    const SubsetResult r = subset_simulation(p.event, o);
    add("subset simulation", r.exceedance, a);
    if (r.exceedance.outcome == SamplingOutcome::limit_reached)
        a.methods.back().outcome =
            std::string("target coefficient of variation not reached: another ") +
            (r.arrived ? "run" : "level") + " would not fit into the budget of " +
            std::to_string(p.budget);
}

void two_fidelities(const ReliabilityProblem& p, ReliabilityAnswer& a)
{
    MultiFidelityOptions o;
    o.quantity = Quantity::probability;
    o.expensive_cost = 1.0;
    o.budget = p.budget;
    o.pilot = std::max<std::size_t>(20, static_cast<std::size_t>(p.budget) / 4);
    o.seed = p.seed;
    const MultiFidelityResult r = multi_fidelity(p.event, p.cheap, o);
    take(r.expensive, a);
    MethodAnswer m;
    m.method = "multi-fidelity";
    m.probability = r.estimate.value;
    m.std_error = r.estimate.std_error;
    m.lower = r.estimate.interval.lower;
    m.upper = r.estimate.interval.upper;
    m.outcome = r.reason.empty()
                    ? "the cheap model reduced the error"
                    : "plain Monte Carlo, since the cheap model does not help: " + r.reason;
    a.methods.push_back(m);
    MethodAnswer alone;
    alone.method = "its expensive samples alone";
    alone.std_error = r.plain_std_error;
    alone.outcome = "for comparison";
    a.methods.push_back(alone);
}

void learning(const ReliabilityProblem& p, ReliabilityAnswer& a)
{
    ActiveOptions o;
    o.max_evaluations = static_cast<std::size_t>(p.budget);
    o.target_cov = p.target_cov;
    o.seed = p.seed;
    const ActiveResult r = active_learning(p.event, o);
    add("active learning", r.exceedance, a);
    if (!r.trouble.empty()) {
        a.methods.back().outcome = "there is no process of the response: " + r.trouble;
        return;
    }
    if (r.exceedance.outcome == SamplingOutcome::none_passed)
        a.methods.back().outcome = "the event was never seen: an upper bound, if the process "
                                   "is right where it was not checked";
    MethodAnswer alone;
    alone.method = "its process alone";
    alone.probability = r.surrogate;
    alone.outcome = "for comparison: after " + std::to_string(r.learned) +
                    " evaluations to learn from, " + std::to_string(r.surprises) + " of " +
                    std::to_string(r.checks) + " checks contradicted the process";
    a.methods.push_back(alone);
}

void learning_quantile(const ReliabilityProblem& p, ReliabilityAnswer& a)
{
    ActiveQuantileOptions o;
    o.probability = p.quantile;
    o.known_below = p.known_below;
    o.active.max_evaluations = static_cast<std::size_t>(p.budget);
    o.active.target_cov = p.target_cov;
    o.active.seed = p.seed;
    const ActiveQuantileResult r = active_quantile(p.event, o);
    take(r.ledger, a);
    const auto known = [](double x) {
        return std::isfinite(x) ? std::optional(x) : std::nullopt;
    };
    MethodAnswer m;
    m.method = "active learning";
    m.quantile = known(r.value);
    m.lower = known(r.interval.lower);
    m.upper = known(r.interval.upper);
    m.outcome = !r.trouble.empty() ? "there is no process of the response: " + r.trouble
                : r.outcome == SamplingOutcome::target_reached
                    ? "its probability is known to the target coefficient of variation"
                : m.quantile ? "the budget was used up before the target was reached"
                : m.lower    ? "it lies beyond what is known: a lower bound"
                             : "there is no answer";
    a.methods.push_back(m);
    if (!r.trouble.empty()) return;
    MethodAnswer alone;
    alone.method = "its process alone";
    alone.quantile = known(r.surrogate);
    alone.outcome = "for comparison: after " + std::to_string(r.learned) +
                    " evaluations to learn from, " + std::to_string(r.surprises) + " of " +
                    std::to_string(r.checks) + " checks contradicted the process";
    a.methods.push_back(alone);
}

/// An index as a share: the estimate may leave [0, 1] by its error.
InputShare share_of(const std::string& input, const Estimate& e)
{
    const auto share = [](double x) { return std::clamp(x, 0.0, 1.0); };
    return {input, share(e.value), e.std_error, share(e.interval.lower),
            share(e.interval.upper)};
}

/// A first-order index is never above the total one: where an estimate is, their errors hide
/// what lies between.
void tell_not_told_apart(const SobolIndices& s, const std::vector<std::string>& names,
                         ReliabilityAnswer& a)
{
    std::string inputs;
    for (std::size_t i = 0; i < s.inputs.size(); ++i)
        if (s.inputs[i].first.value > s.inputs[i].total.value)
            inputs += (inputs.empty() ? "" : ", ") + names[i];
    if (!inputs.empty())
        a.warnings.push_back("first-order and total Sobol' index are not told apart for " +
                             inputs +
                             ": the first comes out above the total, which it cannot be; more "
                             "evaluations (reliability.budget) narrow both");
}

/// First-order and total indices, and the probability from the rows that are independent.
void variance_shares(const ReliabilityProblem& p, ReliabilityAnswer& a)
{
    const Eigen::Index d = p.event.dimension, n = p.budget / (d + 2);
    const Eigen::MatrixXd cube = sobol(0, n, 2 * static_cast<int>(d), p.seed);
    Eigen::MatrixXd u = pick_freeze(cube.leftCols(d), cube.rightCols(d));
    core::to_normal_quantiles({u.data(), static_cast<std::size_t>(u.size())});
    Ledger ledger;
    Eigen::VectorXd g(u.rows());
    for (Eigen::Index first = 0; first < u.rows(); first += kBatch) {
        const Eigen::Index rows = std::min<Eigen::Index>(kBatch, u.rows() - first);
        g.segment(first, rows) = limit_values(p.event, u.middleRows(first, rows), ledger);
    }
    const Eigen::ArrayXd independent = g.head(2 * n);
    const auto passed = static_cast<std::size_t>((independent <= 0.0).count()); // NaN is not
    const auto failed = static_cast<std::size_t>(independent.isNaN().count());
    Exceedance e = count_exceedance(passed, failed, static_cast<std::size_t>(2 * n), 0.95);
    e.ledger = std::move(ledger);
    add("Sobol' points", e, a);
    if (e.outcome == SamplingOutcome::limit_reached) // no target ends these evaluations
        a.methods.back().outcome = "of the evaluations that the indices need";
    Sensitivity one{"first-order Sobol' index", {}};
    Sensitivity all{"total Sobol' index", {}};
    SobolIndices s;
    try {
        s = sobol_indices(g, d);
    } catch (const std::invalid_argument& none) {
        a.warnings.push_back(std::string("there are no Sobol' indices: ") + none.what());
        return;
    }
    for (std::size_t i = 0; i < s.inputs.size(); ++i) {
        one.shares.push_back(share_of(p.normal[i], s.inputs[i].first));
        all.shares.push_back(share_of(p.normal[i], s.inputs[i].total));
    }
    a.sensitivities = {one, all};
    tell_not_told_apart(s, p.normal, a);
}

/// Partial rank correlations from independent samples.
void rank_correlations(const ReliabilityProblem& p, const std::vector<Evaluated>& seen,
                       ReliabilityAnswer& a)
{
    const auto d = static_cast<Eigen::Index>(p.inputs.size());
    std::vector<const Evaluated*> sound;
    for (const Evaluated& e : seen)
        if (e.failure.empty()) sound.push_back(&e);
    const auto n = static_cast<Eigen::Index>(sound.size());
    if (n < 2 * d + 10 || d > 50) return;
    Eigen::MatrixXd x(n, d);
    Eigen::VectorXd y(n);
    for (Eigen::Index i = 0; i < n; ++i) {
        x.row(i) = sound[i]->x.transpose();
        y(i) = sound[i]->response;
    }
    const auto r = regress(x, y, {.scale = RegressionScale::ranks});
    if (!r) return;
    Sensitivity s{"partial rank correlation with the response", {}};
    for (std::size_t i = 0; i < r->inputs.size(); ++i) {
        const Estimate& e = r->inputs[i].partial;
        s.shares.push_back({p.inputs[i], e.value, {}, e.interval.lower, e.interval.upper});
    }
    a.sensitivities.push_back(std::move(s));
}

void check_problem(const ReliabilityProblem& p)
{
    const auto refuse = [](const std::string& why) {
        throw std::invalid_argument("reliability: " + why);
    };
    check(p.event);
    const auto check_names = [&](const std::vector<std::string>& names, Eigen::Index n,
                                 const std::string& what) {
        if (static_cast<Eigen::Index>(names.size()) != n)
            refuse("there must be a name for each of the " + std::to_string(n) + " " + what +
                   ", but there are " + std::to_string(names.size()));
    };
    const Eigen::MatrixXd medians = Eigen::MatrixXd::Zero(1, p.event.dimension);
    check_names(p.normal, p.event.dimension, "coordinates");
    check_names(p.inputs,
                p.event.to_physical ? p.event.to_physical(medians).cols() : p.event.dimension,
                "inputs");
    if (const std::string why = budget_too_small(p.method, p.budget, p.event.dimension);
        !why.empty())
        refuse("the budget " + why);
    if (p.quantile != 0.0 && p.method != ReliabilityMethod::active)
        refuse("a quantile needs the method active");
    if (p.method == ReliabilityMethod::multi_fidelity && p.cheap.empty())
        refuse("multi_fidelity needs a cheap model");
}

/// The commonest reasons of failed evaluations, with their numbers.
void tell_failures(ReliabilityAnswer& a)
{
    constexpr std::size_t kShown = 3;
    std::map<std::string, std::size_t> number;
    for (const FailedSample& f : a.failed) ++number[f.reason];
    std::vector<std::pair<std::size_t, std::string>> sorted;
    for (const auto& [reason, n] : number) sorted.emplace_back(n, reason);
    std::ranges::stable_sort(sorted, std::greater<>(),
                             &std::pair<std::size_t, std::string>::first);
    for (std::size_t i = 0; i < std::min(kShown, sorted.size()); ++i)
        a.warnings.push_back(std::to_string(sorted[i].first) + " of " +
                             std::to_string(a.evaluations) +
                             " evaluations failed: " + sorted[i].second);
    if (sorted.size() > kShown)
        a.warnings.push_back(std::to_string(sorted.size() - kShown) +
                             " further reasons of failed evaluations are not shown");
}

} // namespace

std::string budget_too_small(ReliabilityMethod method, int budget, Eigen::Index dimension)
{
    const auto d = static_cast<int>(dimension);
    const auto need = [budget](int least, const char* what) {
        return budget >= least ? std::string()
                               : std::string("must be at least ") + std::to_string(least) +
                                     " for this method and number of inputs: " + what;
    };
    switch (method) {
    case ReliabilityMethod::form:
        return need(2 * (2 * d + 1), "one gradient for each of two searches");
    case ReliabilityMethod::importance:
        return need(4 * (2 * d + 1), "a search for the design point, then samples around it");
    case ReliabilityMethod::subset:
        return need(10 * kSubsetLevels, "ten samples for each of five levels");
    case ReliabilityMethod::multi_fidelity:
        return need(40, "twenty pilot samples of both models");
    case ReliabilityMethod::sobol:
        return need(10 * (d + 2), "ten rows of the number of inputs + 2 evaluations each");
    case ReliabilityMethod::active:
        return need(static_cast<int>(least_active_budget(dimension)),
                    "first points, then two rounds of learning and two of checks");
    case ReliabilityMethod::monte_carlo:
        break;
    }
    return need(1, "one sample");
}

ReliabilityAnswer reliability(const ReliabilityProblem& problem, const OnBatch& on_batch)
{
    check_problem(problem);
    std::vector<Evaluated> seen;
    ReliabilityProblem p = problem;
    p.event.model = noted_model(problem.event, seen, on_batch);
    ReliabilityAnswer a;
    const auto budget = static_cast<std::size_t>(p.budget);
    switch (p.method) {
    case ReliabilityMethod::monte_carlo:
        plain(p, a);
        rank_correlations(p, seen, a);
        break;
    case ReliabilityMethod::form: {
        const FormResult first = search(p, budget, a);
        look_elsewhere(p, first, a);
        if (!p.rough) second_order(p, first, a);
        break;
    }
    case ReliabilityMethod::importance:
        important(p, search(p, budget / 2, a), a);
        break;
    case ReliabilityMethod::subset:
        subsets(p, a);
        break;
    case ReliabilityMethod::multi_fidelity:
        two_fidelities(p, a);
        break;
    case ReliabilityMethod::sobol:
        variance_shares(p, a);
        break;
    case ReliabilityMethod::active:
        p.quantile > 0.0 ? learning_quantile(p, a) : learning(p, a);
        break;
    }
    tell_failures(a);
    return a;
}

} // namespace uq
