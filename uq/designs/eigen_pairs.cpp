#include "uq/designs/eigen_pairs.hpp"

#include <Eigen/Eigenvalues>

namespace uq {

EigenPairs eigen_pairs(const Eigen::MatrixXd& symmetric)
{
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(symmetric);
    return {solver.eigenvectors(), solver.eigenvalues()};
}

} // namespace uq
