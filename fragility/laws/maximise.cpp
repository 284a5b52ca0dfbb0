#include "fragility/laws/maximise.hpp"

#include "core/matrix_factors.hpp"

#include <algorithm>
#include <cmath>

namespace fragility {
namespace {

/// Rounding of a sum is some ten units in the last place: a gain below is none.
constexpr double kRounding = 1e-13;
/// Gain to be had [-] below which a point counts as the maximum; a Newton step then moves each
/// estimate by less than 1e-6 of its standard error.
constexpr double kSound = 1e-12;

struct NewtonStep {
    bool concave;
    Eigen::VectorXd by;
    double gain; ///< gradient * step, >= 0
};

NewtonStep newton_step(const Local& here)
{
    const Eigen::MatrixXd curvature = -here.hessian;
    const Eigen::VectorXd size = curvature.diagonal().cwiseAbs().cwiseMax(1e-300);
    for (double damping = 0.0; damping<1e12; damping = damping> 0.0 ? 10.0 * damping : 1e-3) {
        const Eigen::MatrixXd damped =
            curvature + Eigen::MatrixXd((damping * size).asDiagonal());
        const auto factor = core::cholesky(damped);
        if (factor.info() != Eigen::Success) continue;
        const Eigen::VectorXd by = factor.solve(here.gradient);
        const double gain = here.gradient.dot(by);
        if (std::isfinite(gain) && by.allFinite()) return {damping == 0.0, by, gain};
    }
    return {false, Eigen::VectorXd::Zero(here.gradient.size()), 0.0};
}

bool sound(const Local& here) { return std::isfinite(here.value) && here.hessian.allFinite(); }

} // namespace

Maximum maximise(const std::function<Local(const Eigen::VectorXd&)>& f, Eigen::VectorXd start,
                 const MaximiseOptions& options)
{
    Maximum m{
        false, 0, std::move(start), Eigen::VectorXd::Zero(0), {0.0, Eigen::VectorXd(), {}}};
    m.last_step = Eigen::VectorXd::Zero(m.at.size());
    m.local = f(m.at);
    if (!sound(m.local)) return m;
    double last_gain = HUGE_VAL;
    while (m.iterations < options.max_iterations) {
        const NewtonStep step = newton_step(m.local);
        const double worth = std::max(1.0, std::abs(m.local.value));
        m.converged = step.concave && step.gain <= kSound * worth;
        const bool at_rounding = step.gain > 0.25 * last_gain;
        if (m.converged && (step.gain <= options.tolerance * worth || at_rounding)) break;
        last_gain = step.gain;
        ++m.iterations;
        double part = 1.0;
        Local next = f(m.at + step.by);
        while (part > 1e-10 &&
               !(sound(next) && next.value >= m.local.value + 1e-4 * part * step.gain -
                                                  (m.converged ? kRounding * worth : 0.0))) {
            part *= 0.5;
            next = f(m.at + part * step.by);
        }
        if (!sound(next) || part <= 1e-10) break;
        m.last_step = part * step.by;
        m.at += m.last_step;
        m.local = std::move(next);
    }
    return m;
}

Eigen::MatrixXd inverse_information(const Eigen::MatrixXd& hessian)
{
    return core::solve(core::cholesky(-hessian),
                       Eigen::MatrixXd::Identity(hessian.rows(), hessian.cols()));
}

} // namespace fragility
