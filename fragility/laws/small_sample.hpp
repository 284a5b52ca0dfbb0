#pragma once
/// Confidences with which large-sample intervals hold in small samples.

namespace fragility {

/// The confidence whose normal quantile is Student's quantile of `confidence`.
/// @param degrees of freedom; below 1: 1
/// @param confidence in (0, 1)
[[nodiscard]] double small_sample(double confidence, double degrees);

/// The confidence of a profile likelihood interval that is exact for the mean of `n` normal
/// values: its chi^2 quantile is n ln(1 + t^2 / (n - 1)), t Student's with n - 1 degrees of
/// freedom.
/// @param n values that were observed; below 2: 2
/// @param confidence in (0, 1)
[[nodiscard]] double small_sample_profile(double confidence, double n);

} // namespace fragility
