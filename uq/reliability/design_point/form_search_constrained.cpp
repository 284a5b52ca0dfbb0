#include "uq/reliability/design_point/form_search.hpp"

#include <nlopt.hpp>

#include <cmath>
#include <stdexcept>

namespace uq {

namespace {

constexpr double kFirstStep = 0.5; // [standard deviations] of cobyla; tuned
constexpr int kValuesPerIteration = 10;

Eigen::Map<const Eigen::VectorXd> view(const std::vector<double>& u)
{
    return {u.data(), static_cast<Eigen::Index>(u.size())};
}

double half_square(const std::vector<double>& u, std::vector<double>& gradient, void*)
{
    if (!gradient.empty()) gradient = u;
    return 0.5 * view(u).squaredNorm();
}

/// g over `scale`, so that tolerances are in standard deviations.
struct Constraint {
    const LimitState* s;
    double step, scale;
    Ledger* ledger;
    int calls = 0;

    double operator()(const std::vector<double>& u, std::vector<double>& gradient)
    {
        ++calls;
        if (gradient.empty()) {
            const double g = limit_values(*s, view(u).transpose(), *ledger)(0);
            if (std::isnan(g)) throw nlopt::forced_stop();
            return g / scale;
        }
        const std::optional<LinearLimit> l = linearise(*s, view(u), step, *ledger);
        if (!l) throw nlopt::forced_stop();
        Eigen::Map<Eigen::VectorXd>(gradient.data(), l->gradient.size()) = l->gradient / scale;
        return l->g / scale;
    }
};

double constraint(const std::vector<double>& u, std::vector<double>& gradient, void* data)
{
    return (*static_cast<Constraint*>(data))(u, gradient);
}

/// Why NLopt stopped where the design point may still be found near; else its complaint.
void minimise(nlopt::opt& problem, std::vector<double>& u, const Ledger& ledger, Search& search)
{
    double least = 0.0;
    try {
        if (problem.optimize(u, least) == nlopt::MAXEVAL_REACHED)
            give_up(search, SearchOutcome::iterations_used_up, "all iterations used up");
    } catch (const nlopt::roundoff_limited&) { // as near as it gets: judged like any other end
    } catch (const nlopt::forced_stop&) {
        give_up_without_value(search, ledger, "at a point needed");
    } catch (const std::runtime_error& e) { // "nlopt failure"
        give_up(search, SearchOutcome::no_descent, e.what());
    }
}

} // namespace

Search search_constrained(const LimitState& s, const Eigen::VectorXd& start,
                          SearchMethod method, const SearchOptions& o, Ledger& ledger)
{
    Search search{method, start, {}, {}, {}, 0, 0};
    const std::size_t before = ledger.evaluations;
    const auto done = [&]() -> Search& {
        search.evaluations = ledger.evaluations - before;
        return search;
    };
    const std::optional<LinearLimit> first = linearise(s, start, o.step, ledger);
    if (!first)
        give_up_without_value(search, ledger, "at the start");
    else if (!(first->gradient.norm() > 0.0))
        give_up(search, SearchOutcome::flat, "the gradient is zero at the start");
    if (!search.reason.empty()) return done();

    Constraint g{&s, o.step, first->gradient.norm(), &ledger};
    nlopt::opt problem(method == SearchMethod::cobyla ? nlopt::LN_COBYLA : nlopt::LD_SLSQP,
                       static_cast<unsigned>(start.size()));
    problem.set_min_objective(half_square, nullptr);
    problem.add_equality_constraint(constraint, &g, 0.1 * o.on_surface);
    problem.set_maxeval(kValuesPerIteration * o.max_iterations);
    problem.set_xtol_abs(0.1 * std::min(o.on_surface, o.on_axis));
    problem.set_initial_step(kFirstStep);
    std::vector<double> u(start.begin(), start.end());
    minimise(problem, u, ledger, search);
    search.iterations = g.calls;
    if (!search.reason.empty()) return done();
    if (const auto l = linearise(s, view(u), o.step, ledger))
        judge(*l, o, search);
    else
        give_up_without_value(search, ledger, "where it stopped");
    return done();
}

} // namespace uq
