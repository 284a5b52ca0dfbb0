#pragma once
/// The random variables of a study: marginals, how they depend on each other, and their samples
/// in physical units.

#include "uq/designs/design.hpp"
#include "uq/marginals/marginal.hpp"

#include <Eigen/Core>

#include <string>
#include <vector>

namespace uq {

struct Variable {
    std::string name;
    Marginal marginal;
};

/// Both correlations are of the normal copula: of the variables themselves (Nataf), or of ranks.
enum class DependenceKind { independent, pearson, spearman };

struct Dependence {
    DependenceKind kind = DependenceKind::independent;
    Eigen::MatrixXd correlation; ///< d x d; empty where independent
};

struct Inputs {
    std::vector<Variable> variables; ///< one at least
    Dependence dependence;
};

/// Inputs made ready: normal images of the variables and their correlation.
struct JointDistribution {
    std::vector<Marginal> marginals;
    Eigen::MatrixXd rho_z;  ///< correlation of the normal images
    Eigen::MatrixXd factor; ///< lower, factor factor' = rho_z
    bool independent = true;
};

/// @throws std::invalid_argument naming the variable and what is wrong with its marginal, or the
/// correlation: not attainable by a pair (with the range that is), or no correlation matrix (with
/// the nearest that is)
[[nodiscard]] JointDistribution joint_distribution(const Inputs& inputs);

/// From independent standard normal variables:
///   x_i = F_i^-1(Phi((factor z)_i))
[[nodiscard]] Eigen::VectorXd from_standard_normal(const JointDistribution& joint,
                                                   const Eigen::VectorXd& z);

/// The design (d = number of variables) in physical units, n x d.
///
/// Independent: each column by its quantiles. Dependent: rows of monte_carlo and sobol go through
/// from_standard_normal, each alone. A Latin hypercube is reordered (Iman-Conover, target rho_z) so
/// that it stays Latin; rows of a size among themselves, so that those of smaller sizes stay.
/// Reordering moves the rows of optimised ones closer again.
/// @throws std::invalid_argument from the design; where d differs; where a size adds no more rows
/// than there are variables to a dependent Latin hypercube
[[nodiscard]] Eigen::MatrixXd sample(const JointDistribution& joint, const Design& design);
/// Rows first .. last - 1 of it, the same bits.
[[nodiscard]] Eigen::MatrixXd sample(const JointDistribution& joint, const Design& design,
                                     std::int64_t first, std::int64_t last);

} // namespace uq
