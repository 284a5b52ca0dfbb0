#include "uq/reliability/design_point/form_search.hpp"

#include <algorithm>
#include <cmath>

namespace uq {

namespace {

constexpr double kArmijo = 1e-4; // [-] share of the predicted fall asked for; usual
constexpr double kPenalty = 2.0; // [-] Haukaas and Der Kiureghian (2006): gamma = 2
constexpr int kHalvings = 10;    // tuned: 1e-3 of a step is no progress

double merit(const Eigen::VectorXd& u, double g, double c)
{
    return 0.5 * u.squaredNorm() + c * std::abs(g);
}

/// Weight of |g| in the merit that makes `step` a direction of descent.
double penalty(const LinearLimit& l, const Eigen::VectorXd& step, double on_surface)
{
    const double slope = l.u.norm() / l.gradient.norm();
    if (std::abs(distance_to_plane(l)) <= on_surface) return kPenalty * slope;
    return kPenalty * std::max(slope, 0.5 * (l.u + step).squaredNorm() / std::abs(l.g));
}

struct Merit {
    double c, at_start, slope; ///< slope along the full step, < 0
    [[nodiscard]] bool accepts(const Eigen::VectorXd& u, double g, double lambda) const
    {
        // Rounding of the merit must not stop a search that has arrived.
        const double allowance = 1e-14 * std::abs(at_start);
        return merit(u, g, c) <= at_start + kArmijo * lambda * slope + allowance;
    }
};

/// The longest of the halved steps that is accepted, linearised; nothing if there is none.
std::optional<LinearLimit> shorter_step(const LimitState& s, const LinearLimit& l,
                                        const Eigen::VectorXd& step, const Merit& m,
                                        double difference, Ledger& ledger)
{
    Eigen::MatrixXd trials(kHalvings, l.u.size());
    for (int k = 0; k < kHalvings; ++k)
        trials.row(k) = (l.u + std::ldexp(1.0, -k - 1) * step).transpose();
    const Eigen::VectorXd g = limit_values(s, trials, ledger);
    for (int k = 0; k < kHalvings; ++k)
        if (m.accepts(trials.row(k).transpose(), g(k), std::ldexp(1.0, -k - 1)))
            return linearise(s, trials.row(k).transpose(), difference, ledger);
    return std::nullopt;
}

bool arrived(const LinearLimit& l, const SearchOptions& o)
{
    return std::abs(distance_to_plane(l)) <= o.on_surface && off_axis(l) <= o.on_axis;
}

/// One step of the search; nothing if no point is better.
std::optional<LinearLimit> advance(const LimitState& s, const LinearLimit& l,
                                   const SearchOptions& o, Ledger& ledger)
{
    const Eigen::VectorXd alpha = direction(l);
    const Eigen::VectorXd step = (alpha.dot(l.u) + distance_to_plane(l)) * alpha - l.u;
    const double c = penalty(l, step, o.on_surface);
    const double sign = l.g > 0.0 ? 1.0 : (l.g < 0.0 ? -1.0 : 0.0);
    const Merit m{c, merit(l.u, l.g, c),
                  std::min(0.0, l.u.dot(step) + c * sign * l.gradient.dot(step))};
    const Eigen::VectorXd full = l.u + step;
    const std::optional<LinearLimit> next = linearise(s, full, o.step, ledger);
    if (next && next->gradient.norm() > 0.0 && m.accepts(full, next->g, 1.0)) return next;
    return shorter_step(s, l, step, m, o.step, ledger);
}

} // namespace

Search search_hl_rf(const LimitState& s, const Eigen::VectorXd& start, const SearchOptions& o,
                    Ledger& ledger)
{
    Search search{SearchMethod::improved_hl_rf, start, {}, {}, {}, 1, 0};
    const std::size_t before = ledger.evaluations;
    std::optional<LinearLimit> l = linearise(s, start, o.step, ledger);
    if (!l) give_up_without_value(search, ledger, "at the start");
    while (l && l->gradient.norm() > 0.0 && !arrived(*l, o) &&
           search.iterations < o.max_iterations) {
        std::optional<LinearLimit> next = advance(s, *l, o, ledger);
        ++search.iterations;
        if (!next) break;
        l = std::move(next);
    }
    search.evaluations = ledger.evaluations - before;
    if (!l) return search;
    judge(*l, o, search);
    if (search.point || search.outcome == SearchOutcome::flat) return search;
    search.outcome = search.iterations < o.max_iterations ? SearchOutcome::no_descent
                                                          : SearchOutcome::iterations_used_up;
    return search;
}

} // namespace uq
