#pragma once
/// Dependent variables through the normal copula (Nataf 1962): correlated standard normal
/// images of the variables.

#include "uq/marginals/marginal.hpp"

#include <Eigen/Core>

#include <span>
#include <string>

namespace uq {

struct Variable {
    std::string name; ///< for messages
    Marginal marginal;
};

struct NormalCopula {
    Eigen::MatrixXd rho_z;  ///< correlation of the normal images
    Eigen::MatrixXd factor; ///< lower triangular, factor factor' = rho_z
};

/// @param pearson correlation of the variables themselves, d x d
/// @throws std::invalid_argument if `pearson` is not a correlation matrix, if a pair cannot
/// attain
/// its correlation (with the names and the range that it can attain), or if no normal copula
/// with these marginals has the correlation (with the nearest that one has)
[[nodiscard]] NormalCopula normal_copula(std::span<const Variable> variables,
                                         const Eigen::MatrixXd& pearson);

} // namespace uq
