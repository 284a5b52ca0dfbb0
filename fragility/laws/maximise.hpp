#pragma once
/// Largest value of a smooth function: Newton's method with step halving, damped where the
/// function is not concave.

#include <Eigen/Dense>

#include <functional>

namespace fragility {

/// A log-likelihood and its derivatives at one point. Value -infinity: the point is not
/// allowed.
struct Local {
    double value;
    Eigen::VectorXd gradient;
    Eigen::MatrixXd hessian;
};

struct MaximiseOptions {
    int max_iterations = 200;
    /// On the gain still to be had, against max(1, |value|) [-]; where rounding stops the
    /// search before, that is the end too.
    double tolerance = 1e-26;
};

struct Maximum {
    bool converged = false; ///< the gain to be had is below rounding and the point is a maximum
    int iterations = 0;
    Eigen::VectorXd at;
    Eigen::VectorXd last_step; ///< of the last iteration: the way it runs if it runs away
    Local local;
};

/// From `start`, which must be allowed.
[[nodiscard]] Maximum maximise(const std::function<Local(const Eigen::VectorXd&)>& f,
                               Eigen::VectorXd start, const MaximiseOptions& options = {});

/// Covariance of the estimates at a maximum: the inverse of the information, which is the
/// negative hessian.
/// @param hessian negative definite
[[nodiscard]] Eigen::MatrixXd inverse_information(const Eigen::MatrixXd& hessian);

} // namespace fragility
