#pragma once
/// Maximum likelihood for values that are observed, or known to lie above, below or between
/// limits.

#include "fragility/fits/censored_sample.hpp"
#include "fragility/fits/observation.hpp"
#include "fragility/laws/law.hpp"

#include <Eigen/Dense>

#include <optional>
#include <span>
#include <string>

namespace fragility {

enum class FitOutcome {
    converged,
    no_data,
    invalid_value, ///< NaN, ends in the wrong order, no information, weight not positive
    not_positive,  ///< a value at or below zero under a law of positive values
    too_few,       ///< fewer observations than a law of two parameters needs
    capped,    ///< limits that are drift limits of a code or of the user: no law describes them
    no_spread, ///< one and the same value agrees with all observations
    all_censored,  ///< nothing but lower (or nothing but upper) limits
    no_finite_fit, ///< the likelihood grows towards a dispersion without bound
    not_converged
};

/// Two parameters need three walls, two of them not merely lower limits.
constexpr double kFewestWalls = 3.0;
constexpr double kFewestInformative = 2.0;

/// The reason why a law cannot be fitted to observations.
struct Refusal {
    FitOutcome outcome;
    std::string reason; ///< with numbers: "all 12 censored: ..."
};
[[nodiscard]] std::optional<Refusal> screen(Law law, std::span<const Observation> data);

/// A fitted law. Unless the outcome is `converged`, only outcome, reason and counts mean
/// anything.
struct Fit {
    FitOutcome outcome = FitOutcome::no_data;
    std::string reason; ///< empty if converged
    Counts counts;
    Distribution law;
    /// Inverse observed information of (location, ln dispersion).
    Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();
    double location_error = 0.0;   ///< standard error of the location
    double dispersion_error = 0.0; ///< standard error of the dispersion
    double log_likelihood = 0.0;   ///< of densities of x
    double aic = 0.0;              ///< 2 k - 2 ln L, k = 2
    double bic = 0.0;              ///< k ln n - 2 ln L
    int iterations = 0;
};

[[nodiscard]] Fit fit(Law law, std::span<const Observation> data);
/// Fits a prepared sample, which must have passed screen(). `start` saves iterations.
[[nodiscard]] Fit fit(const CensoredSample& sample, const Distribution* start = nullptr);

} // namespace fragility
