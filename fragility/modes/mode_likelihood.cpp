#include "fragility/modes/mode_model.hpp"

#include "core/matrix_factors.hpp"

#include <cmath>
#include <limits>

namespace fragility {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Step of the differences behind the hessian of the penalty, in coefficients of covariates
/// between 0 and 1.
constexpr double kDifference = 1e-4;

/// Probabilities of the modes of one row; ln of their common denominator.
struct RowModes {
    VectorXd p;
    double log_sum;
};

RowModes row_modes(const VectorXd& eta)
{
    const double top = std::max(0.0, eta.maxCoeff());
    const VectorXd e = (eta.array() - top).exp();
    const double sum = e.sum() + std::exp(-top);
    return {e / sum, top + std::log(sum)};
}

VectorXd predictors(const MatrixXd& design, const VectorXd& beta, Index row, Index others)
{
    const Index p = design.cols();
    VectorXd eta(others);
    for (Index k = 0; k < others; ++k) eta[k] = design.row(row).dot(beta.segment(k * p, p));
    return eta;
}

/// Derivative of ln sqrt det information, sum over rows of
///   n x_m dW_ab / d eta_c  x' V_ba x / 2,   dW_ab / d eta_c = third cumulant of the counts.
VectorXd penalty_gradient(const MatrixXd& design, const MatrixXd& counts, const VectorXd& beta,
                          const MatrixXd& inverse)
{
    const Index p = design.cols();
    const Index others = counts.cols() - 1;
    VectorXd gradient = VectorXd::Zero(beta.size());
    for (Index i = 0; i < design.rows(); ++i) {
        const VectorXd x = design.row(i);
        const VectorXd q = row_modes(predictors(design, beta, i, others)).p;
        MatrixXd spread(others, others);
        for (Index a = 0; a < others; ++a)
            for (Index b = 0; b < others; ++b)
                spread(a, b) = x.dot(inverse.block(a * p, b * p, p, p) * x);
        for (Index c = 0; c < others; ++c) {
            double sum = 0.0;
            for (Index a = 0; a < others; ++a)
                for (Index b = 0; b < others; ++b) {
                    const double diagonal = a == b ? q[a] * ((a == c) - q[c]) : 0.0;
                    sum += spread(a, b) *
                           (diagonal - q[a] * q[b] * ((a == c) + (b == c) - 2.0 * q[c]));
                }
            gradient.segment(c * p, p) += 0.5 * counts.row(i).sum() * sum * x;
        }
    }
    return gradient;
}

/// Value and gradient with the penalty; the hessian is without.
Local penalised_slope(const MatrixXd& design, const MatrixXd& counts, const VectorXd& beta)
{
    Local l = mode_likelihood(design, counts, beta);
    const MatrixXd information = -l.hessian;
    const auto factor = core::cholesky(information);
    if (factor.info() != Eigen::Success || !(factor.rcond() > 1e-15)) {
        l.value = -std::numeric_limits<double>::infinity();
        return l;
    }
    l.value += factor.matrixLLT().diagonal().array().log().sum(); // ln sqrt det
    const MatrixXd inverse = core::solve(factor, MatrixXd::Identity(beta.size(), beta.size()));
    l.gradient += penalty_gradient(design, counts, beta, inverse);
    return l;
}

} // namespace

MatrixXd with_constant(const MatrixXd& covariates)
{
    MatrixXd design(covariates.rows(), covariates.cols() + 1);
    design.col(0).setOnes();
    design.rightCols(covariates.cols()) = covariates;
    return design;
}

Local mode_likelihood(const MatrixXd& design, const MatrixXd& counts, const VectorXd& beta)
{
    const Index p = design.cols();
    const Index others = counts.cols() - 1;
    Local l{0.0, VectorXd::Zero(beta.size()), MatrixXd::Zero(beta.size(), beta.size())};
    for (Index i = 0; i < design.rows(); ++i) {
        const double n = counts.row(i).sum();
        const VectorXd eta = predictors(design, beta, i, others);
        const RowModes modes = row_modes(eta);
        const VectorXd x = design.row(i);
        l.value -= n * modes.log_sum;
        for (Index a = 0; a < others; ++a) {
            l.value += counts(i, a + 1) * eta[a];
            l.gradient.segment(a * p, p) += (counts(i, a + 1) - n * modes.p[a]) * x;
            for (Index b = 0; b < others; ++b) {
                const double w = n * modes.p[a] * ((a == b) - modes.p[b]);
                l.hessian.block(a * p, b * p, p, p) -= w * x * x.transpose();
            }
        }
    }
    return l;
}

Local penalised_mode_likelihood(const MatrixXd& design, const MatrixXd& counts,
                                const VectorXd& beta)
{
    Local l = penalised_slope(design, counts, beta);
    if (!std::isfinite(l.value)) return l;
    for (Index k = 0; k < beta.size(); ++k) {
        VectorXd moved = beta;
        moved[k] += kDifference;
        const VectorXd up = penalised_slope(design, counts, moved).gradient;
        moved[k] -= 2.0 * kDifference;
        const VectorXd down = penalised_slope(design, counts, moved).gradient;
        l.hessian.col(k) = (up - down) / (2.0 * kDifference);
    }
    l.hessian = (0.5 * (l.hessian + l.hessian.transpose())).eval();
    return l;
}

} // namespace fragility
