#pragma once
/// True evaluations that check a process, and the probability that they make without bias.

#include "uq/reliability/active/doubtful_points.hpp"
#include "uq/reliability/limit_state/exceedance.hpp"

#include <vector>

namespace uq {

constexpr double kUnseen = 0.5; ///< wrong answers about the event that no check has met
constexpr std::size_t kLeastChecks = 16; ///< fewer do not tell their own scatter

/// The density of the checks among weighed points, and what a check is worth.
struct CheckPlan {
    Eigen::VectorXd chance;  ///< of each point, adds up to 1
    double variance = 0.0;   ///< of a check, as the process expects it
    double event_weight = 0; ///< phi / q where the event is sure
};
[[nodiscard]] CheckPlan plan_checks(const WeighedPoints& p);

/// Checks so far, and what they add up to.
struct Checks {
    std::vector<double> value;     ///< Y of each
    std::vector<double> if_passed; ///< Y if failed evaluations were passed
    std::vector<double> if_safe;   ///< Y if they were safe
    double expected = 0.0;         ///< sum of the variances that the processes expect
    double points = 0.0;           ///< sum over points of (checks x standard error of P)^2
    double with_points = 0.0;      ///< checks with the last points
    double event_weight = 0.0;     ///< sum over the checks
    std::size_t surprises = 0;
    std::size_t failed = 0;
};

/// @param rows of p, drawn by the plan @param g what they answered; NaN: failed
void note(Checks& c, const WeighedPoints& p, const CheckPlan& plan,
          const std::vector<Eigen::Index>& rows, const Eigen::VectorXd& g);

/// @param passed whether any evaluation saw the event
[[nodiscard]] Exceedance summary(const Checks& c, bool passed, const Ledger& ledger,
                                 double confidence);

/// Whether the estimate has the target; fewer than 16 checks do not tell their own scatter.
[[nodiscard]] bool reached(const Exceedance& e, double target_cov, const Checks& c);

} // namespace uq
