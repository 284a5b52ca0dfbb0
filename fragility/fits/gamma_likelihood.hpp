#pragma once
/// Log-likelihood of censored data under a gamma law.

#include "fragility/fits/censored_sample.hpp"

namespace fragility {

/// ln of the integral of exp(a s - e^s) from lo to hi and moments under that density. With
/// s = ln(x / scale) this is ln(Gamma(a) P(lo < ln x / scale < hi)); its derivatives for a and
/// for a shift of both ends are these moments, so that no derivative of an incomplete gamma
/// function for its shape is needed.
struct LogGammaMoments {
    double log_integral;
    double mean, variance;         ///< of s: first and second derivative for a
    double mean_exp, variance_exp; ///< of e^s
    double covariance;             ///< of s and e^s
};
/// @param a  > 0; @param lo, hi  lo < hi, may be infinite
[[nodiscard]] LogGammaMoments log_gamma_moments(double a, double lo, double hi);

/// Log-likelihood of one observation, censored or not, for (ln mean, ln cv); density of ln x.
/// @param lo, hi  ends of ln x; equal: observed; -infinity, infinity: open
[[nodiscard]] Likelihood gamma_term(const Working& theta, double lo, double hi);

} // namespace fragility
