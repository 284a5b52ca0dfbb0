#pragma once
/// Test of a model of the failure mode against the observed shares that it was fitted to.

#include "fragility/modes/mode_model.hpp"

namespace fragility {

struct LackOfFit {
    double deviance = 0.0; ///< 2 (ln likelihood of the shares themselves - of the model), >= 0
    Eigen::Index degrees = 0; ///< of freedom: free shares less coefficients; 0: nothing to test
    double p_value = 1.0; ///< chi-squared; good where groups expect some five walls of a mode
};

/// Residual deviance (McCullagh and Nelder 1989, Generalized Linear Models, 4.4.3). Rows of
/// `data` are groups of walls with the same covariates; rows without walls do not count.
/// @throws std::invalid_argument if there is no model or it is of other covariates or modes
[[nodiscard]] LackOfFit lack_of_fit(const ModeModel& model, const ModeData& data);

} // namespace fragility
