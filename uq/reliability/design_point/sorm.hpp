#pragma once
/// Second-order reliability: the limit state as the paraboloid u_n = beta + sum kappa_i v_i^2 /
/// 2 that touches it at the design point, v across the axis of the design point.

#include "uq/reliability/design_point/form.hpp"

namespace uq {

enum class SormOutcome {
    found,
    evaluation_failed, ///< a point of the differences gave no answer
    not_a_minimum      ///< beta kappa_i <= -1: a point nearer to the origin exists
};

struct SormResult {
    SormOutcome outcome = SormOutcome::evaluation_failed;
    std::string reason; ///< where not found
    Eigen::VectorXd
        curvatures; ///< kappa_i, d - 1, ascending; positive: the passed side is smaller
    /// Probabilities, only where found. Breitung (1984): asymptotic; Hohenbichler and Rackwitz
    /// (1988): not where 1 + psi(beta) kappa_i <= 0; the paraboloid itself (Tvedt 1990), to
    /// rounding. The first two are left out where they miss the third by a factor of two.
    std::optional<double> breitung, hohenbichler, tvedt;
    Ledger ledger;
};

/// Curvatures by central differences of width `step` in the tangent plane: 2 (d - 1)^2 + 1
/// evaluations in one batch.
/// @param step (0, 1]; where g is rough as wide as the roughness asks for, else
/// std::invalid_argument
[[nodiscard]] SormResult sorm(const LimitState& s, const DesignPoint& p, double step = 1e-2);

/// beta >= 0 and 1 + beta kappa_i > 0, else std::invalid_argument.
[[nodiscard]] double breitung(double beta, const Eigen::VectorXd& curvatures);
/// As above; nothing if 1 + psi kappa_i <= 0 for some i, psi = phi(beta) / Phi(-beta).
[[nodiscard]] std::optional<double> hohenbichler(double beta,
                                                 const Eigen::VectorXd& curvatures);

/// P(U > beta + sum kappa_i V_i^2 / 2) of independent standard normal U, V_i. Tvedt's double
/// integral, written as the inverse Laplace transform
///   P = 1 / (2 pi i) int exp(s^2 / 2 - s beta) prod (1 + s kappa_i)^(-1/2) ds / s
/// along the vertical line through its saddle point. Any finite beta and kappa_i; relative
/// error about 1e-13 for either tail as long as P is not below 1e-300.
[[nodiscard]] double paraboloid_probability(double beta, const Eigen::VectorXd& curvatures);

} // namespace uq
