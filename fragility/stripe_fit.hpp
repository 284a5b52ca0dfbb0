#pragma once
/// Fragility from counts: of n walls (or analyses) at one intensity, how many exceeded a limit
/// state. For users' own data: multiple stripes, tests at given drifts.

#include "fragility/model_outcome.hpp"

#include <Eigen/Dense>

#include <optional>
#include <span>
#include <string>

namespace fragility {

struct Stripe {
    double intensity; ///< drift, acceleration, ... [any unit], > 0
    double exceeded;  ///< of n [-], 0 .. n
    double n;         ///< with a result [-], > 0
};

enum class Link {
    probit, ///< lognormal curve: P = Phi(ln(x / median) / dispersion)
    logit   ///< P = 1 / (1 + exp(-ln(x / median) / dispersion))
};

/// P = F(b0 + b1 ln x), F of the link; median = exp(-b0 / b1), dispersion = 1 / b1.
struct StripeFit {
    ModelOutcome outcome = ModelOutcome::no_data;
    std::string reason;
    Link link = Link::probit;
    double median = 0.0;     ///< [unit of the intensity]
    double dispersion = 0.0; ///< [-]
    double b0 = 0.0, b1 = 0.0;
    Eigen::Matrix2d expected =
        Eigen::Matrix2d::Zero(); ///< covariance of (ln median, dispersion)
    Eigen::Matrix2d observed = Eigen::Matrix2d::Zero(); ///< the same from observed information
    double log_likelihood = 0.0;                        ///< with binomial coefficients
    double deviance = 0.0;                              ///< against a share for each intensity
};

/// Maximum likelihood (Baker 2015, Earthquake Spectra 31, 579-599, eq. 11).
[[nodiscard]] StripeFit fit_stripes(std::span<const Stripe> data, Link link = Link::probit);

/// Least squares of the shares (Baker 2015, eq. 12): for comparison only, it gives stripes of
/// different certainty the same weight.
struct LeastSquaresCurve {
    double median, dispersion, sum_of_squares;
};
[[nodiscard]] std::optional<LeastSquaresCurve> fit_least_squares(std::span<const Stripe> data,
                                                                 Link link = Link::probit);

} // namespace fragility
