#pragma once
/// First-order mean and standard deviation of a response, from its gradient at the mean: a look
/// before a reliability analysis, and no substitute for it.

#include "uq/reliability/black_box.hpp"

namespace uq {

struct MeanValue {
    double mean; ///< response at the means
    double sd;
    /// Shares of the variance: i, i of one variable alone; the pair i, j by correlation is the
    /// sum of (i, j) and (j, i). All add up to 1; zero if the sd is.
    Eigen::MatrixXd importance;
    std::string failure; ///< empty if sound; else the rest means nothing and is zero
};

/// Central differences of width `step` standard deviations: 2 d + 1 samples in one batch.
/// @param mean, sd of each variable, sd > 0; @param correlation symmetric, ones on the diagonal
/// @throws std::invalid_argument naming what is out of range
[[nodiscard]] MeanValue mean_value(const Model& model, Eigen::Index response,
                                   const Eigen::VectorXd& mean, const Eigen::VectorXd& sd,
                                   const Eigen::MatrixXd& correlation, double step = 1e-3);

} // namespace uq
