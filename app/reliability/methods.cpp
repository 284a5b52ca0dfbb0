#include "app/reliability/methods.hpp"

#include "uq/reliability/crude_monte_carlo.hpp"
#include "uq/reliability/exceedance.hpp"
#include "uq/reliability/form.hpp"
#include "uq/reliability/importance_sampling.hpp"
#include "uq/reliability/sorm.hpp"
#include "uq/reliability/subset_simulation.hpp"
#include "uq/sensitivity/regression.hpp"

#include <algorithm>

namespace app {
namespace {

std::string words(uq::SamplingOutcome o)
{
    switch (o) {
    case uq::SamplingOutcome::target_reached:
        return "as sharp as asked for";
    case uq::SamplingOutcome::limit_reached:
        return "budget used up first";
    case uq::SamplingOutcome::none_passed:
        return "the event was never seen: an upper bound";
    case uq::SamplingOutcome::all_passed:
        return "the event was always seen: a lower bound";
    case uq::SamplingOutcome::no_answer:
        break;
    }
    return "every evaluation failed";
}

std::string words(const uq::FormResult& r)
{
    if (r.outcome == uq::FormOutcome::agreed) return "two searches agree";
    return r.reason;
}

void take(const uq::Ledger& ledger, ReliabilityAnswer& a)
{
    a.evaluations += ledger.evaluations;
    a.failed.insert(a.failed.end(), ledger.failed.begin(), ledger.failed.end());
}

MethodAnswer sampled(const std::string& method, const uq::Exceedance& e)
{
    MethodAnswer m;
    m.method = method;
    m.outcome = words(e.outcome);
    m.lower = e.estimate.interval.lower;
    m.upper = e.estimate.interval.upper;
    const bool bound = e.outcome == uq::SamplingOutcome::none_passed ||
                       e.outcome == uq::SamplingOutcome::all_passed ||
                       e.outcome == uq::SamplingOutcome::no_answer;
    if (!bound) {
        m.probability = e.estimate.value;
        m.std_error = e.estimate.std_error;
    }
    return m;
}

void add(const std::string& method, const uq::Exceedance& e, ReliabilityAnswer& a)
{
    a.methods.push_back(sampled(method, e));
    a.warnings.insert(a.warnings.end(), e.warnings.begin(), e.warnings.end());
    take(e.ledger, a);
}

/// Design point first; @return what was found
uq::FormResult search(const ReliabilityProblem& p, ReliabilityAnswer& a)
{
    uq::FormOptions o;
    o.seed = p.seed;
    uq::FormResult r = uq::form(p.event, o);
    take(r.ledger, a);
    MethodAnswer m;
    m.method = "FORM";
    m.outcome = words(r);
    if (r.outcome == uq::FormOutcome::agreed) m.probability = uq::probability(r.points.front());
    a.methods.push_back(m);
    if (!r.points.empty()) {
        const Eigen::VectorXd share = uq::importance_factors(r.points.front());
        a.share_name = "share of the variance of the linearised event, alpha^2";
        for (Eigen::Index i = 0; i < share.size(); ++i)
            a.shares.push_back({p.normal[static_cast<std::size_t>(i)], share(i), {}, {}});
    }
    return r;
}

void second_order(const ReliabilityProblem& p, const uq::FormResult& first,
                  ReliabilityAnswer& a)
{
    if (first.outcome != uq::FormOutcome::agreed) return;
    const uq::SormResult r = uq::sorm(p.event, first.points.front());
    take(r.ledger, a);
    const auto one = [&](const char* name, const std::optional<double>& value) {
        MethodAnswer m;
        m.method = std::string("SORM, ") + name;
        m.probability = value;
        m.outcome = value ? "curvatures by differences"
                          : (r.reason.empty() ? "not defined for these curvatures" : r.reason);
        a.methods.push_back(m);
    };
    one("Breitung", r.breitung);
    one("Hohenbichler", r.hohenbichler);
    one("Tvedt", r.tvedt);
}

void important(const ReliabilityProblem& p, const uq::FormResult& first, ReliabilityAnswer& a)
{
    if (first.points.empty()) {
        a.warnings.emplace_back("no design point was found: no importance sampling");
        return;
    }
    Eigen::MatrixXd centres(static_cast<Eigen::Index>(first.points.size()), p.event.dimension);
    for (Eigen::Index i = 0; i < centres.rows(); ++i)
        centres.row(i) = first.points[static_cast<std::size_t>(i)].at.u.transpose();
    uq::ImportanceOptions o;
    o.max_samples = static_cast<std::size_t>(p.budget);
    o.batch = std::min<std::size_t>(o.batch, o.max_samples);
    o.target_cov = p.target_cov;
    o.seed = p.seed;
    add("importance sampling", uq::importance_sampling(p.event, centres, o).exceedance, a);
}

void plain(const ReliabilityProblem& p, ReliabilityAnswer& a)
{
    uq::MonteCarloOptions o;
    o.max_samples = static_cast<std::size_t>(p.budget);
    o.batch = std::min<std::size_t>(100, o.max_samples);
    o.target_cov = p.target_cov;
    o.seed = p.seed;
    add("Monte Carlo", uq::crude_monte_carlo(p.event, o), a);
}

void subsets(const ReliabilityProblem& p, ReliabilityAnswer& a)
{
    uq::SubsetOptions o;
    o.samples = static_cast<std::size_t>(p.budget) / 10 * 10;
    o.seed = p.seed;
    add("subset simulation", uq::subset_simulation(p.event, o).exceedance, a);
}

void two_fidelities(const ReliabilityProblem& p, ReliabilityAnswer& a)
{
    uq::MultiFidelityOptions o;
    o.quantity = uq::Quantity::probability;
    o.expensive_cost = 1.0;
    o.budget = p.budget;
    o.pilot = std::max<std::size_t>(20, static_cast<std::size_t>(p.budget) / 4);
    o.seed = p.seed;
    const uq::MultiFidelityResult r = uq::multi_fidelity(p.event, p.cheap, o);
    take(r.expensive, a);
    MethodAnswer m;
    m.method = "multi-fidelity";
    m.probability = r.estimate.value;
    m.std_error = r.estimate.std_error;
    m.lower = r.estimate.interval.lower;
    m.upper = r.estimate.interval.upper;
    m.outcome = r.reason.empty() ? "the cheap model reduced the error" : r.reason;
    a.methods.push_back(m);
    MethodAnswer alone;
    alone.method = "its expensive samples alone";
    alone.std_error = r.plain_std_error;
    alone.outcome = "for comparison";
    a.methods.push_back(alone);
}

/// Of independent samples.
void regress(const ReliabilityProblem& p, const std::vector<Evaluated>& seen,
             ReliabilityAnswer& a)
{
    const auto n = static_cast<Eigen::Index>(seen.size());
    const auto d = static_cast<Eigen::Index>(p.inputs.size());
    if (n < 2 * d + 10 || d > 50) return;
    Eigen::MatrixXd x(n, d);
    Eigen::VectorXd y(n);
    for (Eigen::Index i = 0; i < n; ++i) {
        x.row(i) = seen[static_cast<std::size_t>(i)].x.transpose();
        y(i) = seen[static_cast<std::size_t>(i)].response;
    }
    const auto r = uq::regress(x, y, {.scale = uq::RegressionScale::ranks});
    if (!r) return;
    a.share_name = "partial rank correlation with the response";
    for (std::size_t i = 0; i < r->inputs.size(); ++i) {
        const uq::Estimate& e = r->inputs[i].partial;
        a.shares.push_back({p.inputs[i], e.value, e.interval.lower, e.interval.upper});
    }
}

/// The model, with a note of what it was asked and what it said.
uq::BlackBox noting(const uq::LimitState& s, std::vector<Evaluated>& seen)
{
    return [model = s.model, response = s.response, &seen](const uq::Samples& samples) {
        uq::Responses r = model(samples);
        for (Eigen::Index i = 0; i < samples.x.rows(); ++i)
            seen.push_back({samples.x.row(i).transpose(), r.y(i, response),
                            r.failure[static_cast<std::size_t>(i)]});
        return r;
    };
}

} // namespace

ReliabilityAnswer answer(const ReliabilityProblem& problem, std::vector<Evaluated>& seen)
{
    ReliabilityProblem p = problem;
    p.event.model = noting(problem.event, seen);
    ReliabilityAnswer a;
    switch (p.method) {
    case ReliabilityMethod::monte_carlo:
        plain(p, a);
        regress(p, seen, a);
        break;
    case ReliabilityMethod::form:
        second_order(p, search(p, a), a);
        break;
    case ReliabilityMethod::importance:
        important(p, search(p, a), a);
        break;
    case ReliabilityMethod::subset:
        subsets(p, a);
        break;
    case ReliabilityMethod::multi_fidelity:
        two_fidelities(p, a);
        break;
    }
    return a;
}

} // namespace app
