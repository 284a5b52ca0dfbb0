#pragma once
/// First-order reliability: P = Phi(-beta), beta the distance from the origin to the design
/// point.

#include "uq/reliability/design_point/form_search.hpp"

namespace uq {

struct FormOptions {
    SearchOptions search;
    SearchMethod check = SearchMethod::slsqp; ///< second search: slsqp or cobyla
    /// Starting points of both searches: the origin, then pairs u, -u of random direction.
    int starts = 3;            ///< >= 1
    double start_radius = 2.0; ///< of the random ones [standard deviations], > 0
    double same_point = 1e-2;  ///< nearer points are one [standard deviations], > 0
    std::uint64_t seed = 1;    ///< of the directions
    /// Searches end once this many evaluations are used up; what they found until then counts.
    std::size_t max_evaluations = std::numeric_limits<std::size_t>::max();
};

enum class FormOutcome {
    agreed,     ///< both searches found the same nearest point
    one_search, ///< only one of them converged from any start
    differ,     ///< their nearest points differ: there may be nearer ones
    none        ///< no search converged: there is no answer
};

struct FormResult {
    FormOutcome outcome = FormOutcome::none;
    std::string reason;              ///< where not agreed
    std::vector<DesignPoint> points; ///< all that were found, nearest first; empty if none
    double distance = 0.0;           ///< between the nearest of both searches, if both have one
    std::vector<Search> searches;    ///< in the order run
    Ledger ledger;
};

/// @throws std::invalid_argument naming the option that is out of range
[[nodiscard]] FormResult form(const LimitState& s, const FormOptions& o = {});

/// Phi(-beta).
[[nodiscard]] double probability(const DesignPoint& p);

/// alpha_i^2: shares of the variance of the linearised limit state, of each u; they add up to
/// 1.
[[nodiscard]] Eigen::VectorXd importance_factors(const DesignPoint& p);

/// gamma_i^2 of inputs that depend on each other, one per column of x; they add up to 1 and do
/// not change with the order of the inputs:
///   gamma = D J^-T alpha / |D J^-T alpha|,   J = dx/du at the design point,   D^2 = diag(J
///   J^T)
/// (Der Kiureghian 2005, First- and second-order reliability methods, in: Engineering Design
/// Reliability Handbook). Of independent inputs it is alpha^2. The map is differentiated; the
/// model is not asked.
/// @return nothing if every input has a coordinate of its own (then importance_factors says
/// it), or if the
/// inputs do not fix the coordinates
[[nodiscard]] std::optional<Eigen::VectorXd> dependent_importance(const DesignPoint& p,
                                                                  const Map& to_physical);

} // namespace uq
