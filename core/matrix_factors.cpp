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

Eigen::Index rank(const MatrixXd& m) { return Eigen::ColPivHouseholderQR<MatrixXd>(m).rank(); }

} // namespace core
