#include "uq/reliability/design_point/form.hpp"

#include "uq/designs/stream.hpp"

#include <Eigen/LU>
#include <gsl/gsl_cdf.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

namespace uq {

namespace {

void check_options(const FormOptions& o)
{
    check(o.search);
    const auto require = [](bool good, const std::string& what) {
        if (!good) throw std::invalid_argument("form: " + what);
    };
    require(o.starts >= 1, "starts must be at least 1");
    require(o.start_radius > 0.0 && std::isfinite(o.start_radius), "start_radius must be > 0");
    require(o.same_point > 0.0, "same_point must be > 0");
    require(o.check != SearchMethod::improved_hl_rf, "the check must be slsqp or cobyla");
}

Eigen::VectorXd start(int k, Eigen::Index dimension, const FormOptions& o)
{
    if (k == 0) return Eigen::VectorXd::Zero(dimension);
    const int pair = (k - 1) / 2;
    Stream random(o.seed, static_cast<std::uint64_t>(pair), Purpose::search);
    Eigen::VectorXd u(dimension);
    for (double& v : u) v = random.normal();
    return (k % 2 == 1 ? o.start_radius : -o.start_radius) * u.normalized();
}

const DesignPoint* nearest(const std::vector<Search>& searches, bool hl_rf)
{
    const DesignPoint* best = nullptr;
    for (const Search& s : searches)
        if (s.point && (s.method == SearchMethod::improved_hl_rf) == hl_rf)
            if (!best || std::abs(s.point->beta) < std::abs(best->beta)) best = &*s.point;
    return best;
}

std::vector<DesignPoint> distinct_points(const std::vector<Search>& searches, double apart)
{
    std::vector<DesignPoint> all;
    for (const Search& s : searches)
        if (s.point) all.push_back(*s.point);
    std::ranges::stable_sort(all, {}, [](const DesignPoint& p) { return std::abs(p.beta); });
    std::vector<DesignPoint> kept;
    for (const DesignPoint& p : all)
        if (std::ranges::none_of(
                kept, [&](const DesignPoint& k) { return (k.at.u - p.at.u).norm() < apart; }))
            kept.push_back(p);
    return kept;
}

std::string first_reason(const std::vector<Search>& searches, bool hl_rf)
{
    for (const Search& s : searches)
        if (!s.point && (s.method == SearchMethod::improved_hl_rf) == hl_rf)
            return std::string(name(s.method)) + ": " + s.reason;
    return {};
}

/// dx/du by central differences: one row for each column of x.
Eigen::MatrixXd jacobian(const Map& to_physical, const Eigen::VectorXd& u)
{
    constexpr double kStep = 1e-3; // [standard deviations]; off by some 1e-7 of the derivative
    const Eigen::Index d = u.size();
    Eigen::MatrixXd at = u.transpose().replicate(2 * d, 1);
    at.topRows(d).diagonal().array() += kStep;
    at.bottomRows(d).diagonal().array() -= kStep;
    const Eigen::MatrixXd x = to_physical(at);
    return (x.topRows(d) - x.bottomRows(d)).transpose() / (2.0 * kStep);
}

/// Compares the two searches by the nearest point each of them found. Points at equal distance
/// are both nearest: then it is enough that both are on the list.
void compare(FormResult& r, const FormOptions& o)
{
    const DesignPoint* a = nearest(r.searches, true);
    const DesignPoint* b = nearest(r.searches, false);
    if (!a && !b) {
        r.reason = first_reason(r.searches, true) + "; " + first_reason(r.searches, false);
    } else if (!a || !b) {
        r.outcome = FormOutcome::one_search;
        r.reason = first_reason(r.searches, a == nullptr);
    } else {
        r.distance = (a->at.u - b->at.u).norm();
        const bool same = r.distance < o.same_point ||
                          std::abs(a->beta - b->beta) <= 2.0 * o.search.on_surface;
        r.outcome = same ? FormOutcome::agreed : FormOutcome::differ;
        std::ostringstream why;
        why << "the nearest points of both searches are " << r.distance << " apart, at beta "
            << a->beta << " and " << b->beta;
        if (!same) r.reason = why.str();
    }
}

/// "the searches did not end within 200 evaluations: 197 were made, and the next step needs
/// more than the 3 left"
std::string ended_by_budget(const Ledger& ledger)
{
    const std::size_t left = ledger.limit - ledger.evaluations;
    return "the searches did not end within " + std::to_string(ledger.limit) +
           " evaluations: " +
           (left == 0 ? "all were made"
                      : std::to_string(ledger.evaluations) +
                            " were made, and the next step needs more than the " +
                            std::to_string(left) + " left");
}

} // namespace

FormResult form(const LimitState& s, const FormOptions& o)
{
    check(s);
    check_options(o);
    FormResult r;
    r.ledger.limit = o.max_evaluations;
    r.ledger.known.emplace(); // both searches of a start begin at the same point
    for (int k = 0; k < o.starts && !r.ledger.used_up; ++k) {
        const Eigen::VectorXd u = start(k, s.dimension, o);
        r.searches.push_back(search_hl_rf(s, u, o.search, r.ledger));
        r.searches.push_back(search_constrained(s, u, o.check, o.search, r.ledger));
    }
    r.points = distinct_points(r.searches, o.same_point);
    compare(r, o);
    if (r.ledger.used_up)
        r.reason = ended_by_budget(r.ledger) + (r.reason.empty() ? "" : "; " + r.reason);
    return r;
}

double probability(const DesignPoint& p) { return gsl_cdf_ugaussian_Q(p.beta); }

Eigen::VectorXd importance_factors(const DesignPoint& p) { return p.alpha.cwiseAbs2(); }

std::optional<Eigen::VectorXd> dependent_importance(const DesignPoint& p,
                                                    const Map& to_physical)
{
    if (!to_physical) return {};
    const Eigen::MatrixXd j = jacobian(to_physical, p.at.u);
    const bool own = ((j.array() != 0.0).rowwise().count() <= 1).all();
    if (own || j.rows() != j.cols() || !j.allFinite()) return {};
    const Eigen::FullPivLU<Eigen::MatrixXd> lu(j.rowwise().normalized());
    if (!lu.isInvertible()) return {};
    // J^-T alpha scaled by D is the solution of (D^-1 J)^T gamma = alpha.
    return lu.transpose().solve(p.alpha).normalized().cwiseAbs2();
}

} // namespace uq
