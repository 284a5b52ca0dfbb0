#include "uq/sensitivity/regression_fit.hpp"

#include "uq/sensitivity/correlation_measures.hpp"

#include <Eigen/QR>

#include <cmath>

namespace uq {

namespace {

constexpr double kSingular = 1e-9; ///< relative pivot of the QR taken for a dependent input

/// Mean 0 and mean square 1; 0 throughout where it does not vary.
Eigen::VectorXd standardised(const Eigen::VectorXd& v)
{
    if (v.maxCoeff() == v.minCoeff()) return Eigen::VectorXd::Zero(v.size());
    const Eigen::VectorXd d = v.array() - v.mean();
    return d * (std::sqrt(static_cast<double>(v.size())) / d.norm());
}

} // namespace

RegressionFit fit_standardised(const Eigen::MatrixXd& x, const Eigen::VectorXd& y,
                               RegressionScale scale)
{
    const bool ranked = scale == RegressionScale::ranks;
    RegressionFit f;
    f.x.resize(x.rows(), x.cols());
    for (Eigen::Index j = 0; j < x.cols(); ++j)
        f.x.col(j) = standardised(ranked ? ranks(x.col(j)) : Eigen::VectorXd(x.col(j)));
    f.y = standardised(ranked ? ranks(y) : y);
    const Eigen::Index d = x.cols(); // x = Q R first: all the rest is d x d
    const Eigen::HouseholderQR<Eigen::MatrixXd> tall(f.x);
    const Eigen::MatrixXd q = tall.householderQ() * Eigen::MatrixXd::Identity(x.rows(), d);
    const Eigen::MatrixXd r = tall.matrixQR().topRows(d).triangularView<Eigen::Upper>();
    Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> revealing;
    revealing.setThreshold(kSingular);
    revealing.compute(r);
    f.rank = revealing.rank();
    f.inverse = revealing.pseudoInverse() * q.transpose();
    f.beta = f.inverse * f.y;
    f.residual = f.y - f.x * f.beta;
    return f;
}

double partial_correlation(const RegressionFit& f, Eigen::Index j)
{
    const double scatter = f.residual.squaredNorm() * f.inverse.row(j).squaredNorm();
    const double length = std::sqrt(f.beta[j] * f.beta[j] + scatter);
    return length == 0.0 ? 0.0 : f.beta[j] / length;
}

} // namespace uq
