#pragma once
/// Fragility curves of ordered damage states from counts, with one dispersion for all: the
/// curves cannot cross.

#include "fragility/model_outcome.hpp"

#include <Eigen/Dense>

#include <span>
#include <string>
#include <vector>

namespace fragility {

/// Walls found in each state, mildest first, at one intensity.
struct StateCounts {
    double intensity;          ///< [any unit], > 0
    std::vector<double> walls; ///< one for each state, >= 0
};

/// P(state >= k | x) = Phi(ln(x / median_k) / dispersion) (cumulative probit, McCullagh 1980,
/// J. R. Statist. Soc. B 42, 109-142).
struct OrdinalFit {
    ModelOutcome outcome = ModelOutcome::no_data;
    std::string reason;
    std::vector<double> medians; ///< of state 1, 2, ..., ascending [unit of the intensity]
    double dispersion = 0.0;     ///< [-]
    Eigen::MatrixXd covariance;  ///< of (ln medians, dispersion)
    double log_likelihood = 0.0; ///< without multinomial coefficients
    double deviance = 0.0;       ///< -2 log_likelihood
};

[[nodiscard]] OrdinalFit fit_ordinal(std::span<const StateCounts> data);

} // namespace fragility
