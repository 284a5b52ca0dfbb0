#include "uq/reliability/design_methods.hpp"

#include "uq/designs/stream.hpp"
#include "uq/reliability/design_point/sorm.hpp"
#include "uq/reliability/limit_state/evaluate.hpp"
#include "uq/reliability/method_answers.hpp"
#include "uq/reliability/simulation/importance_sampling.hpp"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <utility>

namespace uq {
namespace {

/// Empty where there are several points: a warning says it then.
std::string words(const FormResult& r)
{
    if (r.outcome != FormOutcome::agreed || !r.reason.empty()) return r.reason;
    return r.points.size() == 1 ? "two searches found the same point" : "";
}

/// Shares by FORM: of the coordinates where each input has one of its own, else of dependent
/// inputs.
Sensitivity importance_of(const DesignPoint& point, const ReliabilityProblem& p)
{
    const auto dependent = dependent_importance(point, p.event.to_physical);
    Sensitivity s{dependent ? "gamma^2 of FORM" : "alpha^2 of FORM", {}};
    const Eigen::VectorXd share = dependent ? *dependent : importance_factors(point);
    const auto& names = dependent ? p.inputs : p.normal;
    for (Eigen::Index i = 0; i < share.size(); ++i)
        s.shares.push_back({names[static_cast<std::size_t>(i)], share(i), {}, {}, {}});
    return s;
}

void take(const FormResult& r, const ReliabilityProblem& p, ReliabilityAnswer& a)
{
    for (const DesignPoint& point : r.points) {
        const Eigen::MatrixXd u = point.at.u.transpose();
        a.points.push_back(
            {point.beta, point.at.u,
             p.event.to_physical ? p.event.to_physical(u).row(0).transpose() : point.at.u});
    }
    if (!r.points.empty()) a.sensitivities.push_back(importance_of(r.points.front(), p));
}

/// The searches of a model that scatters. A wall's answer scatters by about 0.2 % of its force,
/// which is some hundredths of a standard deviation of u: differences over 0.3 give a direction
/// good to about 5 degrees, and a point that far off its axis is wrong in beta by 0.5 %.
void loosen(FormOptions& o)
{
    o.search.step = 0.3;
    o.search.on_surface = 0.03;
    o.search.on_axis = 0.3;
    o.search.max_iterations = 20;
    o.same_point = 0.6;
}

} // namespace

void look_elsewhere(const ReliabilityProblem& p, const FormResult& found, ReliabilityAnswer& a)
{
    constexpr std::size_t kLooks = 100;
    constexpr double kFurther =
        1.2; ///< there P of one direction is a tenth of that at beta = 3
    if (found.points.empty() || !(found.points.front().beta > 0.0)) return;
    const std::size_t n = std::min(kLooks, left(p, a) / 2);
    const double radius = kFurther * found.points.front().beta;
    Eigen::MatrixXd u(static_cast<Eigen::Index>(n), p.event.dimension);
    Eigen::Index rows = 0;
    for (std::uint64_t k = 0; k < 20 * n && rows < u.rows(); ++k) {
        Stream random(p.seed, k, Purpose::bootstrap);
        Eigen::VectorXd way(p.event.dimension);
        for (double& v : way) v = random.normal();
        way.normalize();
        if (std::ranges::none_of(found.points, [&](const DesignPoint& d) {
                return d.at.u.normalized().dot(way) > 1e-9;
            }))
            u.row(rows++) = radius * way.transpose();
    }
    if (rows == 0) return;
    Ledger ledger;
    const Eigen::VectorXd g = limit_values(p.event, u.topRows(rows), ledger);
    take(ledger, a);
    const auto reached = (g.array() <= 0.0).count();
    const std::string checks =
        std::to_string(rows) + " checks in other directions (at 1.2 beta)";
    if (reached > 0) {
        a.warnings.push_back("the event occurs elsewhere too: in " + std::to_string(reached) +
                             " of " + checks +
                             ". FORM gives the probability of one design point alone; "
                             "method = subset or monte_carlo counts all");
        return;
    }
    std::string& outcome = a.methods.front().outcome;
    outcome += (outcome.empty() ? "" : "; ") + checks + " found no other failure region";
}

FormResult search(const ReliabilityProblem& p, std::size_t budget, ReliabilityAnswer& a)
{
    FormOptions o;
    o.seed = p.seed;
    o.max_evaluations = budget;
    if (p.rough) loosen(o);
    FormResult r = form(p.event, o);
    take(r.ledger, a);
    take(r, p, a);
    MethodAnswer m;
    m.method = "FORM";
    m.outcome = words(r);
    if (r.outcome == FormOutcome::agreed) m.probability = probability(r.points.front());
    a.methods.push_back(m);
    if (r.points.size() > 1)
        a.warnings.push_back("FORM found " + std::to_string(r.points.size()) +
                             " design points and gives the probability of the nearest one "
                             "alone; method = importance takes all of them");
    return r;
}

void second_order(const ReliabilityProblem& p, const FormResult& first, ReliabilityAnswer& a)
{
    if (first.outcome != FormOutcome::agreed) return;
    const auto d = static_cast<std::size_t>(p.event.dimension);
    if (const std::size_t needed = 2 * (d - 1) * (d - 1) + 1; needed > left(p, a)) {
        a.warnings.push_back("SORM was left out: it needs " + std::to_string(needed) +
                             " evaluations, and " + std::to_string(left(p, a)) +
                             " of the budget are left");
        return;
    }
    const SormResult r = sorm(p.event, first.points.front());
    take(r.ledger, a);
    const auto one = [&](const char* name, const std::optional<double>& value) {
        MethodAnswer m;
        m.method = std::string("SORM, ") + name;
        m.probability = value;
        m.outcome = value ? "curvatures by differences"
                          : (r.reason.empty()
                                 ? "not defined for these curvatures, or off by a factor of two"
                                 : r.reason);
        a.methods.push_back(m);
    };
    one("Breitung", r.breitung);
    one("Hohenbichler", r.hohenbichler);
    one("Tvedt", r.tvedt);
}

void important(const ReliabilityProblem& p, const FormResult& first, ReliabilityAnswer& a)
{
    if (first.points.empty()) {
        a.warnings.emplace_back("no design point was found: no importance sampling");
        return;
    }
    if (left(p, a) == 0) {
        a.warnings.emplace_back("the budget was used up by the search: no importance sampling");
        return;
    }
    Eigen::MatrixXd centres(static_cast<Eigen::Index>(first.points.size()), p.event.dimension);
    for (Eigen::Index i = 0; i < centres.rows(); ++i)
        centres.row(i) = first.points[i].at.u.transpose();
    ImportanceOptions o;
    o.max_samples = left(p, a);
    o.batch = std::min<std::size_t>(o.batch, o.max_samples);
    o.target_cov = p.target_cov;
    o.seed = p.seed;
    add("importance sampling", importance_sampling(p.event, centres, o).exceedance, a);
}

} // namespace uq
