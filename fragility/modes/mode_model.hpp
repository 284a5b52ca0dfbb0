#pragma once
/// Failure mode against covariates (vertical stress, friction, ...): multinomial logit, with
/// two modes the logistic regression.

#include "core/interval.hpp"
#include "fragility/laws/maximise.hpp"
#include "fragility/limits/model_outcome.hpp"

#include <Eigen/Dense>

#include <string>

namespace fragility {

/// One row for each wall, or for each group of walls with the same covariates.
struct ModeData {
    Eigen::MatrixXd covariates; ///< rows x covariates, without the constant; any unit
    Eigen::MatrixXd counts;     ///< rows x modes, walls [-], >= 0
};

enum class ModePenalty {
    none,
    firth ///< ln sqrt det information added: finite also where data are separated (Firth 1993,
          ///< Biometrika 80, 27-38; Heinze and Schemper 2002, Statist. Med. 21, 2409-2419)
};

/// ln(P(mode k) / P(mode 0)) = coefficients.row(k - 1) * (1, covariates).
struct ModeModel {
    ModelOutcome outcome = ModelOutcome::no_data;
    std::string reason;
    ModePenalty penalty = ModePenalty::none;
    Eigen::MatrixXd coefficients; ///< (modes - 1) x (1 + covariates)
    Eigen::MatrixXd std_errors;   ///< the same, from the information at the estimate
    Eigen::MatrixXd covariance;   ///< of the coefficients, row by row
    double log_likelihood = 0.0;  ///< without penalty and multinomial coefficients
    double deviance = 0.0;        ///< -2 log_likelihood
    double aic = 0.0;             ///< 0 with a penalty: not defined
    double n = 0.0;               ///< walls
};

[[nodiscard]] ModeModel fit_modes(const ModeData& data,
                                  ModePenalty penalty = ModePenalty::none);
/// Maximum likelihood; where data are separated or a mode is absent, Firth's penalty, with the
/// reason of the first kept.
[[nodiscard]] ModeModel fit_modes_safely(const ModeData& data);

/// One for each mode; they add up to 1.
/// @throws std::invalid_argument if there is no model or the covariates are not as many as its
[[nodiscard]] Eigen::VectorXd mode_probabilities(const ModeModel& model,
                                                 const Eigen::VectorXd& covariates);

struct ModeProbability {
    double value, std_error;
    core::Interval interval; ///< delta method on the logit: within (0, 1)
};
[[nodiscard]] ModeProbability mode_probability(const ModeModel& model, int mode,
                                               const Eigen::VectorXd& covariates,
                                               double confidence = 0.95);

/// Log-likelihood of a multinomial logit; design with the constant, coefficients row by row.
[[nodiscard]] Local mode_likelihood(const Eigen::MatrixXd& design,
                                    const Eigen::MatrixXd& counts, const Eigen::VectorXd& beta);
/// With Firth's penalty; the hessian by differences of the gradient.
[[nodiscard]] Local penalised_mode_likelihood(const Eigen::MatrixXd& design,
                                              const Eigen::MatrixXd& counts,
                                              const Eigen::VectorXd& beta);
[[nodiscard]] Eigen::MatrixXd with_constant(const Eigen::MatrixXd& covariates);

} // namespace fragility
