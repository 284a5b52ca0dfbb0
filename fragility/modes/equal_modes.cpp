#include "fragility/modes/equal_modes.hpp"

#include "core/fit_factors.hpp"
#include "core/interval.hpp"
#include "fragility/laws/standard_law.hpp"

#include <Eigen/Householder>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace fragility {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kFurthestDifference = 40.0; ///< end of the search [standard errors]

/// ln(P_b / P_a) = (u + v t) . beta at the value t of the covariate.
struct Contrast {
    VectorXd u, v;
};

Contrast contrast(const ModeModel& m, int a, int b, int which, const VectorXd& covariates)
{
    const Index p = m.coefficients.cols();
    Contrast c{VectorXd::Zero(m.covariance.rows()), VectorXd::Zero(m.covariance.rows())};
    VectorXd x(p);
    x << 1.0, covariates;
    x[which + 1] = 0.0;
    for (const auto& [mode, sign] : {std::pair{a, -1.0}, std::pair{b, 1.0}}) {
        if (mode == 0) continue;
        c.u.segment((mode - 1) * p, p) += sign * x;
        c.v[(mode - 1) * p + which + 1] += sign;
    }
    return c;
}

VectorXd stacked(const MatrixXd& coefficients)
{
    VectorXd beta(coefficients.size());
    for (Index k = 0; k < coefficients.rows(); ++k)
        beta.segment(k * coefficients.cols(), coefficients.cols()) = coefficients.row(k);
    return beta;
}

/// (u + v t)^2 <= z^2 var(u + v t), a quadratic in t (Fieller 1954).
core::Interval fieller(double u, double v, double uu, double uv, double vv, double z,
                       double confidence)
{
    const double a = v * v - z * z * vv;
    if (!(a > 0.0)) return {-core::kInfinity, core::kInfinity, confidence};
    const double b = u * v - z * z * uv;
    const double root = std::sqrt(std::max(0.0, b * b - a * (u * u - z * z * uu)));
    return {(-b - root) / a, (-b + root) / a, confidence};
}

/// Columns 2, 3, ... of the reflection I - tau (1, v) (1, v)^T, which takes `a` onto the first
/// axis.
MatrixXd orthonormal_columns_across(const VectorXd& a)
{
    const Eigen::Index n = a.size() - 1;
    VectorXd v(n);
    double tau = 0.0, length = 0.0;
    a.makeHouseholder(v, tau, length);
    MatrixXd columns = MatrixXd::Identity(n + 1, n + 1).rightCols(n);
    for (Eigen::Index j = 0; j < n; ++j) {
        columns(0, j) -= tau * v(j);
        for (Eigen::Index i = 0; i < n; ++i) columns(i + 1, j) -= tau * v(i) * v(j);
    }
    return columns;
}

/// Largest log-likelihood with the two modes equally likely at t.
class EqualAt {
  public:
    EqualAt(const ModeModel& m, const ModeData& d, Contrast c)
        : design_(with_constant(d.covariates)), counts_(d.counts), c_(std::move(c)),
          unit_(m.covariance.diagonal().cwiseSqrt()), best_(stacked(m.coefficients))
    {
    }

    /// Coefficients in units of their standard errors; the free ones span what the condition
    /// leaves.
    [[nodiscard]] double operator()(double t) const
    {
        const VectorXd held = unit_.cwiseProduct(c_.u + t * c_.v);
        const MatrixXd across = orthonormal_columns_across(held);
        const MatrixXd free = unit_.asDiagonal() * across;
        const auto f = [&](const VectorXd& alpha) {
            Local l = mode_likelihood(design_, counts_, free * alpha);
            l.gradient = free.transpose() * l.gradient;
            l.hessian = free.transpose() * l.hessian * free;
            return l;
        };
        const VectorXd start = across.transpose() * best_.cwiseQuotient(unit_);
        const Maximum m = maximise(f, start);
        return m.converged ? m.local.value : -core::kInfinity;
    }

  private:
    MatrixXd design_, counts_;
    Contrast c_;
    VectorXd unit_, best_;
};

double profile_end(const EqualAt& profile, double start, double floor, double step)
{
    double inside = start;
    double outside = start + step;
    while (profile(outside) > floor) {
        if (std::abs(outside - start) > kFurthestDifference * std::abs(step))
            return step > 0.0 ? core::kInfinity : -core::kInfinity;
        inside = outside;
        outside += 0.5 * (outside - start);
    }
    for (int i = 0; i < 60 && std::abs(outside - inside) > 1e-9 * std::abs(step); ++i) {
        const double middle = 0.5 * (inside + outside);
        (profile(middle) > floor ? inside : outside) = middle;
    }
    return 0.5 * (inside + outside);
}

void check(const ModeModel& m, int a, int b, int which, const VectorXd& covariates,
           double confidence)
{
    const int modes = static_cast<int>(m.coefficients.rows()) + 1;
    if (m.outcome != ModelOutcome::converged)
        throw std::invalid_argument("equal modes: there is no model: " + m.reason);
    if (a == b || std::min(a, b) < 0 || std::max(a, b) >= modes)
        throw std::invalid_argument("equal modes: needs two different modes of 0 to " +
                                    std::to_string(modes - 1));
    if (covariates.size() + 1 != m.coefficients.cols() || which < 0 ||
        which >= covariates.size())
        throw std::invalid_argument("equal modes: covariates are not those of the model");
    if (!(confidence > 0.0 && confidence < 1.0))
        throw std::invalid_argument("equal modes: confidence must be in (0, 1)");
}

} // namespace

EqualModes equal_modes(const ModeModel& m, const ModeData& data, int mode_a, int mode_b,
                       int which, const VectorXd& covariates, double confidence)
{
    check(m, mode_a, mode_b, which, covariates, confidence);
    const Contrast c = contrast(m, mode_a, mode_b, which, covariates);
    const VectorXd beta = stacked(m.coefficients);
    const double u = c.u.dot(beta);
    const double v = c.v.dot(beta);
    EqualModes e;
    if (v == 0.0 || !std::isfinite(u / v)) {
        e.reason = "the covariate does not move the two modes against each other";
        return e;
    }
    const double uu = c.u.dot(m.covariance * c.u);
    const double uv = c.u.dot(m.covariance * c.v);
    const double vv = c.v.dot(m.covariance * c.v);
    const double z = core::fit_normal_factor(confidence);
    e.found = true;
    e.at = -u / v;
    e.std_error = std::sqrt(uu + 2.0 * e.at * uv + e.at * e.at * vv) / std::abs(v);
    e.delta = {e.at - z * e.std_error, e.at + z * e.std_error, confidence};
    e.fieller = fieller(u, v, uu, uv, vv, z, confidence);
    e.profile = {-core::kInfinity, core::kInfinity, confidence};
    if (m.penalty == ModePenalty::none) {
        const EqualAt profile(m, data, c);
        const double floor = m.log_likelihood - 0.5 * z * z;
        e.profile.lower = profile_end(profile, e.at, floor, -z * e.std_error);
        e.profile.upper = profile_end(profile, e.at, floor, z * e.std_error);
    }
    return e;
}

} // namespace fragility
