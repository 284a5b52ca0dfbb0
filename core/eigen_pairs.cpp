#include "core/eigen_pairs.hpp"

namespace core {

using Eigen::MatrixXd;

EigenPairs eigen_pairs(const MatrixXd& k)
{
    const Eigen::SelfAdjointEigenSolver<MatrixXd> solver(k);
    return {solver.eigenvectors(), solver.eigenvalues()};
}

EigenPairs eigen_pairs(const MatrixXd& k, const MatrixXd& c)
{
    const Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd> solver(k, c);
    return {solver.eigenvectors(), solver.eigenvalues()};
}

} // namespace core
