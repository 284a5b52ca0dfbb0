#include "uq/reliability/design_point/sorm.hpp"

#include "core/eigen_pairs.hpp"

#include <Eigen/Householder>
#include <gsl/gsl_cdf.h>
#include <gsl/gsl_sf_erf.h>

#include <cmath>
#include <limits>
#include <sstream>
#include <stdexcept>

namespace uq {

namespace {

/// Orthonormal columns across `alpha`.
Eigen::MatrixXd tangent_plane(const Eigen::VectorXd& alpha)
{
    const Eigen::Index d = alpha.size();
    Eigen::VectorXd v(d - 1); // the reflection onto the first axis is I - tau (1, v) (1, v)^T
    double tau = 0.0, length = 0.0;
    alpha.makeHouseholder(v, tau, length);
    Eigen::MatrixXd t = Eigen::MatrixXd::Identity(d, d).rightCols(d - 1);
    for (Eigen::Index j = 0; j + 1 < d; ++j) {
        t(0, j) -= tau * v(j);
        for (Eigen::Index i = 0; i + 1 < d; ++i) t(i + 1, j) -= tau * v(i) * v(j);
    }
    return t;
}

/// Points of the differences: the centre; then for each i +e_i, -e_i; then for each i < j
/// ++, +-, -+, --.
Eigen::MatrixXd stencil(const Eigen::VectorXd& u, const Eigen::MatrixXd& t, double h)
{
    const Eigen::Index n = t.cols();
    Eigen::MatrixXd points = u.transpose().replicate(2 * n * n + 1, 1);
    Eigen::Index row = 1;
    for (Eigen::Index i = 0; i < n; ++i)
        for (const double a : {h, -h}) points.row(row++) += a * t.col(i).transpose();
    for (Eigen::Index i = 0; i < n; ++i)
        for (Eigen::Index j = i + 1; j < n; ++j)
            for (const double a : {h, -h})
                for (const double b : {h, -h})
                    points.row(row++) += (a * t.col(i) + b * t.col(j)).transpose();
    return points;
}

Eigen::MatrixXd hessian(const Eigen::VectorXd& g, Eigen::Index n, double h)
{
    Eigen::MatrixXd second(n, n);
    for (Eigen::Index i = 0; i < n; ++i)
        second(i, i) = (g(1 + 2 * i) - 2.0 * g(0) + g(2 + 2 * i)) / (h * h);
    Eigen::Index row = 1 + 2 * n;
    for (Eigen::Index i = 0; i < n; ++i)
        for (Eigen::Index j = i + 1; j < n; ++j, row += 4)
            second(i, j) = second(j, i) =
                (g(row) - g(row + 1) - g(row + 2) + g(row + 3)) / (4.0 * h * h);
    return second;
}

/// prod (1 + factor kappa_i)^(-1/2); nothing if a factor is not positive.
std::optional<double> correction(double factor, const Eigen::VectorXd& curvatures)
{
    const Eigen::ArrayXd terms = 1.0 + factor * curvatures.array();
    if (!(terms > 0.0).all()) return std::nullopt;
    return std::exp(-0.5 * terms.log().sum());
}

/// A formula is dropped where it misses the integral that it approximates by a factor of two:
/// beside a circle about the origin Breitung's grows without limit.
bool is_near(double formula, double integral)
{
    return formula < 2.0 * integral && integral < 2.0 * formula;
}

} // namespace

double breitung(double beta, const Eigen::VectorXd& curvatures)
{
    const std::optional<double> c = correction(beta, curvatures);
    if (!(beta >= 0.0) || !c)
        throw std::invalid_argument("breitung: beta must be >= 0 and 1 + beta kappa positive");
    return gsl_cdf_ugaussian_Q(beta) * *c;
}

std::optional<double> hohenbichler(double beta, const Eigen::VectorXd& curvatures)
{
    const std::optional<double> c = correction(gsl_sf_hazard(beta), curvatures);
    if (!c) return std::nullopt;
    return gsl_cdf_ugaussian_Q(beta) * *c;
}

SormResult sorm(const LimitState& s, const DesignPoint& p, double step)
{
    check(s);
    if (!(step > 0.0 && step <= 1.0))
        throw std::invalid_argument("sorm: step must be in (0, 1]");
    SormResult r;
    const Eigen::MatrixXd t = tangent_plane(p.alpha);
    const Eigen::VectorXd g = limit_values(s, stencil(p.at.u, t, step), r.ledger);
    if (g.hasNaN()) {
        r.reason = "the model failed at " + std::to_string(r.ledger.failed.size()) +
                   " points needed for the curvatures";
        return r;
    }
    // With the origin on the passed side (beta < 0) P = 1 - P(other side), of curvature -kappa.
    const double side = p.beta < 0.0 ? -1.0 : 1.0, beta = std::abs(p.beta);
    const Eigen::MatrixXd scaled = hessian(g, t.cols(), step) / p.at.gradient.norm();
    r.curvatures = core::eigen_pairs(scaled).values;
    const Eigen::VectorXd kappa = side * r.curvatures;
    if (!correction(beta, kappa)) {
        std::ostringstream why;
        why << "curvature " << r.curvatures.transpose() << " at beta " << p.beta
            << ": a point nearer to the origin exists";
        r.outcome = SormOutcome::not_a_minimum;
        r.reason = why.str();
        return r;
    }
    const auto own_side = [&](double q) { return side > 0.0 ? q : 1.0 - q; };
    r.outcome = SormOutcome::found;
    const double whole = paraboloid_probability(beta, kappa);
    r.tvedt = own_side(whole);
    if (const double q = breitung(beta, kappa); is_near(q, whole)) r.breitung = own_side(q);
    if (const auto q = hohenbichler(beta, kappa); q && is_near(*q, whole))
        r.hohenbichler = own_side(*q);
    return r;
}

} // namespace uq
