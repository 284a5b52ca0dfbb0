#pragma once
/// Fragility curves from counts: of the walls (or analyses, or buildings) at one intensity, how
/// many were found in each of several ordered damage states. One state besides "none" is a
/// multiple-stripe analysis (Baker 2015, Earthquake Spectra 31, 579-599, eq. 11). All states
/// have one dispersion, so that their curves cannot cross.

#include "core/interval.hpp"
#include "fragility/limits/model_outcome.hpp"

#include <Eigen/Dense>

#include <span>
#include <string>
#include <vector>

namespace fragility {

/// Counts of walls at one intensity.
struct StateCounts {
    double intensity;          ///< [any unit], > 0
    std::vector<double> walls; ///< in each state, from none to the severest; >= 0, two or more
};

/// P(state >= k | x) = Phi(ln(x / median_k) / dispersion) (cumulative probit, McCullagh 1980,
/// J. R. Statist. Soc. B 42, 109-142).
struct OrdinalFit {
    ModelOutcome outcome = ModelOutcome::no_data;
    std::string reason;          ///< why there are no numbers
    std::vector<double> medians; ///< of state 1, 2, ..., ascending [unit of the intensity]
    double dispersion = 0.0;     ///< standard deviation of ln x [-]
    Eigen::MatrixXd covariance;  ///< of (ln medians, dispersion), from the observed information
    double log_likelihood = 0.0; ///< without multinomial coefficients
    double deviance = 0.0;       ///< against the observed shares at each intensity
    double freedom = 0.0;        ///< of the deviance: its mean if the curves are right
};

/// Maximum likelihood.
[[nodiscard]] OrdinalFit fit_ordinal(std::span<const StateCounts> data);

/// P(a chi-squared variable > deviance): how often counts that were drawn from the curves would
/// differ from them more than those that were fitted. Rough where few walls are expected in a
/// state. NaN without freedom.
[[nodiscard]] double p_value(const OrdinalFit& fit);

/// A positive number with its doubt, by the delta method on its logarithm.
struct LogEstimate {
    double value;
    double std_error; ///< of the value, same unit
    double log_error; ///< of ln value
    core::Interval interval;
};
/// @param fit converged  @param state 1, 2, ...  @param confidence in (0, 1)
[[nodiscard]] LogEstimate median(const OrdinalFit& fit, std::size_t state,
                                 double confidence = 0.95);
[[nodiscard]] LogEstimate dispersion(const OrdinalFit& fit, double confidence = 0.95);

/// P(state >= k) at an intensity, and its standard error on the probit axis (delta method).
struct StateProbability {
    double probability, probit, probit_error;
};
/// @param state 1, 2, ...  @param intensity > 0
[[nodiscard]] StateProbability probability(const OrdinalFit& fit, std::size_t state,
                                           double intensity);
/// The interval of the probability, by its standard error on the probit axis.
/// @param confidence in (0, 1)
[[nodiscard]] core::Interval band(const StateProbability& p, double confidence = 0.95);

/// The same counts with all states below `state` as "none", and all others as reached.
[[nodiscard]] std::vector<StateCounts> reaching(std::span<const StateCounts> data,
                                                std::size_t state);

} // namespace fragility
