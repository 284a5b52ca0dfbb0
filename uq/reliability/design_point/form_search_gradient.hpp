#pragma once
/// Value and gradient of a limit state from one batch of evaluations.

#include "uq/reliability/limit_state/limit_state.hpp"

#include <optional>

namespace uq {

struct LinearLimit {
    Eigen::VectorXd u;        ///< point of linearisation
    double g;                 ///< value [unit of the response]
    Eigen::VectorXd gradient; ///< dg/du
};

/// Evaluates g at `u` and at u +/- step along each axis, 2 d + 1 evaluations in one batch. The
/// error of the gradient is step^2 / 6 times the third derivative plus the roughness of g over
/// step. Nothing is returned if an evaluation failed.
[[nodiscard]] std::optional<LinearLimit>
linearise(const LimitState& s, const Eigen::VectorXd& u, double step, Ledger& ledger);

/// Distance from `l.u` to the plane of the linearised limit state, in standard deviations,
/// positive where l.u is safe. Needs a gradient that is not zero.
[[nodiscard]] double distance_to_plane(const LinearLimit& l);

/// Unit vector towards g < 0.
[[nodiscard]] Eigen::VectorXd direction(const LinearLimit& l);

/// |u - (alpha u) alpha|: how far u is from the line through the origin along its own gradient.
[[nodiscard]] double off_axis(const LinearLimit& l);

} // namespace uq
