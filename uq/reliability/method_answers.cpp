#include "uq/reliability/method_answers.hpp"

#include <algorithm>

namespace uq {
namespace {

std::string words(SamplingOutcome o)
{
    switch (o) {
    case SamplingOutcome::target_reached:
        return "target coefficient of variation reached";
    case SamplingOutcome::limit_reached:
        return "the budget was used up before the target coefficient of variation was reached";
    case SamplingOutcome::none_passed:
        return "the event was never seen: an upper bound";
    case SamplingOutcome::all_passed:
        return "the event was always seen: a lower bound";
    case SamplingOutcome::no_answer:
        break;
    }
    return "no run succeeded; the bounds assume the worst and the best case";
}

MethodAnswer sampled(const std::string& method, const Exceedance& e)
{
    MethodAnswer m;
    m.method = method;
    m.outcome = words(e.outcome);
    m.lower = e.estimate.interval.lower;
    m.upper = e.estimate.interval.upper;
    const bool bound = e.outcome == SamplingOutcome::none_passed ||
                       e.outcome == SamplingOutcome::all_passed ||
                       e.outcome == SamplingOutcome::no_answer;
    if (!bound) {
        m.probability = e.estimate.value;
        m.std_error = e.estimate.std_error;
    }
    return m;
}

} // namespace

std::size_t left(const ReliabilityProblem& p, const ReliabilityAnswer& a)
{
    const auto budget = static_cast<std::size_t>(p.budget);
    return budget - std::min(budget, a.evaluations);
}

void take(const Ledger& ledger, ReliabilityAnswer& a)
{
    a.evaluations += ledger.evaluations;
    a.failed.insert(a.failed.end(), ledger.failed.begin(), ledger.failed.end());
}

void add(const std::string& method, const Exceedance& e, ReliabilityAnswer& a)
{
    a.methods.push_back(sampled(method, e));
    a.warnings.insert(a.warnings.end(), e.warnings.begin(), e.warnings.end());
    take(e.ledger, a);
}

} // namespace uq
