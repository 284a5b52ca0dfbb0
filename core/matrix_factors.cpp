#include "core/matrix_factors.hpp"

#include <Eigen/QR>

namespace core {

using Eigen::MatrixXd;

Eigen::LLT<MatrixXd> cholesky(const MatrixXd& m) { return Eigen::LLT<MatrixXd>(m); }

MatrixXd solve(const Eigen::LLT<MatrixXd>& factor, const MatrixXd& b)
{
    return factor.solve(b);
}

LeastSquares least_squares(const MatrixXd& x, const Eigen::VectorXd& y)
{
    const Eigen::ColPivHouseholderQR<MatrixXd> qr(x);
    return {qr.solve(y), qr.rank()};
}

Eigen::VectorXd leverages(const MatrixXd& x)
{
    const Eigen::ColPivHouseholderQR<MatrixXd> qr(x);
    const MatrixXd q = qr.householderQ() * MatrixXd::Identity(x.rows(), qr.rank());
    return q.rowwise().squaredNorm();
}

Eigen::Index rank(const MatrixXd& m) { return Eigen::ColPivHouseholderQR<MatrixXd>(m).rank(); }

} // namespace core
