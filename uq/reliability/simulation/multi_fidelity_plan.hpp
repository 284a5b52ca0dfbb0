#pragma once
/// How to split effort between an expensive model and cheap ones (Peherstorfer, Willcox,
/// Gunzburger 2016, section 3).

#include <cstddef>
#include <span>
#include <vector>

namespace uq {

struct CheapQuality {
    double cost;        ///< of a sample [any unit, the same for all], > 0
    double correlation; ///< with the expensive model, [-1, 1]
};

struct EffortPlan {
    bool pays = false;            ///< else the expensive model alone is better
    std::vector<std::size_t> use; ///< cheap models, best correlated first; empty if none pays
    std::vector<std::size_t>
        samples; ///< of the expensive model, then of each of `use`; never falling
    double variance_ratio = 1.0; ///< predicted variance over that of the expensive model alone
};

/// A smaller gain than this is not worth the estimated coefficients and is none: our choice.
constexpr double kWorthwhileRatio = 0.9;

/// The set of cheap models of least predicted variance
///   (sum_i sqrt(w_i (rho_i^2 - rho_(i+1)^2)))^2 / w_0,  rho_0 = 1, rho_(k+1) = 0,
/// with samples n_i / n_0 = sqrt(w_0 (rho_i^2 - rho_(i+1)^2) / (w_i (1 - rho_1^2))).
/// @param budget [unit of cost], >= least_expensive * expensive_cost
/// @param least_expensive samples of the expensive model that there will be in any case, >= 1
/// @throws std::invalid_argument naming what is out of range; more than 16 cheap models
[[nodiscard]] EffortPlan plan_effort(double expensive_cost, std::span<const CheapQuality> cheap,
                                     double budget, std::size_t least_expensive = 1);

} // namespace uq
