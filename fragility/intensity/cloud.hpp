#pragma once
/// Fragility from a cloud: responses of walls to records as they are, each of its own
/// intensity. ln D = intercept + slope ln x + sigma z; collapses are told apart, or lie above a
/// bound.

#include "fragility/fits/observation.hpp"
#include "fragility/limits/model_outcome.hpp"

#include <Eigen/Dense>

#include <span>
#include <string>
#include <vector>

namespace fragility {

/// One analysis.
struct CloudPoint {
    double intensity; ///< x [any unit], > 0
    Observation
        response; ///< D [any unit], > 0: observed, above or below a bound; its weight counts
    bool collapsed = false;
};

/// Median of D at x: exp(intercept) x^slope; sigma is the standard deviation of ln D.
struct CloudFit {
    ModelOutcome outcome = ModelOutcome::no_data;
    std::string reason; ///< why there are no numbers
    double intercept = 0.0, slope = 0.0, sigma = 0.0;
    double log_likelihood = 0.0; ///< of densities of ln D
    Eigen::Matrix3d covariance;  ///< of (intercept, slope, ln sigma)
    double n = 0.0;              ///< sum of weights
};

/// Maximum likelihood with responses above or below a bound (Tobin 1958), points with
/// `collapsed` too if their response is a bound. The likelihood is concave in (a, b, 1) /
/// sigma. Without bounds and with `unbiased`, sigma^2 is the sum of squares over n - 2 in place
/// of n (Jalayer & Cornell).
[[nodiscard]] CloudFit fit_cloud(std::span<const CloudPoint> points, bool unbiased = false);

enum class Link { logistic, probit };

/// P(collapse | x) = F(constant + slope ln x), F logistic or normal.
struct CollapseFit {
    ModelOutcome outcome = ModelOutcome::no_data;
    std::string reason;
    Link link = Link::logistic;
    double constant = 0.0, slope = 0.0;
    double log_likelihood = 0.0;
};
[[nodiscard]] CollapseFit fit_collapse(std::span<const CloudPoint> points, Link link);
[[nodiscard]] double collapse_probability(const CollapseFit& fit, double intensity);

/// P(D > threshold | x) of the cloud alone.
[[nodiscard]] double exceedance(const CloudFit& fit, double threshold, double intensity);

/// With collapse: P(D > threshold | stands) (1 - P_c) + P_c (Jalayer et al. 2017, Earthquake
/// Engng Struct. Dyn. 46).
[[nodiscard]] double exceedance(const CloudFit& standing, const CollapseFit& collapse,
                                double threshold, double intensity);

/// A lognormal fragility curve.
struct IntensityCurve {
    double median;     ///< [unit of x]
    double dispersion; ///< standard deviation of ln x [-]
};

/// Share of the walls that have reached the state at intensity x [-]. @param x >= 0
[[nodiscard]] double share_reached(const IntensityCurve& curve, double x);

/// Curve of a cloud with a slope above 0: median (threshold / e^intercept)^(1 / slope),
/// dispersion sigma / slope.
[[nodiscard]] IntensityCurve cloud_curve(const CloudFit& fit, double threshold);

} // namespace fragility
