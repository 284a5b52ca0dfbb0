#pragma once
/// One lognormal law for all stress levels: ln median and ln dispersion are polynomials of the
/// vertical stress, so that a stress between the levels can be asked.

#include "core/interval.hpp"
#include "fragility/fits/censored_fit.hpp"
#include "fragility/fits/observation.hpp"

#include <Eigen/Dense>

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace fragility {

struct StressedObservation {
    double stress; ///< [any unit], finite
    Observation limit;
};

/// ln median = sum a_j t^j, ln dispersion = sum b_j t^j, t = (stress - centre) / scale.
struct StressModel {
    FitOutcome outcome = FitOutcome::no_data;
    std::string reason;
    Eigen::VectorXd median_terms;                 ///< a_0, a_1, ...
    Eigen::VectorXd dispersion_terms;             ///< b_0, b_1, ...
    Eigen::MatrixXd covariance;                   ///< of (a, b), inverse observed information
    double centre = 0.0, scale = 1.0;             ///< [unit of the stress]
    double least_stress = 0.0, most_stress = 0.0; ///< outside: extrapolated
    Counts counts;
    double log_likelihood = 0.0; ///< of densities of x
    double aic = 0.0;
};

/// Degrees of the polynomials, 0 to 3 each.
struct StressOrder {
    int median = 1;
    int dispersion = 0;
};

/// Censored maximum likelihood. At least one more stress level than the higher degree.
/// @throws std::invalid_argument for degrees out of range
[[nodiscard]] StressModel fit_stress_model(std::span<const StressedObservation> data,
                                           StressOrder order);
/// The model of least AIC among degrees 0 to 2 of the median and 0 to 2 of the dispersion.
[[nodiscard]] StressModel fit_stress_model(std::span<const StressedObservation> data);

/// The law that the model gives at one stress.
struct AtStress {
    Distribution law;           ///< lognormal
    Eigen::Matrix2d covariance; ///< of (ln median, ln dispersion)
    bool extrapolated;          ///< the stress is outside the data
};
/// @throws std::invalid_argument if there is no model
[[nodiscard]] AtStress at_stress(const StressModel& model, double stress);

/// Median with its confidence interval, and the prediction interval that holds a further wall
/// with that probability: beta^2 + se^2 in place of beta^2.
struct StressPrediction {
    double median;
    core::Interval confidence, prediction;
};
[[nodiscard]] StressPrediction predict(const StressModel& model, double stress,
                                       double confidence = 0.95);

} // namespace fragility
