#pragma once
/// The normal and Student's quantiles that the results of fragility/ are pinned to. They differ
/// from core/normal.hpp and core/critical.hpp in the last digit alone: by Boost's inverse error
/// function in place of AS 241, from the upper end 0.5 + 0.5 confidence in place of the tail.
/// A revision that moves results may drop them.

namespace core {

/// x with Phi(x) = p. @param p in (0, 1)
[[nodiscard]] double normal_quantile_by_erf(double p);

/// Half width in standard errors under the normal distribution: 1.96 for 0.95.
/// @throws std::invalid_argument if `confidence` is not in (0, 1)
[[nodiscard]] double fit_normal_factor(double confidence);

/// The same under Student's. @param freedom > 0
[[nodiscard]] double fit_student_factor(double confidence, double freedom);

} // namespace core
