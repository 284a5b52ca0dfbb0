#pragma once
/// Intervals for what a fit says: parameters, median, quantiles.

#include "core/interval.hpp"
#include "fragility/fits/censored_fit.hpp"

#include <span>
#include <vector>

namespace fragility {

/// The quantity that is estimated.
struct Quantity {
    enum class Kind { location, dispersion, quantile } kind = Kind::quantile;
    double p = 0.5; ///< of the quantile [-], in (0, 1)
};
[[nodiscard]] constexpr Quantity location() { return {Quantity::Kind::location, 0.5}; }
[[nodiscard]] constexpr Quantity dispersion() { return {Quantity::Kind::dispersion, 0.5}; }
[[nodiscard]] constexpr Quantity quantile_of(double p) { return {Quantity::Kind::quantile, p}; }
[[nodiscard]] constexpr Quantity median() { return quantile_of(0.5); }

[[nodiscard]] double value(const Distribution& d, Quantity q);

/// Estimate, its standard error on the axis where it is closest to normal (ln of dispersions
/// and of quantiles of positive laws, else itself), by the delta method.
struct Uncertain {
    double value;
    double axis_error; ///< standard error of ln value, or of the value
    bool logarithmic;
};
/// @throws std::invalid_argument if the fit has not converged
[[nodiscard]] Uncertain uncertain(const Fit& fit, Quantity q);

/// The interval of the profile likelihood, which covers 93 to 97 % at n = 50 with up to 60 %
/// censored: docs/bench/fragility/interval_coverage.md. It ends where 2 (ln L_max - ln
/// L_profile) is the quantile of chi^2 with one degree of freedom. An end further than 40
/// standard errors away is 0 or infinite.
/// @param data that of the fit
/// @throws std::invalid_argument if the fit has not converged or the confidence is not in (0,
/// 1)
[[nodiscard]] core::Interval profile_interval(const Fit& fit, std::span<const Observation> data,
                                              Quantity q, double confidence = 0.95);

} // namespace fragility
